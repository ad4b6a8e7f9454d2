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
void settled(std::uint64_t now, Word& before, unsigned first, unsigned bits);

/// The same, and their counters, the first of which is given, learn which have risen or fallen.
template <class Word>
void toggled(std::uint64_t now, Word& before, unsigned first, unsigned bits,
             std::uint32_t* counter);

/// A signal of which one bit may have changed.
template <class Word>
void moved(std::uint64_t now, Word& before, std::uint32_t* counter);

}  // namespace hwffd

#endif
