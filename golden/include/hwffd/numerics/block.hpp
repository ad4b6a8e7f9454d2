#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "hwffd/numerics/binary32.hpp"
#include "hwffd/numerics/bits.hpp"
#include "hwffd/numerics/fixed.hpp"
#include "hwffd/numerics/out_word.hpp"

namespace hwffd {

/// The number format `bfp32`, block floating point: words of coordinates, points and results are
/// binary32, everything between is fixed point of W bits, and all points of a lattice share one
/// exponent: those below 2^exponent fit (docs/numerics.md section 10).
///
/// Mirrors rtl/number with FORMAT = 64 + W. Infinities and NaN go beside the fixed-point numbers,
/// and the host's own arithmetic says what becomes of them.
template <int W>
struct Block {
  using Base = Fixed<W>;
  using Weight = typename Base::Weight;

  /// A finite number in units of the last place; or `special`, an infinity or a NaN, where it is
  /// not 0.
  struct Point {
    typename Base::Point number;
    double special = 0;
  };
  /// A sum of up to 64 products.
  struct Sum {
    typename Base::Sum number;
    double special = 0;
  };

  static constexpr int kWidth = W;
  static constexpr int kWeightFraction = Base::kWeightFraction;
  static constexpr std::uint32_t kBlankWord = Binary32::kBlankWord;
  static constexpr std::uint32_t kOneWord = Binary32::kOneWord;

  static CoordinateRange range(std::uint32_t word) { return Binary32::range(word); }

  /// Rounded half up; outside [0, 1] clamped and flagged. What is no number counts as beyond the
  /// end that its sign says.
  static Weight coordinate(std::uint32_t word) {
    const float value = float_of_bits(word);
    if (std::isnan(value)) return {std::signbit(value) ? 0 : kOne, true};
    const double inside = std::clamp<double>(value, 0.0, 1.0);
    return {aligned(inside, kWeightFraction), inside != value};
  }
  static Weight coefficient(std::uint32_t word) { return Base::coefficient(word); }

  /// Rounded half up to the block's unit; what does not fit saturates and is flagged.
  static Point point(std::uint32_t word, int exponent) {
    const double value = float_of_bits(word);
    if (!std::isfinite(value)) return {{}, value};
    const std::int64_t exact = aligned(value, Base::kPointFraction - exponent);
    const std::int64_t fitting = std::clamp(exact, -kTop - 1, kTop);
    return {{fitting, fitting != exact}, 0};
  }

  static Weight mul(Weight a, Weight b) { return Base::mul(a, b); }
  static Weight step(Weight coefficient, Weight coordinate, Weight weight) {
    return Base::step(coefficient, coordinate, weight);
  }
  static Weight scale(Weight weight, int shift) { return Base::scale(weight, shift); }

  static Sum term(Weight weight, Point point) {
    const double special =
        point.special == 0 ? 0 : static_cast<double>(weight.value) * point.special;
    return {Base::term(weight, point.number), special};
  }
  static Sum add(Sum a, Sum b) { return {Base::add(a.number, b.number), a.special + b.special}; }
  static Sum mac(Sum sum, Weight weight, Point point) { return add(sum, term(weight, point)); }
  /// The sum times 2^-shift.
  static Point narrow(Sum sum, int shift = 0) {
    return {Base::narrow(sum.number, shift), sum.special};
  }
  /// Twice the product, exact; NaN where either is no finite number.
  static Sum product(Point a, Point b) {
    const bool finite = a.special == 0 && b.special == 0;
    return {Base::product(a.number, b.number), finite ? 0 : std::nan("")};
  }
  static Sum negate(Sum sum) { return {Base::negate(sum.number), -sum.special}; }

  /// The sum times 2^(exponent - shift), rounded once to binary32, to nearest even; beyond its
  /// range an infinity; never -0.
  static OutWord out(Sum sum, int exponent, int shift = 0) {
    if (std::isnan(sum.special)) return {kBlankWord, sum.number.saturated, true};
    const auto value =
        static_cast<float>(sum.special != 0 ? sum.special
                                            : std::ldexp(to_odd(sum.number.value),
                                                         exponent - shift - Base::kSumFraction));
    return {value == 0 ? 0 : bits_of_float(value), sum.number.saturated, false};
  }

  static Weight zero_weight() { return {}; }
  static Sum zero_sum() { return {}; }

 private:
  static constexpr std::int64_t kOne = std::int64_t{1} << kWeightFraction;
  static constexpr std::int64_t kTop = (std::int64_t{1} << Base::kPointFraction) - 1;

  /// floor(value x 2^fraction + 1/2), within [-2^W, 2^W]. Exact: value has 24 bits.
  static std::int64_t aligned(double value, int fraction) {
    const double limit = std::ldexp(1.0, W);
    const double units = std::clamp(std::ldexp(value, fraction), -limit, limit);
    return static_cast<std::int64_t>(std::floor(units + 0.5));
  }

  /// The value in the 53 bits of a double, inexactness left in the lowest: such a double rounds to
  /// binary32 as the value itself does.
  static double to_odd(Int128 value) {
    Int128 magnitude = value < 0 ? -value : value;
    int dropped = 0;
    bool inexact = false;
    for (; magnitude >> 53 != 0; ++dropped) {
      inexact |= (magnitude & 1) != 0;
      magnitude >>= 1;
    }
    const auto significand = static_cast<std::int64_t>(magnitude) | (inexact ? 1 : 0);
    return std::ldexp(static_cast<double>(value < 0 ? -significand : significand), dropped);
  }
};

/// The block floating point of the table of configurations.
using Block32 = Block<35>;

}  // namespace hwffd
