#include "read_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <fstream>
#include <system_error>

#include "hwffd/error.hpp"

namespace hwffd {

namespace {

constexpr std::size_t kChunk = std::size_t{1} << 20;

/// As many bytes as there are; those beyond `most` are read to one chunk at most.
std::string read_bytes(const std::filesystem::path& path, std::size_t most) {
  std::ifstream in;
  in.exceptions(std::ios::failbit | std::ios::badbit);
  in.open(path, std::ios::binary);
  in.exceptions(std::ios::badbit);  // no longer of the end
  std::string bytes;
  std::error_code none;  // of what has no size, such as a pipe
  const std::uintmax_t size = std::filesystem::file_size(path, none);
  if (!none) bytes.reserve(std::min<std::uintmax_t>(size, most) + kChunk);
  while (in && bytes.size() <= most) {
    const std::size_t before = bytes.size();
    bytes.resize(before + kChunk);
    in.read(&bytes[before], kChunk);
    bytes.resize(before + static_cast<std::size_t>(in.gcount()));
  }
  return bytes;
}

}  // namespace

std::string read_file(const std::filesystem::path& path, std::size_t most) {
  try {
    std::string bytes = read_bytes(path, most);
    if (bytes.size() <= most) return bytes;
  } catch (const std::ios::failure&) {  // also of a folder, which opens but cannot be read
    throw Error(
        fmt::format("{}: cannot read; check that the file exists and is readable", path.string()));
  }
  throw Error(fmt::format("{}: more than {} bytes; is this the right file?", path.string(), most));
}

}  // namespace hwffd
