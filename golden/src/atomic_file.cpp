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

void write_temporary(const fs::path& temporary, const FileContent& file) {
  const int descriptor =
      ::open(temporary.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_NOFOLLOW | O_CLOEXEC, 0666);
  if (descriptor < 0) fail(file.path, errno);
  const int write_error = write_all(descriptor, file.bytes) ? 0 : errno;
  const int close_error = ::close(descriptor) == 0 ? 0 : errno;
  if (write_error != 0) fail(file.path, write_error);
  if (close_error != 0) fail(file.path, close_error);
}

}  // namespace

void write_files(const std::vector<FileContent>& files) {
  Temporaries temporaries;
  for (const FileContent& file : files) {
    std::error_code ignored;
    if (fs::is_directory(file.path, ignored)) fail(file.path, EISDIR);
    const std::string name = fmt::format(".{}.{}.tmp", file.path.filename().string(), ::getpid());
    write_temporary(temporaries.add(file.path.parent_path() / name), file);
  }
  for (std::size_t i = 0; i < files.size(); ++i) {
    std::error_code error;
    fs::rename(temporaries[i], files[i].path, error);
    if (error) fail(files[i].path, error.value());
  }
}

}  // namespace hwffd
