#include "child.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <signal.h>
#include <sys/mman.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <fstream>
#include <new>

#include "hwffd/error.hpp"

#ifdef HWFFD_COVERAGE
extern "C" {
#include <gcov.h>
}
#endif

namespace hwffd {
namespace {

/// How the work ended: the first byte that the child hands over, written last. Its exit status may
/// be lost, to a program that ignores SIGCHLD.
enum class Ending : char {
  kNone,     ///< the child is gone before the end
  kDone,     ///< the other bytes are the result
  kRefused,  ///< they are the text of an Error
  kNoMemory,
};

#ifdef __SANITIZE_ADDRESS__
constexpr bool kMapsTerabytes = true;  // which it does not use
#else
constexpr bool kMapsTerabytes = false;
#endif

constexpr unsigned kClockSeconds = 6;  // on the clock, per second of processor time allowed

/// A nameless file in memory, which both processes have open.
class SharedFile {
 public:
  SharedFile() : descriptor_(::memfd_create("hwffd", MFD_CLOEXEC)) {
    if (descriptor_ < 0) throw Error(fmt::format("cannot share memory: {}", std::strerror(errno)));
  }
  SharedFile(const SharedFile&) = delete;
  SharedFile& operator=(const SharedFile&) = delete;
  ~SharedFile() { ::close(descriptor_); }

  /// @return false if that cannot be
  bool write(const std::string& bytes, off_t offset) const {
    for (std::size_t done = 0; done < bytes.size();) {
      const ssize_t n = ::pwrite(descriptor_, bytes.data() + done, bytes.size() - done,
                                 offset + static_cast<off_t>(done));
      if (n < 0 && errno == EINTR) continue;
      if (n <= 0) return false;
      done += static_cast<std::size_t>(n);
    }
    return true;
  }

  std::string read(off_t offset) const {
    const off_t size = ::lseek(descriptor_, 0, SEEK_END) - offset;
    std::string bytes(size > 0 ? static_cast<std::size_t>(size) : 0, '\0');
    for (std::size_t done = 0; done < bytes.size();) {
      const ssize_t n = ::pread(descriptor_, bytes.data() + done, bytes.size() - done,
                                offset + static_cast<off_t>(done));
      if (n < 0 && errno == EINTR) continue;
      if (n <= 0) throw ChildFailure("its result cannot be read");
      done += static_cast<std::size_t>(n);
    }
    return bytes;
  }

  void end(Ending ending) const { write(std::string(1, static_cast<char>(ending)), 0); }

  Ending ending() const {
    char byte = 0;
    return ::pread(descriptor_, &byte, 1, 0) == 1 ? static_cast<Ending>(byte) : Ending::kNone;
  }

 private:
  int descriptor_;
};

/// Bytes of address space that this process has.
std::uint64_t address_space() {
  std::uint64_t pages = 0;
  std::ifstream("/proc/self/statm") >> pages;
  return pages * static_cast<std::uint64_t>(::sysconf(_SC_PAGESIZE));
}

void limit(int resource, std::uint64_t value, std::uint64_t grace = 0) {
  const rlimit both{static_cast<rlim_t>(value), static_cast<rlim_t>(value + grace)};
  ::setrlimit(static_cast<__rlimit_resource>(resource), &both);  // a lower one may hold already
}

/// The caller's handlers are not for the child, which ends on every signal, silently.
void make_mortal(const ChildLimits& limits) {
  ::prctl(PR_SET_PDEATHSIG, SIGKILL);
  for (const int number : {SIGSEGV, SIGBUS, SIGFPE, SIGILL, SIGABRT, SIGALRM, SIGXCPU, SIGINT,
                           SIGTERM, SIGHUP, SIGQUIT, SIGPIPE}) {
    ::signal(number, SIG_DFL);
  }
  sigset_t none;
  ::sigemptyset(&none);
  ::sigprocmask(SIG_SETMASK, &none, nullptr);
  const int nowhere = ::open("/dev/null", O_RDWR | O_CLOEXEC);
  for (const int stream : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO}) ::dup2(nowhere, stream);
  limit(RLIMIT_CORE, 0);
  limit(RLIMIT_CPU, limits.seconds, 1);  // a signal with a name, before the one without
  if (!kMapsTerabytes) limit(RLIMIT_AS, address_space() + limits.bytes);
  ::alarm(limits.seconds * kClockSeconds);
}

/// What the child does instead of returning.
[[noreturn]] void be_child(const std::function<std::string()>& work, const ChildLimits& limits,
                           const SharedFile& result) {
  try {
    make_mortal(limits);
    if (result.write(work(), 1)) result.end(Ending::kDone);
  } catch (const std::bad_alloc&) {
    result.end(Ending::kNoMemory);
  } catch (const std::exception& error) {
    if (result.write(error.what(), 1)) result.end(Ending::kRefused);
  }
#ifdef HWFFD_COVERAGE
  __gcov_dump();  // what this process ran counts, too
#endif
  ::_exit(0);  // nothing of the caller's is flushed or destroyed twice
}

/// How the child ended; -1 where the caller has children waited for elsewhere.
int wait_for(pid_t child) {
  int status = 0;
  while (::waitpid(child, &status, 0) < 0) {
    if (errno != EINTR) return -1;
  }
  return status;
}

}  // namespace

std::string run_in_child(const std::function<std::string()>& work, const ChildLimits& limits) {
  const SharedFile result;
  const pid_t child = ::fork();
  if (child < 0) throw Error(fmt::format("cannot start a process: {}", std::strerror(errno)));
  if (child == 0) be_child(work, limits, result);
  const int status = wait_for(child);
  switch (result.ending()) {
    case Ending::kDone:
      return result.read(1);
    case Ending::kRefused:
      throw Error(result.read(1));
    case Ending::kNoMemory:
      throw ChildFailure(
          fmt::format("its reader needs more than {} MB of memory", limits.bytes >> 20));
    case Ending::kNone:
      break;
  }
  const int number = status >= 0 && WIFSIGNALED(status) ? WTERMSIG(status) : 0;
  if (number == SIGXCPU || number == SIGALRM) {
    throw ChildFailure(fmt::format("its reader does not end in {} s", limits.seconds));
  }
  throw ChildFailure(
      fmt::format("its reader crashed: {}", number == 0 ? "cause unknown" : ::strsignal(number)));
}

}  // namespace hwffd
