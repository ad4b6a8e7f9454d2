#pragma once

#include <cstdint>

#include "../fixed/exact_fixed.hpp"

namespace hwffd::test {

/// What a number of block floating point is, whatever its value.
enum class Class { kFinite, kPlus, kMinus, kNan };

/// As IEEE-754 multiplies a finite weight by it.
inline Class product_class(Int128 weight, Class point) {
  if (point == Class::kFinite || point == Class::kNan) return point;
  if (weight == 0) return Class::kNan;
  if (weight > 0) return point;
  return point == Class::kPlus ? Class::kMinus : Class::kPlus;
}

/// As IEEE-754 adds.
inline Class sum_class(Class a, Class b) {
  if (a == b || b == Class::kFinite) return a;
  if (a == Class::kFinite) return b;
  return Class::kNan;
}

/// The fields of a binary32 word: (-1)^negative significand 2^power.
struct FloatFields {
  Class kind = Class::kFinite;
  bool negative = false;
  std::int64_t significand = 0;
  int power = 0;
};

inline FloatFields float_fields(std::uint32_t word) {
  const bool negative = word >> 31 != 0;
  const int field = static_cast<int>(word >> 23 & 0xFF);
  const std::int64_t fraction = word & 0x7FFFFF;
  if (field == 255) {
    const Class infinity = negative ? Class::kMinus : Class::kPlus;
    return {fraction != 0 ? Class::kNan : infinity, negative, 0, 0};
  }
  if (field == 0) return {Class::kFinite, negative, fraction, -149};
  return {Class::kFinite, negative, fraction + 0x800000, field - 150};
}

/// The multiple of 2^-fraction nearest to a word, ties upward, in a signed word of `width` bits.
inline Rounded aligned(const FloatFields& fields, int fraction, int width) {
  constexpr int kFar = 80;  // beyond it every bit counts alike
  Int128 num = fields.negative ? -fields.significand : fields.significand;
  int power = fields.power + fraction;
  if (power > kFar) power = kFar;
  if (power < -kFar) power = -kFar;
  for (; power > 0; --power) num *= 2;
  return nearest({num, -power}, 0, width);
}

/// value x 2^power rounded to binary32 by division with remainder: nearest, ties to even.
inline std::uint32_t rounded_binary32(Int128 value, int power) {
  constexpr std::int64_t kHidden = 0x800000;
  constexpr Int128 kInfinity = 0x7F800000;
  if (value == 0) return 0;
  const Int128 magnitude = value < 0 ? -value : value;
  // The unit 2^place of the result: 24 bits of it reach the leading one, but subnormals.
  int place = power - 23;
  for (Int128 rest = magnitude; rest > 1; rest /= 2) ++place;
  if (place < -149) place = -149;
  Int128 num = magnitude;
  Int128 den = 1;
  for (int p = power; p > place; --p) num *= 2;
  for (int p = power; p < place && den / 4 <= magnitude; ++p) den *= 2;
  Int128 quotient = num / den;
  const Int128 twice = 2 * (num % den);
  if (twice > den || (twice == den && quotient % 2 != 0)) ++quotient;
  Int128 word =
      quotient < kHidden ? quotient : (place + 150) * Int128{kHidden} + quotient - kHidden;
  if (word > kInfinity) word = kInfinity;
  if (word == 0) return 0;
  return static_cast<std::uint32_t>(word) | (value < 0 ? 0x80000000U : 0U);
}

}  // namespace hwffd::test
