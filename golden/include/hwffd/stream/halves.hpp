#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "hwffd/stream/beat.hpp"

/// Results of packets with the flag H: two vertices a beat (docs/interface.md section 4).
namespace hwffd {

constexpr int kHalfBits = 20;  ///< of a component, Q1.19
/// What stands in the second half of a packet's last beat where there is no vertex.
constexpr std::uint64_t kNoHalf = ~std::uint64_t{0};

/// The result of a vertex in half a beat.
struct HalfResult {
  std::array<std::int32_t, 3> words{};  ///< x, y, z, in units of 2^-19
  bool saturated = false;
  bool outside = false;
  bool folded = false;  ///< with results 2: det J is zero or negative
  bool blank = false;
};

/// A word Q1.31 as Q1.19: rounded half up, saturated.
struct HalfWord {
  std::int32_t value;
  bool saturated;
};
HalfWord half_word(std::uint32_t word);

/// As 64 bits, and back.
std::uint64_t half_bits(const HalfResult& half);
HalfResult half_of_bits(std::uint64_t bits);

/// The vertices of the result beats of a packet, without an empty half.
std::vector<HalfResult> halves_of(const std::vector<Beat>& results);

}  // namespace hwffd
