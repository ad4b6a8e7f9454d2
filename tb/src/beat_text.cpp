#include "hwffd/tb/beat_text.hpp"

#include <fmt/format.h>

namespace hwffd::tb {

std::string beat_text(const Beat& beat) {
  const auto& w = beat.words;
  return fmt::format("{:08x} {:08x} {:08x} {:08x}{}{}", w[0], w[1], w[2], w[3],
                     beat.last ? " last" : "", beat.user ? " user" : "");
}

}  // namespace hwffd::tb
