#include "hwffd/atomic_file.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <signal.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <charconv>
#include <cstring>
#include <optional>
#include <random>
#include <system_error>

#include "hwffd/error.hpp"

namespace hwffd {
namespace {

namespace fs = std::filesystem;

constexpr mode_t kAnyWrite = S_IWUSR | S_IWGRP | S_IWOTH;
constexpr mode_t kPermissions = S_IRWXU | S_IRWXG | S_IRWXO;
constexpr mode_t kNewFile = 0666;  // less the user's mask
constexpr int kMostLinks = 40;

[[noreturn]] void fail(const fs::path& target, int error_number) {
  throw Error(
      fmt::format("{}: cannot write: {}; check that the folder exists, is writable and "
                  "has room",
                  target.string(), std::strerror(error_number)));
}

/// While it lives, signals that end a program wait, so that files are all there or none.
class SignalsWait {
 public:
  SignalsWait() {
    sigset_t ending;
    ::sigemptyset(&ending);
    for (const int signal : {SIGINT, SIGTERM, SIGHUP, SIGQUIT, SIGXFSZ}) {
      ::sigaddset(&ending, signal);
    }
    ::pthread_sigmask(SIG_BLOCK, &ending, &before_);
  }
  SignalsWait(const SignalsWait&) = delete;
  SignalsWait& operator=(const SignalsWait&) = delete;
  ~SignalsWait() { ::pthread_sigmask(SIG_SETMASK, &before_, nullptr); }

 private:
  sigset_t before_{};
};

/// What is there under a name, links followed; nothing if nothing is.
std::optional<struct stat> status_of(const fs::path& path) {
  struct stat status {};
  if (::stat(path.c_str(), &status) != 0) return std::nullopt;
  return status;
}

/// A device or pipe has no contents to keep, and a file in its place would be none of its kind.
bool is_device(const fs::path& path) {
  std::error_code ignored;
  return fs::is_other(path, ignored);
}

/// The descriptor of this process that a name such as /dev/stdout, /dev/fd/3 or a link to one
/// stands for. What is behind it, be it a file, is written on and never replaced.
std::optional<int> descriptor_of(const fs::path& path) {
  std::error_code error;
  const fs::path descriptors = fs::canonical("/proc/self/fd", error);
  if (error) return std::nullopt;
  fs::path target = path;
  for (int links = 0; links < kMostLinks; ++links) {
    const fs::path folder = fs::canonical(fs::absolute(target).parent_path(), error);
    if (error) return std::nullopt;
    const std::string name = target.filename().string();
    int number = 0;
    const auto [end, failure] = std::from_chars(name.data(), name.data() + name.size(), number);
    if (folder == descriptors && failure == std::errc() && end == name.data() + name.size()) {
      return number;
    }
    const fs::path next = fs::read_symlink(target, error);
    if (error) return std::nullopt;
    target = target.parent_path() / next;
  }
  return std::nullopt;
}

/// Whether a file of this name is written as it stands, not replaced.
bool is_stream(const fs::path& path) { return is_device(path) || descriptor_of(path); }

/// Where a link leads, whether a file is there or not, so that it stays a link; else the path.
fs::path followed(const fs::path& path) {
  fs::path target = path;
  for (int links = 0; links < kMostLinks; ++links) {
    std::error_code error;
    const fs::path next = fs::read_symlink(target, error);
    if (error) return target;  // no link
    target = target.parent_path() / next;
  }
  fail(path, ELOOP);
}

fs::path folder_of(const fs::path& target) {
  return target.has_parent_path() ? target.parent_path() : fs::path(".");
}

/// A name that nobody can foresee, and that is not too long wherever the target's is not.
fs::path temporary_name(const fs::path& target) {
  std::random_device random;
  return folder_of(target) / fmt::format(".hwffd-{:08x}{:08x}.tmp", random(), random());
}

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

/// Writes the bytes and closes the descriptor.
void write_to(int descriptor, const FileContent& file) {
  if (descriptor < 0) fail(file.path, errno);
  const int write_error = write_all(descriptor, file.bytes) ? 0 : errno;
  const int close_error = ::close(descriptor) == 0 ? 0 : errno;
  if (write_error != 0) fail(file.path, write_error);
  if (close_error != 0) fail(file.path, close_error);
}

/// Gives a file the owner, as far as that is allowed, and the mode of the one that it will replace.
void take_after(int descriptor, const struct stat& old) {
  constexpr uid_t kSameUser = static_cast<uid_t>(-1);
  constexpr gid_t kSameGroup = static_cast<gid_t>(-1);
  const bool group_restored = ::fchown(descriptor, kSameUser, old.st_gid) == 0;
  const bool owner_restored = ::fchown(descriptor, old.st_uid, kSameGroup) == 0;
  static_cast<void>(owner_restored);
  // What one group was allowed is not for another.
  ::fchmod(descriptor, old.st_mode & (group_restored ? kPermissions : kPermissions & ~S_IRWXG));
}

/// Files beside their targets. It removes, when it goes out of scope, those that were not renamed.
class Temporaries {
 public:
  Temporaries() = default;
  Temporaries(const Temporaries&) = delete;
  Temporaries& operator=(const Temporaries&) = delete;
  ~Temporaries() {
    for (const Temporary& each : all_) ::unlink(each.name.c_str());
  }

  void write(const FileContent& file) {
    const fs::path target = followed(file.path);
    const std::optional<struct stat> old = status_of(target);
    const mode_t mode = old ? old->st_mode & kPermissions : kNewFile;
    const fs::path name = temporary_name(target);
    const int descriptor = ::open(name.c_str(), O_WRONLY | O_CLOEXEC | O_CREAT | O_EXCL, mode);
    if (descriptor < 0) fail(file.path, errno);
    all_.push_back({name, target});
    if (old) take_after(descriptor, *old);
    write_to(descriptor, file);
  }

  void rename_all() {
    while (!all_.empty()) {
      const Temporary& first = all_.front();
      if (::rename(first.name.c_str(), first.target.c_str()) != 0) fail(first.target, errno);
      all_.erase(all_.begin());
    }
  }

 private:
  struct Temporary {
    fs::path name;
    fs::path target;
  };
  std::vector<Temporary> all_;
};

}  // namespace

void check_writable(const fs::path& path) {
  std::error_code ignored;
  if (fs::is_directory(path, ignored)) fail(path, EISDIR);
  if (const auto descriptor = descriptor_of(path)) {
    const int flags = ::fcntl(*descriptor, F_GETFL);
    if (flags < 0 || (flags & O_ACCMODE) == O_RDONLY) fail(path, EBADF);
    return;
  }
  if (is_device(path)) return;
  const fs::path target = followed(path);
  if (::faccessat(AT_FDCWD, folder_of(target).c_str(), W_OK | X_OK, AT_EACCESS) != 0) {
    fail(path, errno);
  }
  if (const auto old = status_of(target)) {
    const bool writable = ::faccessat(AT_FDCWD, target.c_str(), W_OK, AT_EACCESS) == 0;
    if (!writable || (old->st_mode & kAnyWrite) == 0) {
      throw Error(
          fmt::format("{}: is read-only; make it writable or choose another name", path.string()));
    }
  }
}

void write_files(const std::vector<FileContent>& files) {
  for (const FileContent& file : files) check_writable(file.path);
  for (const FileContent& file : files) {
    if (const auto descriptor = descriptor_of(file.path)) {
      write_to(::fcntl(*descriptor, F_DUPFD_CLOEXEC, 0), file);
    } else if (is_device(file.path)) {
      write_to(::open(file.path.c_str(), O_WRONLY | O_CLOEXEC), file);
    }
  }
  const SignalsWait wait;
  Temporaries temporaries;
  for (const FileContent& file : files) {
    if (!is_stream(file.path)) temporaries.write(file);
  }
  temporaries.rename_all();
}

}  // namespace hwffd
