// A Verilated hwffd_axi whose registers, memory and interrupt this process serves at a socket, for
// programs that want the device socket:PATH.
//
//     served_core ROW PATH [REQUESTS]
//
// It prints a line when it listens, serves one client, and ends with it, or after so many requests.
// Exit status 1: a bus broke a rule.
#include <sys/socket.h>
#include <sys/un.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstdio>
#include <limits>
#include <stdexcept>
#include <string>

#include "device/core_access.hpp"
#include "simulated_core.hpp"

namespace hwffd::test {
namespace {

constexpr std::uint64_t kAddress = SimulatedCore::kAddress;

class Server {
 public:
  explicit Server(const Configuration& row) : core_(row) {}

  void listen_at(const std::string& path) {
    sockaddr_un place{};
    place.sun_family = AF_UNIX;
    if (path.size() >= sizeof(place.sun_path)) throw std::runtime_error("the path is too long");
    std::copy(path.begin(), path.end(), place.sun_path);
    const int listening = socket(AF_UNIX, SOCK_STREAM, 0);
    if (bind(listening, reinterpret_cast<const sockaddr*>(&place), sizeof(place)) != 0 ||
        listen(listening, 1) != 0) {
      throw std::runtime_error(path + ": cannot listen there");
    }
    std::puts("listening");
    std::fflush(stdout);
    client_ = accept(listening, nullptr, nullptr);
    close(listening);
    const std::array<std::uint64_t, 2> buffer{kAddress, SimulatedCore::kBytes};
    answer(&buffer, sizeof(buffer));
  }

  void serve(std::uint64_t requests) {
    CoreRequest request{};
    for (std::uint64_t served = 0; served < requests && receive(request); ++served) {
      serve(request);
    }
    close(client_);
  }

  std::string faults() { return core_.system.faults(); }

 private:
  void serve(const CoreRequest& request) {
    switch (request.kind) {
      case CoreRequest::kRead: {
        const std::uint32_t value = core_.system.read32(request.offset);
        return answer(&value, sizeof(value));
      }
      case CoreRequest::kWrite:
        return core_.system.write32(request.offset, request.words[0]);
      case CoreRequest::kPut:
        return core_.system.memory.set_beat(kAddress + request.place, request.words);
      case CoreRequest::kGet: {
        const CoreAccess::Words words = core_.system.memory.beat(kAddress + request.place);
        return answer(&words, sizeof(words));
      }
      case CoreRequest::kWait: {
        const std::uint32_t came = core_.interrupt_within(SimulatedCore::kLatestInterrupt) ? 1 : 0;
        return answer(&came, sizeof(came));
      }
      default:
        return;  // kExpect: the line is looked at, not its edges
    }
  }

  void answer(const void* data, std::size_t bytes) const {
    const auto* from = static_cast<const char*>(data);
    for (std::size_t sent = 0; sent < bytes;) {
      const ssize_t more = send(client_, from + sent, bytes - sent, MSG_NOSIGNAL);
      if (more <= 0) return;
      sent += static_cast<std::size_t>(more);
    }
  }

  bool receive(CoreRequest& request) const {
    auto* to = reinterpret_cast<char*>(&request);
    for (std::size_t got = 0; got < sizeof(request);) {
      const ssize_t more = recv(client_, to + got, sizeof(request) - got, 0);
      if (more <= 0) return false;
      got += static_cast<std::size_t>(more);
    }
    return true;
  }

  SimulatedCore core_;
  int client_ = -1;
};

int run(int count, char** words) {
  if (count < 3) throw std::runtime_error("usage: served_core ROW PATH [REQUESTS]");
  Server server(find_configuration(words[1]));
  server.listen_at(words[2]);
  server.serve(count > 3 ? std::stoull(words[3]) : std::numeric_limits<std::uint64_t>::max());
  if (server.faults().empty()) return 0;
  std::fprintf(stderr, "served_core: %s\n", server.faults().c_str());
  return 1;
}

}  // namespace
}  // namespace hwffd::test

int main(int count, char** words) {
  try {
    return hwffd::test::run(count, words);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "served_core: %s\n", error.what());
    return 1;
  }
}
