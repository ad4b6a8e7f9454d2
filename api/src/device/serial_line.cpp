#include "device/serial_line.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <poll.h>
#include <sys/file.h>
#include <termios.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>

#include "device/patient_poll.hpp"
#include "hwffd/error.hpp"

namespace hwffd {
namespace {

#ifdef B1000000
constexpr speed_t kSpeed = B1000000;  // baud of synth/boards/boards.csv
#else
constexpr speed_t kSpeed = 0;
#endif

std::string error_text() { return std::strerror(errno); }

/// Every byte as it is, both ways.
void set_up(int file, const std::string& name) {
  termios settings{};
  if (tcgetattr(file, &settings) != 0) {
    throw Error(fmt::format("{}: is no serial line", name));
  }
  cfmakeraw(&settings);
  settings.c_cflag &= ~static_cast<tcflag_t>(CSTOPB | CRTSCTS);
  settings.c_cflag |= CREAD | CLOCAL;
  settings.c_iflag &= ~static_cast<tcflag_t>(IXOFF | IXANY);
  if (kSpeed == 0 || cfsetspeed(&settings, kSpeed) != 0 ||
      tcsetattr(file, TCSANOW, &settings) != 0) {
    throw Error(fmt::format("{}: does not take 1,000,000 bits a second", name));
  }
}

}  // namespace

SerialLine::SerialLine(const std::string& name, const std::string& path)
    : name_(name), file_(open(path.c_str(), O_RDWR | O_NOCTTY | O_NONBLOCK | O_CLOEXEC)) {
  if (file_ < 0) throw Error(fmt::format("{}: cannot be opened: {}", name, error_text()));
  try {
    if (flock(file_, LOCK_EX | LOCK_NB) != 0) {
      throw Error(fmt::format("{}: another program uses it", name));
    }
    set_up(file_, name);
  } catch (const Error&) {
    close(file_);
    throw;
  }
}

SerialLine::~SerialLine() { close(file_); }

bool SerialLine::wait(short events, Milliseconds patience) const {
  const int ready = patient_poll(file_, events, patience);
  if (ready < 0) closed();
  return ready > 0;
}

void SerialLine::closed() const {
  throw Error(fmt::format("{}: the line was closed; see to its cable, and start again", name_));
}

void SerialLine::write(const std::vector<std::uint8_t>& bytes, Milliseconds patience) {
  for (std::size_t first = 0; first < bytes.size();) {
    const ssize_t sent = ::write(file_, bytes.data() + first, bytes.size() - first);
    if (sent > 0) {
      first += static_cast<std::size_t>(sent);
      continue;
    }
    if (sent < 0 && errno == EINTR) continue;
    if (sent < 0 && errno != EAGAIN && errno != EWOULDBLOCK) closed();
    if (!wait(POLLOUT, patience)) {
      throw Error(
          fmt::format("{}: takes no byte any more; see to its cable, and start again", name_));
    }
  }
}

std::vector<std::uint8_t> SerialLine::read(std::size_t most, Milliseconds patience) {
  std::vector<std::uint8_t> bytes(most);
  while (wait(POLLIN, patience)) {
    const ssize_t got = ::read(file_, bytes.data(), most);
    if (got > 0) {
      bytes.resize(static_cast<std::size_t>(got));
      return bytes;
    }
    if (got == 0) closed();  // poll said that there was something
    if (errno != EINTR && errno != EAGAIN && errno != EWOULDBLOCK) closed();
  }
  return {};
}

}  // namespace hwffd
