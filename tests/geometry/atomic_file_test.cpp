#include "hwffd/atomic_file.hpp"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <signal.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>

#include "errors.hpp"
#include "temp_folder.hpp"
#include "unprivileged.hpp"

namespace hwffd {
namespace {

using Texts = std::map<std::string, std::string>;

class AtomicFile : public testing::Test {
 protected:
  const TempFolder folder;
};

/// While it lives, files cannot grow beyond a limit: a full disk, in effect.
class FileSizeLimit {
 public:
  explicit FileSizeLimit(rlim_t bytes) {
    old_handler_ = ::signal(SIGXFSZ, SIG_IGN);
    ::getrlimit(RLIMIT_FSIZE, &old_limit_);
    const rlimit limit{bytes, old_limit_.rlim_max};
    ::setrlimit(RLIMIT_FSIZE, &limit);
  }
  FileSizeLimit(const FileSizeLimit&) = delete;
  FileSizeLimit& operator=(const FileSizeLimit&) = delete;
  ~FileSizeLimit() {
    ::setrlimit(RLIMIT_FSIZE, &old_limit_);
    ::signal(SIGXFSZ, old_handler_);
  }

 private:
  rlimit old_limit_{};
  void (*old_handler_)(int) = SIG_DFL;
};

TEST_F(AtomicFile, WritesAllFilesAndNothingElse) {
  const std::string binary("a\0b\n", 4);
  write_files({{folder / "one", binary}, {folder / "two", ""}});
  EXPECT_EQ(folder.texts(), (Texts{{"one", binary}, {"two", ""}}));
}

TEST_F(AtomicFile, ReplacesOlderFiles) {
  folder.write("one", "a much longer older text");
  write_files({{folder / "one", "new"}});
  EXPECT_EQ(folder.texts(), (Texts{{"one", "new"}}));
}

/// What is open, under each of its names, is written on: it may be a file that holds something.
TEST_F(AtomicFile, DescriptorsAreWrittenOn) {
  const auto path = folder.write("log", "precious\n");
  const int descriptor = ::open(path.c_str(), O_WRONLY | O_APPEND);
  ASSERT_GE(descriptor, 0);
  const std::string number = std::to_string(descriptor);
  std::filesystem::create_symlink("/dev/fd/" + number, folder / "link");
  std::filesystem::create_symlink("link", folder / "link to a link");
  const std::vector<std::string> names{"/dev/fd/" + number, "/proc/self/fd/" + number,
                                       (folder / "link").string(),
                                       (folder / "link to a link").string()};
  std::string wanted = "precious\n";
  for (const std::string& name : names) {
    check_writable(name);
    write_files({{name, name + "\n"}});
    wanted += name + "\n";
    EXPECT_EQ(read_text(path), wanted);
  }
  ::close(descriptor);
  const int reader = ::open(path.c_str(), O_RDONLY);
  EXPECT_ERROR_PART(check_writable("/dev/fd/" + std::to_string(reader)), "Bad file descriptor");
  ::close(reader);
  EXPECT_EQ(folder.files(), (std::set<std::string>{"link", "link to a link", "log"}));
}

/// The second file fails for want of room after the first was complete: neither changes.
TEST_F(AtomicFile, FullDiskChangesNothing) {
  folder.write("one", "old one");
  folder.write("two", "old two");
  const std::string text = [&] {
    const FileSizeLimit limit(1000);
    return message_of<Error>([&] {
      write_files({{folder / "one", "new"}, {folder / "two", std::string(5000, 'x')}});
    });
  }();
  expect_part(text, (folder / "two").string() + ": cannot write: File too large; check that");
  EXPECT_EQ(folder.texts(), (Texts{{"one", "old one"}, {"two", "old two"}}));
}

TEST_F(AtomicFile, MissingFolderAndFolderAsTarget) {
  EXPECT_ERROR(write_files({{folder / "no/one", "new"}}),
               (folder / "no/one").string() +
                   ": cannot write: No such file or directory; check that "
                   "the folder exists, is writable and has room");
  std::filesystem::create_directory(folder / "two");
  EXPECT_ERROR_PART(write_files({{folder / "one", "new"}, {folder / "two", "new"}}),
                    (folder / "two").string() + ": cannot write: Is a directory");
  EXPECT_EQ(folder.files(), (std::set<std::string>{"two"}));
}

/// A device takes bytes and stays one. It is reached over a link, which a rename would replace.
TEST_F(AtomicFile, DeviceIsWrittenNotReplaced) {
  folder.write("one", "old one");
  std::filesystem::create_symlink("/dev/null", folder / "null");
  write_files({{folder / "one", "new one"}, {folder / "null", "gone"}});
  EXPECT_EQ(read_text(folder / "one"), "new one");
  EXPECT_TRUE(std::filesystem::is_character_file(folder / "null"));
  EXPECT_EQ(folder.files(), (std::set<std::string>{"null", "one"}));
}

/// /dev/full has no room, whatever its permissions: the file beside it is not touched.
TEST_F(AtomicFile, FullDeviceChangesNothing) {
  folder.write("one", "old one");
  std::filesystem::create_symlink("/dev/full", folder / "full");
  EXPECT_ERROR(write_files({{folder / "one", "new one"}, {folder / "full", "lost"}}),
               (folder / "full").string() +
                   ": cannot write: No space left on device; check that the folder exists, is "
                   "writable and has room");
  EXPECT_EQ(read_text(folder / "one"), "old one");
  EXPECT_TRUE(std::filesystem::is_character_file(folder / "full"));
  EXPECT_EQ(folder.files(), (std::set<std::string>{"full", "one"}));
}

TEST_F(AtomicFile, LinkStaysALink) {
  folder.write("one", "old one");
  std::filesystem::create_symlink("one", folder / "link");
  write_files({{folder / "link", "new one"}});
  EXPECT_TRUE(std::filesystem::is_symlink(folder / "link"));
  EXPECT_EQ(folder.texts(), (Texts{{"link", "new one"}, {"one", "new one"}}));
}

TEST_F(AtomicFile, LinkToNowhereCreatesWhereItLeads) {
  std::filesystem::create_directory(folder / "far");
  std::filesystem::create_symlink("far/one", folder / "link");
  write_files({{folder / "link", "new one"}});
  EXPECT_TRUE(std::filesystem::is_symlink(folder / "link"));
  EXPECT_EQ(read_text(folder / "far/one"), "new one");
  std::filesystem::create_symlink("loop", folder / "loop");
  EXPECT_ERROR_PART(
      write_files({{folder / "loop", "new"}}),
      (folder / "loop").string() + ": cannot write: Too many levels of symbolic links");
  EXPECT_TRUE(std::filesystem::is_symlink(folder / "loop"));
}

/// Files with names as long as file systems take.
TEST_F(AtomicFile, LongestName) {
  const std::string name(255, 'n');
  write_files({{folder / name, "new"}});
  EXPECT_EQ(folder.files(), (std::set<std::string>{name}));
}

mode_t mode_of(const std::filesystem::path& path) {
  struct stat status {};
  EXPECT_EQ(::stat(path.c_str(), &status), 0) << path;
  return status.st_mode & 07777;
}

TEST_F(AtomicFile, ReplacedFileKeepsItsMode) {
  const mode_t old_mask = ::umask(027);
  for (const mode_t mode : {0600, 0644, 0666, 0755}) {
    folder.write("old", "old");
    ASSERT_EQ(::chmod((folder / "old").c_str(), mode), 0);
    write_files({{folder / "old", "replaced"}});
    EXPECT_EQ(mode_of(folder / "old"), mode);
    EXPECT_EQ(read_text(folder / "old"), "replaced");
  }
  write_files({{folder / "new", ""}});
  EXPECT_EQ(mode_of(folder / "new"), 0640u);
  ::umask(old_mask);
}

/// Whoever took the right to write from a file meant it, be it root who asks.
TEST_F(AtomicFile, ReadOnlyFileIsRefused) {
  folder.write("one", "old one");
  folder.write("two", "old two");
  ASSERT_EQ(::chmod((folder / "two").c_str(), 0444), 0);
  const std::string refused =
      (folder / "two").string() + ": is read-only; make it writable or choose another name";
  EXPECT_ERROR(write_files({{folder / "one", "new"}, {folder / "two", "new"}}), refused);
  EXPECT_ERROR(check_writable(folder / "two"), refused);
  EXPECT_EQ(folder.texts(), (Texts{{"one", "old one"}, {"two", "old two"}}));
}

TEST_F(AtomicFile, PlacesAreCheckedBeforeTheWork) {
  folder.write("one", "old one");
  check_writable(folder / "one");
  check_writable(folder / "new");
  check_writable("/dev/full");
  EXPECT_ERROR_PART(check_writable(folder / "no/one"),
                    "no/one: cannot write: No such file or directory");
  EXPECT_ERROR_PART(check_writable(folder / ""), ": cannot write: Is a directory");
  EXPECT_EQ(folder.files(), (std::set<std::string>{"one"}));
}

/// Files that somebody laid where a temporary was to be expected keep what they hold.
TEST_F(AtomicFile, TemporaryIsNobodyElses) {
  folder.write("victim", "precious");
  const std::string expected = ".one." + std::to_string(::getpid()) + ".tmp";
  std::filesystem::create_hard_link(folder / "victim", folder / expected);
  write_files({{folder / "one", "new one"}});
  EXPECT_EQ(folder.texts(),
            (Texts{{"one", "new one"}, {"victim", "precious"}, {expected, "precious"}}));
}

/// A child process that writes two files, and then waits for its end. Who runs the tests in the
/// background of a shell has them ignore SIGINT; this process does not.
pid_t start_writing(const TempFolder& folder, const std::string& bytes) {
  const pid_t child = ::fork();
  if (child != 0) return child;
  for (const int signal : {SIGINT, SIGTERM, SIGHUP, SIGQUIT}) ::signal(signal, SIG_DFL);
  write_files({{folder / "one", bytes}, {folder / "two", bytes}});
  for (;;) ::pause();
}

/// A signal in the middle of writing: no temporary is left, and both files are whole.
TEST_F(AtomicFile, SignalsWaitUntilAllIsWritten) {
  const std::string bytes(std::size_t{1} << 25, 'x');
  for (const int signal : {SIGINT, SIGTERM, SIGHUP, SIGQUIT}) {
    const TempFolder each;
    const pid_t child = start_writing(each, bytes);
    ASSERT_GT(child, 0);
    const auto patience = std::chrono::steady_clock::now() + std::chrono::seconds(60);
    while (each.files().empty() && std::chrono::steady_clock::now() < patience) ::usleep(100);
    ::kill(child, signal);
    int status = 0;
    ASSERT_EQ(::waitpid(child, &status, 0), child);
    EXPECT_TRUE(WIFSIGNALED(status) && WTERMSIG(status) == signal) << status;
    EXPECT_EQ(each.files(), (std::set<std::string>{"one", "two"})) << ::strsignal(signal);
    EXPECT_EQ(read_text(each / "two").size(), bytes.size());
  }
}

TEST_F(AtomicFile, ReadOnlyFolder) {
  folder.write("one", "old one");
  folder.open_to_all();
  std::filesystem::permissions(folder / "", std::filesystem::perms(0555));
  const Unprivileged nobody;
  if (!nobody.effective()) GTEST_SKIP() << "permissions do not hold for this user";
  EXPECT_ERROR_PART(write_files({{folder / "one", "new one"}}),
                    (folder / "one").string() + ": cannot write: Permission denied; check that");
  EXPECT_EQ(folder.texts(), (Texts{{"one", "old one"}}));
}

}  // namespace
}  // namespace hwffd
