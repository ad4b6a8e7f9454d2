#include "hwffd/stream/halves.hpp"

#include <algorithm>

namespace hwffd {
namespace {

constexpr int kDropped = 32 - kHalfBits;
constexpr std::int64_t kMost = (std::int64_t{1} << (kHalfBits - 1)) - 1;
constexpr std::uint64_t kMask = (std::uint64_t{1} << kHalfBits) - 1;
constexpr int kSaturated = 60;
constexpr int kOutside = 61;
constexpr int kFolded = 62;
constexpr int kBlank = 63;

bool bit(std::uint64_t bits, int place) { return (bits >> place & 1) != 0; }

}  // namespace

HalfWord half_word(std::uint32_t word) {
  const std::int64_t exact = static_cast<std::int32_t>(word);
  const std::int64_t rounded = (exact + (std::int64_t{1} << (kDropped - 1))) >> kDropped;
  return {static_cast<std::int32_t>(std::min(rounded, kMost)), rounded > kMost};
}

std::uint64_t half_bits(const HalfResult& half) {
  std::uint64_t bits = std::uint64_t{half.saturated} << kSaturated |
                       std::uint64_t{half.outside} << kOutside |
                       std::uint64_t{half.folded} << kFolded | std::uint64_t{half.blank} << kBlank;
  for (int c = 0; c < 3; ++c) {
    bits |= (static_cast<std::uint64_t>(half.words[c]) & kMask) << (kHalfBits * c);
  }
  return bits;
}

HalfResult half_of_bits(std::uint64_t bits) {
  HalfResult half;
  half.saturated = bit(bits, kSaturated);
  half.outside = bit(bits, kOutside);
  half.folded = bit(bits, kFolded);
  half.blank = bit(bits, kBlank);
  for (int c = 0; c < 3; ++c) {
    const auto value = static_cast<std::int64_t>(bits >> (kHalfBits * c) & kMask);
    half.words[c] = static_cast<std::int32_t>(value > kMost ? value - (kMost + 1) * 2 : value);
  }
  return half;
}

std::vector<HalfResult> halves_of(const std::vector<Beat>& results) {
  std::vector<HalfResult> halves;
  halves.reserve(2 * results.size());
  for (const Beat& beat : results) {
    for (const int low : {0, 2}) {
      const std::uint64_t bits = beat.words[low] | std::uint64_t{beat.words[low + 1]} << 32;
      if (bits != kNoHalf) halves.push_back(half_of_bits(bits));
    }
  }
  return halves;
}

}  // namespace hwffd
