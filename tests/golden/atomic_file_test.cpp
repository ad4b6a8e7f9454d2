#include "hwffd/atomic_file.hpp"

#include <gtest/gtest.h>
#include <signal.h>
#include <sys/resource.h>

#include "temp_folder.hpp"

namespace hwffd {
namespace {

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

TEST(AtomicFile, WritesAllFilesAndNothingElse) {
  const TempFolder folder;
  const std::string binary("a\0b\n", 4);
  write_files({{folder / "one", binary}, {folder / "two", ""}});
  EXPECT_EQ(read_text(folder / "one"), binary);
  EXPECT_EQ(read_text(folder / "two"), "");
  EXPECT_EQ(folder.files(), (std::set<std::string>{"one", "two"}));
}

TEST(AtomicFile, ReplacesOlderFiles) {
  const TempFolder folder;
  folder.write("one", "a much longer older text");
  write_files({{folder / "one", "new"}});
  EXPECT_EQ(read_text(folder / "one"), "new");
  EXPECT_EQ(folder.files(), (std::set<std::string>{"one"}));
}

/// The second file fails for want of room after the first was complete: neither changes.
TEST(AtomicFile, FullDiskChangesNothing) {
  const TempFolder folder;
  folder.write("one", "old one");
  folder.write("two", "old two");
  const std::string text = [&] {
    const FileSizeLimit limit(1000);
    return message_of<Error>([&] {
      write_files({{folder / "one", "new"}, {folder / "two", std::string(5000, 'x')}});
    });
  }();
  expect_part(text, (folder / "two").string() + ": cannot write: File too large; check that");
  EXPECT_EQ(read_text(folder / "one"), "old one");
  EXPECT_EQ(read_text(folder / "two"), "old two");
  EXPECT_EQ(folder.files(), (std::set<std::string>{"one", "two"}));
}

TEST(AtomicFile, MissingFolderAndFolderAsTarget) {
  const TempFolder folder;
  EXPECT_EQ(message_of<Error>([&] {
              write_files({{folder / "no/one", "new"}});
            }),
            (folder / "no/one").string() +
                ": cannot write: No such file or directory; check that "
                "the folder exists, is writable and has room");
  std::filesystem::create_directory(folder / "two");
  expect_part(message_of<Error>([&] {
                write_files({{folder / "one", "new"}, {folder / "two", "new"}});
              }),
              (folder / "two").string() + ": cannot write: Is a directory");
  EXPECT_EQ(folder.files(), (std::set<std::string>{"two"}));
}

}  // namespace
}  // namespace hwffd
