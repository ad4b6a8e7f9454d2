#pragma once

#include <cmath>
#include <cstdint>

#include "hwffd/numerics/bits.hpp"
#include "hwffd/numerics/out_word.hpp"

namespace hwffd {

/// The number format `fp32`: IEEE-754 binary32, round to nearest even, subnormals, infinities;
/// every NaN result is 0x7FC00000 and every zero result +0 (docs/numerics.md section 2).
///
/// Mirrors rtl/number with FORMAT = 0 on the host's own arithmetic: nothing is shared with the
/// RTL's algorithms. Must be compiled with -ffp-contract=off.
struct Binary32 {
  using Weight = float;
  using Point = float;
  using Sum = float;

  static constexpr std::uint32_t kBlankWord = 0x7FC00000;
  static constexpr std::uint32_t kOneWord = 0x3F800000;

  static CoordinateRange range(std::uint32_t word) {
    const float value = float_of_bits(word);
    if (!std::isfinite(value)) return {true, false, word};
    if (value > 1.0F) return {false, true, kOneWord};
    if (value < 0.0F) return {false, true, 0};
    return {false, false, word};
  }

  static Weight coordinate(std::uint32_t word) { return float_of_bits(word); }
  static Weight coefficient(std::uint32_t word) { return float_of_bits(word); }
  static Point point(std::uint32_t word, int /*exponent*/ = 0) { return float_of_bits(word); }

  static Weight mul(Weight a, Weight b) { return canonical(a * b); }
  static Sum term(Weight weight, Point point) { return canonical(weight * point); }
  static Sum add(Sum a, Sum b) { return canonical(a + b); }
  static Sum mac(Sum sum, Weight weight, Point point) { return add(sum, term(weight, point)); }
  static Weight step(Weight coefficient, Weight coordinate, Weight weight) {
    return add(mul(coordinate, weight), coefficient);
  }
  static Point narrow(Sum sum, int /*shift*/ = 0) { return sum; }
  static Sum product(Point a, Point b) { return term(a, b); }
  static Sum negate(Sum sum) { return -sum; }
  static Weight scale(Weight weight, int /*shift*/) { return weight; }
  static OutWord out(Sum sum, int /*exponent*/ = 0, int /*shift*/ = 0) {
    return {bits_of_float(sum), false, std::isnan(sum)};
  }

  static Weight zero_weight() { return 0.0F; }
  static Sum zero_sum() { return 0.0F; }

 protected:
  static float canonical(float value) {
    if (std::isnan(value)) return float_of_bits(0x7FC00000);
    return value == 0.0F ? 0.0F : value;
  }
};

/// `fp32` with fused multiply-add (paper, section 3.4): one rounding for a product and the addition
/// behind it, in Horner's steps and where terms are summed.
struct Binary32Fused : Binary32 {
  static Sum mac(Sum sum, Weight weight, Point point) {
    return canonical(std::fma(weight, point, sum));
  }
  static Weight step(Weight coefficient, Weight coordinate, Weight weight) {
    return canonical(std::fma(coordinate, weight, coefficient));
  }
};

}  // namespace hwffd
