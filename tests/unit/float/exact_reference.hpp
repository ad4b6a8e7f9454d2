#pragma once

#include <cstdint>

/// Floating-point operations by exact integers, for formats small enough that every sum and product
/// of two finite words is an integer of 127 bits. Slow, short, and sharing nothing with what it
/// checks: the exact result is formed first and rounded once, by definition.
namespace hwffd::exact {

__extension__ typedef __int128 Integer;

/// An IEEE-754 interchange format. The exact results fit while
/// 2 * (2^exponent_bits + significand_bits) < 126, so for exponents of up to 5 bits.
struct Format {
  int exponent_bits;
  int significand_bits;  ///< with the hidden bit

  constexpr int fraction_bits() const { return significand_bits - 1; }
  constexpr int word_bits() const { return exponent_bits + significand_bits; }
  constexpr int bias() const { return (1 << (exponent_bits - 1)) - 1; }
  constexpr int largest_field() const { return (1 << exponent_bits) - 1; }
  /// The smallest subnormal, the unit of every finite word, is 2^-unit_bits().
  constexpr int unit_bits() const { return bias() - 1 + fraction_bits(); }
  constexpr std::uint32_t infinity() const {
    return static_cast<std::uint32_t>(largest_field()) << fraction_bits();
  }
  constexpr std::uint32_t nan() const { return infinity() | 1u << (fraction_bits() - 1); }
  constexpr std::uint32_t sign() const { return 1u << (word_bits() - 1); }
};

enum class Kind { kFinite, kInfinite, kNan };

struct Number {
  Kind kind;
  bool negative;
  std::int64_t units;  ///< signed value of a finite word in smallest subnormals
};

inline Number decode(Format format, std::uint32_t word) {
  const bool negative = (word & format.sign()) != 0;
  const int field = static_cast<int>(word >> format.fraction_bits()) & format.largest_field();
  const std::int64_t fraction = word & ((1u << format.fraction_bits()) - 1);
  if (field == format.largest_field()) {
    return {fraction == 0 ? Kind::kInfinite : Kind::kNan, negative, 0};
  }
  const std::int64_t hidden = std::int64_t{1} << format.fraction_bits();
  const std::int64_t units = field == 0 ? fraction : (hidden + fraction) << (field - 1);
  return {Kind::kFinite, negative, negative ? -units : units};
}

/// Rounds value / 2^scale smallest subnormals to nearest, ties to even. A zero is +0.
inline std::uint32_t round(Format format, Integer value, int scale) {
  const bool negative = value < 0;
  const Integer magnitude = negative ? -value : value;
  // Drop bits until the significand fits, but never keep bits below the smallest subnormal.
  int dropped = scale;
  while ((magnitude >> dropped) >> format.significand_bits != 0) ++dropped;
  Integer significand = magnitude >> dropped;
  const Integer twice_rest = 2 * (magnitude - (significand << dropped));
  const Integer whole = Integer{1} << dropped;
  if (twice_rest > whole || (twice_rest == whole && significand % 2 != 0)) ++significand;
  // A subnormal is its fraction; the hidden bit of a normal counts the exponent up by one, as does
  // a carry into the next binade.
  const Integer word = (Integer{dropped - scale} << format.fraction_bits()) + significand;
  if (significand == 0) return 0;
  return (negative ? format.sign() : 0) |
         (word < format.infinity() ? static_cast<std::uint32_t>(word) : format.infinity());
}

inline std::uint32_t infinity(Format format, bool negative) {
  return format.infinity() | (negative ? format.sign() : 0);
}

inline std::uint32_t add(Format format, Number a, Number b) {
  if (a.kind == Kind::kNan || b.kind == Kind::kNan) return format.nan();
  if (a.kind == Kind::kInfinite && b.kind == Kind::kInfinite && a.negative != b.negative) {
    return format.nan();
  }
  if (a.kind == Kind::kInfinite) return infinity(format, a.negative);
  if (b.kind == Kind::kInfinite) return infinity(format, b.negative);
  return round(format, Integer{a.units} + b.units, 0);
}

inline bool is_zero(Number a) { return a.kind == Kind::kFinite && a.units == 0; }

/// a * b is an invalid operation or takes a NaN.
inline bool product_is_nan(Number a, Number b) {
  if (a.kind == Kind::kNan || b.kind == Kind::kNan) return true;
  return (a.kind == Kind::kInfinite && is_zero(b)) || (b.kind == Kind::kInfinite && is_zero(a));
}

inline std::uint32_t mul(Format format, Number a, Number b) {
  if (product_is_nan(a, b)) return format.nan();
  if (a.kind == Kind::kInfinite || b.kind == Kind::kInfinite) {
    return infinity(format, a.negative != b.negative);
  }
  return round(format, Integer{a.units} * b.units, format.unit_bits());
}

inline std::uint32_t fma(Format format, Number a, Number b, Number c) {
  if (product_is_nan(a, b) || c.kind == Kind::kNan) return format.nan();
  if (a.kind == Kind::kInfinite || b.kind == Kind::kInfinite) {
    const bool negative = a.negative != b.negative;
    if (c.kind == Kind::kInfinite && c.negative != negative) return format.nan();
    return infinity(format, negative);
  }
  if (c.kind == Kind::kInfinite) return infinity(format, c.negative);
  const Integer one = Integer{1} << format.unit_bits();
  return round(format, Integer{a.units} * b.units + c.units * one, format.unit_bits());
}

}  // namespace hwffd::exact
