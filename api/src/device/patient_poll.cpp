#include "device/patient_poll.hpp"

#include <poll.h>

#include <algorithm>
#include <cerrno>

namespace hwffd {

int patient_poll(int file, short events, std::chrono::milliseconds patience) {
  using Milliseconds = std::chrono::milliseconds;
  const auto end = std::chrono::steady_clock::now() + patience;
  for (;;) {
    const auto rest = std::chrono::ceil<Milliseconds>(end - std::chrono::steady_clock::now());
    pollfd waited{file, events, 0};
    const int ready = poll(&waited, 1, static_cast<int>(std::max(rest, Milliseconds(0)).count()));
    if (ready >= 0 || errno != EINTR) return ready;
  }
}

}  // namespace hwffd
