#include <fmt/format.h>
#include <sys/socket.h>
#include <sys/time.h>
#include <sys/un.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>

#include "device/core_access.hpp"
#include "hwffd/error.hpp"

namespace hwffd {
namespace {

constexpr std::time_t kAnswerSeconds =
    30;  // seconds for an answer, beyond what an interrupt may take

class SocketAccess final : public CoreAccess {
 public:
  explicit SocketAccess(const std::string& path) : name_("socket:" + path) {
    connect_to(path);
    set_patience(kAnswerSeconds);
    std::array<std::uint64_t, 2> place{};
    try {
      receive(place.data(), sizeof(place));
    } catch (const Error&) {
      close(socket_);
      throw;
    }
    address_ = place[0];
    bytes_ = place[1];
  }
  ~SocketAccess() override { close(socket_); }
  SocketAccess(const SocketAccess&) = delete;
  SocketAccess& operator=(const SocketAccess&) = delete;

  std::uint32_t read32(std::uint32_t offset) override {
    return ask<std::uint32_t>(CoreRequest{CoreRequest::kRead, offset, 0, {}});
  }
  void write32(std::uint32_t offset, std::uint32_t value) override {
    send_all(CoreRequest{CoreRequest::kWrite, offset, 0, {value}});
  }
  std::uint64_t address() const override { return address_; }
  std::uint64_t bytes() const override { return bytes_; }
  Cures cures() const override {
    return {"start the process that serves the core with more",
            "see to the process that serves the core"};
  }
  void put(std::uint64_t offset, const Words& words) override {
    send_all(CoreRequest{CoreRequest::kPut, 0, offset, words});
  }
  Words get(std::uint64_t offset) override {
    return ask<Words>(CoreRequest{CoreRequest::kGet, 0, offset, {}});
  }
  void expect_interrupt() override { send_all(CoreRequest{CoreRequest::kExpect, 0, 0, {}}); }
  bool wait_interrupt(Milliseconds patience) override {
    set_patience(kAnswerSeconds + std::chrono::ceil<std::chrono::seconds>(patience).count());
    const auto milliseconds = static_cast<std::uint64_t>(patience.count());
    const auto came = ask<std::uint32_t>(CoreRequest{CoreRequest::kWait, 0, milliseconds, {}});
    set_patience(kAnswerSeconds);
    return came != 0;
  }

 private:
  void connect_to(const std::string& path) {
    sockaddr_un place{};
    place.sun_family = AF_UNIX;
    if (path.size() >= sizeof(place.sun_path)) {
      throw Error(
          fmt::format("{}: its path is longer than {} bytes", name_, sizeof(place.sun_path) - 1));
    }
    std::memcpy(place.sun_path, path.data(), path.size());
    socket_ = socket(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0);
    if (socket_ >= 0 &&
        connect(socket_, reinterpret_cast<const sockaddr*>(&place), sizeof(place)) == 0) {
      return;
    }
    const std::string why = std::strerror(errno);
    if (socket_ >= 0) close(socket_);
    throw Error(fmt::format("{}: {}; is the process there that serves the core?", name_, why));
  }

  void set_patience(std::time_t seconds) {
    const timeval time{seconds, 0};
    setsockopt(socket_, SOL_SOCKET, SO_RCVTIMEO, &time, sizeof(time));
    setsockopt(socket_, SOL_SOCKET, SO_SNDTIMEO, &time, sizeof(time));
  }

  template <class Answer>
  Answer ask(const CoreRequest& request) {
    send_all(request);
    Answer answer{};
    receive(&answer, sizeof(answer));
    return answer;
  }

  void send_all(const CoreRequest& request) {
    const auto* from = reinterpret_cast<const char*>(&request);
    for (std::size_t sent = 0; sent < sizeof(request);) {
      sent += moved(send(socket_, from + sent, sizeof(request) - sent, MSG_NOSIGNAL));
    }
  }

  void receive(void* data, std::size_t bytes) {
    auto* to = static_cast<char*>(data);
    for (std::size_t got = 0; got < bytes;) got += moved(recv(socket_, to + got, bytes - got, 0));
  }

  /// How many bytes went or came. @throws Error where none will
  std::size_t moved(ssize_t bytes) const {
    if (bytes > 0) return static_cast<std::size_t>(bytes);
    if (bytes < 0 && errno == EINTR) return 0;
    const bool late = bytes < 0 && (errno == EAGAIN || errno == EWOULDBLOCK);
    throw Error(fmt::format("{}: {}", name_,
                            late ? "the process that serves the core does not answer"
                                 : "the process that serves the core has ended"));
  }

  std::string name_;
  int socket_ = -1;
  std::uint64_t address_ = 0;
  std::uint64_t bytes_ = 0;
};

}  // namespace

std::unique_ptr<CoreAccess> socket_access(const std::string& path) {
  return std::make_unique<SocketAccess>(path);
}

}  // namespace hwffd
