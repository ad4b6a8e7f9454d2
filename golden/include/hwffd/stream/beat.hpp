#pragma once

#include <array>
#include <cstdint>

namespace hwffd {

/// One beat of the 128-bit streams: four little-endian 32-bit words (word 0 in tdata[31:0]) and
/// tlast. docs/interface.md section 1.
struct Beat {
  std::array<std::uint32_t, 4> words{};
  bool last = false;

  friend bool operator==(const Beat& a, const Beat& b) {
    return a.words == b.words && a.last == b.last;
  }
  friend bool operator!=(const Beat& a, const Beat& b) { return !(a == b); }
};

}  // namespace hwffd
