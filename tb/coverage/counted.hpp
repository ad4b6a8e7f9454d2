// How a Verilated model counts its toggles, and names its counters (cmake/compact_counters.py).
// SPDX-License-Identifier: Apache-2.0
#ifndef HWFFD_TB_COUNTED_HPP
#define HWFFD_TB_COUNTED_HPP

#include <cstddef>
#include <cstdint>

namespace hwffd {

/// In the counter of a bit: what it has done.
constexpr std::uint32_t kRisen = 1;
constexpr std::uint32_t kFallen = 2;

/// The place of a counter in a source.
struct Counter {
  std::uint32_t index;  ///< among those of the model
  int line;
  int column;
  const char* page;     ///< v_KIND/MODULE
  const char* comment;  ///< of a branch: which; of a toggle: the bit
  const char* lines;    ///< further lines of a branch, as "4-5,7"
};

/// Makes counters of a class known, once a table.
void name_counters(const std::uint32_t* counters, const Counter* named, std::size_t count);

template <std::size_t count>
void name_counters(const std::uint32_t* counters, const Counter (&named)[count]) {
  name_counters(counters, named, count);
}

/// `bits` bits of a signal from `first` on have become those of `now`.
template <class Word>
void settled(std::uint64_t now, Word& before, unsigned first, unsigned bits) {
  const std::uint64_t mask = ~std::uint64_t{0} >> (64 - bits) << first;
  before = static_cast<Word>((before & ~mask) | (now & mask));
}

/// The same, and their counters, the first of which is given, learn which have risen and which
/// fallen.
template <class Word>
void toggled(std::uint64_t now, Word& before, unsigned first, unsigned bits,
             std::uint32_t* counter) {
  const std::uint64_t mask = ~std::uint64_t{0} >> (64 - bits) << first;
  std::uint64_t changed = (now ^ before) & mask;
  if (changed == 0) return;
  before = static_cast<Word>(before ^ changed);
  for (; changed != 0; changed &= changed - 1) {
    const int bit = __builtin_ctzll(changed);
    counter[bit - static_cast<int>(first)] |= (now >> bit & 1) != 0 ? kRisen : kFallen;
  }
}

/// A signal of which one bit may have changed.
template <class Word>
void moved(std::uint64_t now, Word& before, std::uint32_t* counter) {
  if (now != before) *counter |= now > before ? kRisen : kFallen;
  before = static_cast<Word>(now);
}

}  // namespace hwffd

#endif
