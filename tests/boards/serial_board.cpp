// A board behind a pseudo terminal, simulated through its pins, for programs that want a serial
// line.
//
//     serial_board ulx3s|icebreaker|silent [BYTES]
//
// The first line of its output is the path of the line. It ends with its standard input, or closes
// the line, as a cable does that is pulled out, when so many bytes of results have gone there. Time
// stands still inside a frame until its next byte comes, but for 0.1 s, which is a pause.
#include <fcntl.h>
#include <poll.h>
#include <stdlib.h>
#include <termios.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cstdio>
#include <iostream>
#include <memory>
#include <string>
#include <vector>

#include "Vboard_icebreaker.h"
#include "Vboard_ulx3s.h"
#include "serial_host.hpp"

namespace hwffd::test {
namespace {

constexpr int kClocks = HWFFD_BOARD_CLOCKS;       // of a bit
constexpr int kPause = 1 << HWFFD_BOARD_PAUSE_W;  // clocks
constexpr int kSilence = 100;                     // milliseconds that make a pause
constexpr int kIdle = 8000;  // clocks without a byte, after which no result is under way

using Bytes = std::vector<std::uint8_t>;

/// What is at the other end of the line.
class Peer {
 public:
  virtual ~Peer() = default;
  virtual void send(std::uint8_t byte) = 0;
  virtual void idle(int clocks) = 0;
  virtual Bytes take() = 0;
};

class Silent final : public Peer {
 public:
  void send(std::uint8_t /*byte*/) override {}
  void idle(int /*clocks*/) override {}
  Bytes take() override { return {}; }
};

template <class Dut>
class Board final : public Peer {
 public:
  Board() : host_(1, kClocks) {}
  void send(std::uint8_t byte) override { host_.send(byte); }
  void idle(int clocks) override { host_.level(true, clocks); }
  Bytes take() override { return host_.take_bytes(); }

 private:
  SerialHost<Dut> host_;
};

/// Where in a frame the line is.
class Place {
 public:
  void byte(std::uint8_t value) {
    if (count_bytes_ < 2) {
      left_ += static_cast<std::size_t>(value) * (count_bytes_ == 0 ? 16 : 16 * 256);
      ++count_bytes_;
    } else {
      --left_;
    }
    if (count_bytes_ == 2 && left_ == 0) pause();
  }
  void pause() {
    count_bytes_ = 0;
    left_ = 0;
  }
  bool inside() const { return count_bytes_ > 0; }

 private:
  int count_bytes_ = 0;
  std::size_t left_ = 0;
};

/// The terminal's two ends; this one keeps that of the program, too, so that programs come and go.
struct Terminal {
  int here = posix_openpt(O_RDWR | O_NOCTTY);
  int there = -1;
  std::string path;

  Terminal() {
    if (here < 0 || grantpt(here) != 0 || unlockpt(here) != 0) return;
    path = ptsname(here);
    there = open(path.c_str(), O_RDWR | O_NOCTTY);
    termios settings{};
    tcgetattr(there, &settings);
    cfmakeraw(&settings);
    tcsetattr(there, TCSANOW, &settings);
  }
  ~Terminal() {
    close(there);
    close(here);
  }
  Terminal(const Terminal&) = delete;
  Terminal& operator=(const Terminal&) = delete;
};

/// @param most  bytes to the program, then the line is closed
int serve(Peer& peer, const Terminal& terminal, std::size_t most) {
  Place place;
  int quiet = kIdle;   // clocks without a byte
  bool paused = true;  // nothing came since
  std::size_t sent = 0;
  for (;;) {
    std::array<pollfd, 2> ends{{{terminal.here, POLLIN, 0}, {STDIN_FILENO, POLLIN, 0}}};
    const bool waits = place.inside() || quiet >= kIdle;
    poll(ends.data(), ends.size(), waits ? kSilence : 0);
    if (ends[1].revents != 0) return 0;
    if (ends[0].revents != 0) {
      std::array<std::uint8_t, 1024> bytes{};
      const ssize_t got = read(terminal.here, bytes.data(), bytes.size());
      if (got <= 0) return 1;
      for (ssize_t b = 0; b < got; ++b) {
        place.byte(bytes[static_cast<std::size_t>(b)]);
        peer.send(bytes[static_cast<std::size_t>(b)]);
      }
      quiet = 0;
      paused = false;
    } else if (waits && !paused) {
      peer.idle(kPause + 2 * kClocks);
      place.pause();
      paused = true;
    } else if (!waits) {
      peer.idle(10 * kClocks);
      quiet += 10 * kClocks;
    }
    Bytes bytes = peer.take();
    if (bytes.empty()) continue;
    quiet = 0;
    bytes.resize(std::min(bytes.size(), most - sent));
    for (std::size_t first = 0; first < bytes.size();) {
      const ssize_t gone = write(terminal.here, bytes.data() + first, bytes.size() - first);
      if (gone <= 0) return 1;
      first += static_cast<std::size_t>(gone);
    }
    sent += bytes.size();
    if (sent == most) return 0;
  }
}

std::unique_ptr<Peer> peer_of(const std::string& name) {
  if (name == "ulx3s") return std::make_unique<Board<Vboard_ulx3s>>();
  if (name == "icebreaker") return std::make_unique<Board<Vboard_icebreaker>>();
  return std::make_unique<Silent>();
}

int run(int argc, char** argv) {
  const std::unique_ptr<Peer> peer = peer_of(argc > 1 ? argv[1] : "");
  const Terminal terminal;
  if (terminal.there < 0) return 1;
  std::cout << terminal.path << std::endl;
  return serve(*peer, terminal, argc > 2 ? std::stoul(argv[2]) : ~std::size_t{0});
}

}  // namespace
}  // namespace hwffd::test

int main(int argc, char** argv) { return hwffd::test::run(argc, argv); }
