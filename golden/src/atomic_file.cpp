#include "hwffd/atomic_file.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <system_error>

#include "hwffd/error.hpp"

namespace hwffd {
namespace {

namespace fs = std::filesystem;

[[noreturn]] void fail(const fs::path& target, int error_number) {
  throw Error(
      fmt::format("{}: cannot write: {}; check that the folder exists, is writable and "
                  "has room",
                  target.string(), std::strerror(error_number)));
}

/// Removes, when it goes out of scope, whatever was not renamed.
class Temporaries {
 public:
  Temporaries() = default;
  Temporaries(const Temporaries&) = delete;
  Temporaries& operator=(const Temporaries&) = delete;
  ~Temporaries() {
    std::error_code ignored;
    for (const fs::path& path : paths_) fs::remove(path, ignored);
  }
  const fs::path& add(fs::path path) { return paths_.emplace_back(std::move(path)); }
  const fs::path& operator[](std::size_t i) const { return paths_[i]; }

 private:
  std::vector<fs::path> paths_;
};

bool write_all(int descriptor, const std::string& bytes) {
  std::size_t done = 0;
  while (done < bytes.size()) {
    const ssize_t n = ::write(descriptor, bytes.data() + done, bytes.size() - done);
    if (n < 0 && errno == EINTR) continue;
    if (n <= 0) return false;
    done += static_cast<std::size_t>(n);
  }
  return true;
}

/// Opens and writes, with these flags.
void write_to(const fs::path& path, int flags, const FileContent& file) {
  const int descriptor = ::open(path.c_str(), O_WRONLY | O_CLOEXEC | flags, 0666);
  if (descriptor < 0) fail(file.path, errno);
  const int write_error = write_all(descriptor, file.bytes) ? 0 : errno;
  const int close_error = ::close(descriptor) == 0 ? 0 : errno;
  if (write_error != 0) fail(file.path, write_error);
  if (close_error != 0) fail(file.path, close_error);
}

/// A device or pipe has no contents to keep, and a file in its place would be none of its kind.
bool is_device(const fs::path& path) {
  std::error_code ignored;
  return fs::is_other(path, ignored);
}

/// Where a link leads, so that it stays a link; else the path itself.
fs::path followed(const fs::path& path) {
  std::error_code error;
  const fs::path target = fs::canonical(path, error);
  return error ? path : target;
}

}  // namespace

void write_files(const std::vector<FileContent>& files) {
  Temporaries temporaries;
  std::vector<fs::path> targets;
  for (const FileContent& file : files) {
    std::error_code ignored;
    if (fs::is_directory(file.path, ignored)) fail(file.path, EISDIR);
    if (is_device(file.path)) continue;
    const fs::path& target = targets.emplace_back(followed(file.path));
    const std::string name = fmt::format(".{}.{}.tmp", target.filename().string(), ::getpid());
    write_to(temporaries.add(target.parent_path() / name), O_CREAT | O_TRUNC | O_NOFOLLOW, file);
  }
  for (const FileContent& file : files) {
    if (is_device(file.path)) write_to(file.path, 0, file);
  }
  for (std::size_t i = 0; i < targets.size(); ++i) {
    std::error_code error;
    fs::rename(temporaries[i], targets[i], error);
    if (error) fail(targets[i], error.value());
  }
}

}  // namespace hwffd
