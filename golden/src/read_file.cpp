#include "read_file.hpp"

#include <fmt/format.h>

#include <fstream>
#include <iterator>

#include "hwffd/error.hpp"

namespace hwffd {

std::string read_file(const std::filesystem::path& path) {
  try {
    std::ifstream in;
    in.exceptions(std::ios::failbit | std::ios::badbit);
    in.open(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(in), {}};
  } catch (const std::ios::failure&) {  // also of a folder, which opens but cannot be read
    throw Error(
        fmt::format("{}: cannot read; check that the file exists and is readable", path.string()));
  }
}

}  // namespace hwffd
