#pragma once

#include <array>
#include <cstdint>

namespace hwffd {

/// One beat of the 128-bit streams: four little-endian 32-bit words (word 0 in tdata[31:0]), tlast,
/// and tuser, which only results have. docs/interface.md section 1.
struct Beat {
  std::array<std::uint32_t, 4> words{};
  bool last = false;
  bool user = false;  ///< with the last result of a packet that asks for an interrupt

  friend bool operator==(const Beat& a, const Beat& b) {
    return a.words == b.words && a.last == b.last && a.user == b.user;
  }
  friend bool operator!=(const Beat& a, const Beat& b) { return !(a == b); }
};

}  // namespace hwffd
