// A serial line, and boards behind one that do not speak as hwffd's do. The line is a pseudo
// terminal.
#include "device/serial_line.hpp"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <poll.h>
#include <stdlib.h>
#include <unistd.h>

#include <atomic>
#include <numeric>
#include <thread>

#include "device/serial_stream.hpp"
#include "errors.hpp"
#include "hwffd/error.hpp"
#include "temp_folder.hpp"

namespace hwffd {
namespace {

using Bytes = std::vector<std::uint8_t>;

constexpr SerialLine::Milliseconds kSoon(50), kLater(20'000);

/// The other end of a line.
class FarEnd {
 public:
  FarEnd() : file_(posix_openpt(O_RDWR | O_NOCTTY | O_NONBLOCK | O_CLOEXEC)) {
    EXPECT_EQ(grantpt(file_), 0);
    EXPECT_EQ(unlockpt(file_), 0);
    path = ptsname(file_);
  }
  ~FarEnd() { close_it(); }
  FarEnd(const FarEnd&) = delete;
  FarEnd& operator=(const FarEnd&) = delete;

  void close_it() {
    if (file_ >= 0) close(file_);
    file_ = -1;
  }
  /// What is there within some time.
  Bytes take(std::size_t most, int milliseconds) const {
    pollfd waited{file_, POLLIN, 0};
    if (poll(&waited, 1, milliseconds) <= 0) return {};
    Bytes bytes(most);
    const ssize_t got = read(file_, bytes.data(), most);
    bytes.resize(got > 0 ? static_cast<std::size_t>(got) : 0);
    return bytes;
  }
  /// As many of them as the line has room for.
  std::size_t give(const Bytes& bytes) const {
    const ssize_t gone = write(file_, bytes.data(), bytes.size());
    return gone > 0 ? static_cast<std::size_t>(gone) : 0;
  }

  std::string path;

 private:
  int file_;
};

Bytes every_byte() {
  Bytes bytes(256);
  std::iota(bytes.begin(), bytes.end(), 0);
  return bytes;
}

TEST(SerialLine, CarriesEveryByteAsItIs) {
  const FarEnd far;
  SerialLine line("serial:x", far.path);
  line.write(every_byte(), kLater);
  Bytes came;
  while (came.size() < 256) {
    const Bytes more = far.take(1000, 20'000);
    ASSERT_FALSE(more.empty());
    came.insert(came.end(), more.begin(), more.end());
  }
  EXPECT_EQ(came, every_byte());
  ASSERT_EQ(far.give(every_byte()), 256U);
  came.clear();
  while (came.size() < 256) {
    const Bytes more = line.read(100, kLater);
    ASSERT_FALSE(more.empty());
    ASSERT_LE(more.size(), 100U);
    came.insert(came.end(), more.begin(), more.end());
  }
  EXPECT_EQ(came, every_byte());
  EXPECT_EQ(line.read(100, kSoon), Bytes());
}

TEST(SerialLine, ThatIsFullOrClosedSaysWhatToDo) {
  FarEnd far;
  SerialLine line("serial:x", far.path);
  EXPECT_ERROR(line.write(Bytes(1 << 20), kSoon),
               "serial:x: takes no byte any more; see to its cable, and start again");
  far.close_it();
  const char* const closed = "serial:x: the line was closed; see to its cable, and start again";
  EXPECT_ERROR(line.write(every_byte(), kLater), closed);
  EXPECT_ERROR(line.read(100, kLater), closed);
}

TEST(SerialLine, IsOneProgramsAlone) {
  const FarEnd far;
  for (int program = 0; program < 2; ++program) {
    const SerialLine line("serial:x", far.path);
    EXPECT_ERROR(SerialLine("serial:y", far.path), "serial:y: another program uses it");
  }
}

TEST(SerialLine, PathsThatAreNoLineAreRefused) {
  const TempFolder folder;
  EXPECT_ERROR(SerialLine("serial:x", folder.write("x", "text")), "serial:x: is no serial line");
  EXPECT_ERROR(SerialLine("serial:y", folder / "y"),
               "serial:y: cannot be opened: No such file or directory");
}

/// Something at the end of a line that sends one byte again and again, all the time or as soon as
/// it hears something.
class Chatterer {
 public:
  Chatterer(std::uint8_t byte, bool when_asked)
      : thread_([this, byte, when_asked] {
          bool speaks = !when_asked;
          while (!ended_) {
            if (!far_.take(4096, 1).empty()) speaks = true;
            if (speaks) far_.give(Bytes(512, byte));
          }
        }) {}
  ~Chatterer() {
    ended_ = true;
    thread_.join();
  }
  Chatterer(const Chatterer&) = delete;
  Chatterer& operator=(const Chatterer&) = delete;

  const std::string& path() const { return far_.path; }

 private:
  FarEnd far_;
  std::atomic<bool> ended_{false};
  std::thread thread_;
};

/// How the stream of a board there is refused, behind the name of its line.
std::string refused_board(const std::string& path) {
  const std::string text =
      message_of<Error>([&] { serial_stream(path, find_configuration(kSerialRow), kLater); });
  const std::string name = "serial:" + path + ": ";
  EXPECT_EQ(text.substr(0, name.size()), name);
  return text.substr(name.size());
}

TEST(SerialStream, WhatSpeaksUnaskedIsNoBoard) {
  const Chatterer unasked('U', false);
  EXPECT_EQ(refused_board(unasked.path()),
            "sends bytes that nobody asked for; is it a board with hwffd?");
}

// The last of 32 results ends its packet, and no other.
TEST(SerialStream, ResultsOutOfStepAreRefused) {
  const Chatterer never_ends(0x00, true);
  EXPECT_EQ(refused_board(never_ends.path()), "result 31 is out of step; start again");
  const Chatterer always_ends(0xFF, true);
  EXPECT_EQ(refused_board(always_ends.path()), "result 0 is out of step; start again");
}

}  // namespace
}  // namespace hwffd
