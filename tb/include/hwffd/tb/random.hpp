#pragma once

#include <cstddef>
#include <cstdint>
#include <initializer_list>
#include <iterator>
#include <random>

namespace hwffd::tb {

/// Seeded random numbers: raw mt19937_64 and conversions of our own, so that a seed means the same
/// numbers with every standard library (the std distributions differ between libraries).
class Random {
 public:
  explicit Random(std::uint64_t seed) : engine_(seed) {}

  /// 64 random bits.
  std::uint64_t bits() { return engine_(); }
  /// 32 random bits.
  std::uint32_t word() { return static_cast<std::uint32_t>(engine_() >> 32); }

  /// Uniform integer in [0, n), without bias. Throws std::invalid_argument when n is 0.
  std::uint64_t below(std::uint64_t n);
  /// Uniform integer in [low, high], both included. Throws std::invalid_argument when high < low.
  std::uint64_t between(std::uint64_t low, std::uint64_t high);
  /// Uniform double in [0, 1): a multiple of 2^-53.
  double unit() { return static_cast<double>(engine_() >> 11) * 0x1p-53; }
  /// True with probability p; never for p <= 0, always for p >= 1.
  bool chance(double p) { return unit() < p; }

  /// A copy of one element of an array, vector or braced list, each as likely as the others. Throws
  /// std::invalid_argument when the list is empty.
  template <class List>
  auto pick(const List& list) {
    return *std::next(std::begin(list), static_cast<std::ptrdiff_t>(below(std::size(list))));
  }
  template <class T>
  T pick(std::initializer_list<T> list) {
    return *std::next(list.begin(), static_cast<std::ptrdiff_t>(below(list.size())));
  }

 private:
  std::mt19937_64 engine_;
};

/// The seed of the `index`-th generator of a test: unrelated streams from one seed (splitmix64).
std::uint64_t derive_seed(std::uint64_t seed, std::uint64_t index);

/// The value of an environment variable (decimal, or hexadecimal after 0x), or `fallback` when it
/// is unset or empty. Throws std::invalid_argument when it is not a 64-bit number.
std::uint64_t seed_from_environment(std::uint64_t fallback, const char* variable = "SEED");

}  // namespace hwffd::tb
