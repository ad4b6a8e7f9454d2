#include "hwffd/atomic_file.hpp"

#include <gtest/gtest.h>
#include <signal.h>
#include <sys/resource.h>

#include "temp_folder.hpp"
#include "unprivileged.hpp"

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

/// A device takes bytes and stays one. It is reached over a link, which a rename would replace.
TEST(AtomicFile, DeviceIsWrittenNotReplaced) {
  const TempFolder folder;
  folder.write("one", "old one");
  std::filesystem::create_symlink("/dev/null", folder / "null");
  write_files({{folder / "one", "new one"}, {folder / "null", "gone"}});
  EXPECT_EQ(read_text(folder / "one"), "new one");
  EXPECT_TRUE(std::filesystem::is_character_file(folder / "null"));
  EXPECT_EQ(folder.files(), (std::set<std::string>{"null", "one"}));
}

/// /dev/full has no room, whatever its permissions: the file beside it is not touched.
TEST(AtomicFile, FullDeviceChangesNothing) {
  const TempFolder folder;
  folder.write("one", "old one");
  std::filesystem::create_symlink("/dev/full", folder / "full");
  EXPECT_EQ(message_of<Error>([&] {
              write_files({{folder / "one", "new one"}, {folder / "full", "lost"}});
            }),
            (folder / "full").string() +
                ": cannot write: No space left on device; check that the folder exists, is "
                "writable and has room");
  EXPECT_EQ(read_text(folder / "one"), "old one");
  EXPECT_TRUE(std::filesystem::is_character_file(folder / "full"));
  EXPECT_EQ(folder.files(), (std::set<std::string>{"full", "one"}));
}

TEST(AtomicFile, LinkStaysALink) {
  const TempFolder folder;
  folder.write("one", "old one");
  std::filesystem::create_symlink("one", folder / "link");
  write_files({{folder / "link", "new one"}});
  EXPECT_TRUE(std::filesystem::is_symlink(folder / "link"));
  EXPECT_EQ(read_text(folder / "one"), "new one");
  EXPECT_EQ(folder.files(), (std::set<std::string>{"link", "one"}));
}

TEST(AtomicFile, ReadOnlyFolder) {
  const TempFolder folder;
  folder.write("one", "old one");
  folder.open_to_all();
  std::filesystem::permissions(folder / "", std::filesystem::perms(0555));
  const Unprivileged nobody;
  if (!nobody.effective()) GTEST_SKIP() << "permissions do not hold for this user";
  expect_part(message_of<Error>([&] {
                write_files({{folder / "one", "new one"}});
              }),
              (folder / "one").string() + ": cannot write: Permission denied; check that");
  EXPECT_EQ(read_text(folder / "one"), "old one");
  EXPECT_EQ(folder.files(), (std::set<std::string>{"one"}));
}

}  // namespace
}  // namespace hwffd
