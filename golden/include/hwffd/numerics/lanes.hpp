#pragma once

#include <cstdint>
#include <type_traits>

namespace hwffd {

/// Eight whole numbers side by side, one of each of eight vertices: arithmetic as of one number,
/// and comparisons give -1 where they hold and 0 elsewhere.
using Lanes = std::int64_t __attribute__((vector_size(64)));
constexpr int kLanes = 8;

/// What a comparison of words gives.
template <class Word>
using FlagOf = std::conditional_t<std::is_same_v<Word, Lanes>, Lanes, bool>;

inline bool either(bool a, bool b) { return a || b; }
#ifndef HWFFD_NO_LANES  // no function takes them
inline Lanes either(Lanes a, Lanes b) { return a | b; }
#endif

/// A whole number and whether it, or what it was made of, saturated. What it is the value of makes
/// types of it that do not mix.
template <class Word, class What>
struct Flagged {
  Word value{};
  bool saturated = false;
};
/// Eight of them; without values until they are given some, since arrays of them are large. Without
/// a word of it, a compiler aligns lanes as the kind of processor likes that it compiles for, and
/// functions for different kinds could not share them in memory.
template <class What>
struct alignas(sizeof(Lanes)) Flagged<Lanes, What> {
  Lanes value;
  Lanes saturated;
};

/// The number itself, or in every lane.
template <class Word>
Word everywhere(std::int64_t value) {
  return Word{} + value;
}

}  // namespace hwffd
