#pragma once

#include <algorithm>
#include <cstdint>
#include <type_traits>

#include "hwffd/numerics/binomial.hpp"
#include "hwffd/numerics/out_word.hpp"

namespace hwffd {

__extension__ using Int128 = __int128;

/// The number format `fxW`: weights Q2.(W-2), points Q1.(W-1), sums Q9.(2W-3), exact; one rounding,
/// half up; saturation flagged, and the flag stays with the number (docs/numerics.md section 3).
///
/// Mirrors rtl/number with FORMAT = W.
template <int W>
struct Fixed {
  static_assert(W >= 8 && W <= 40, "fixed point words have 8 to 40 bits");

  /// A weight (also coordinate, coefficient) or a point: `value` counts units in the last place.
  struct Number {
    std::int64_t value = 0;
    bool saturated = false;
  };
  /// A sum of up to 64 products.
  struct Sum {
    std::conditional_t<2 * W + 6 <= 62, std::int64_t, Int128> value = 0;
    bool saturated = false;
  };
  using Weight = Number;
  using Point = Number;

  static constexpr int kWeightFraction = W - 2;
  static constexpr int kPointFraction = W - 1;
  static constexpr int kSumFraction = 2 * W - 3;
  static constexpr std::uint32_t kBlankWord = 0;
  static constexpr std::uint32_t kOneWord = 0x80000000;

  /// A coordinate's word counts units of 2^-31 modulo 2^32, from -1/2 on.
  static CoordinateRange range(std::uint32_t word) {
    constexpr std::uint32_t kMinusHalf = 0xC0000000;
    const bool below = word >= kMinusHalf;
    const bool outside = word > kOneWord;
    return {false, outside, below ? 0 : outside ? kOneWord : word};
  }

  static Weight coordinate(std::uint32_t word) {
    const CoordinateRange place = range(word);
    const Number number = round_to<Number>(Int128{place.clamped}, 33 - W, W);
    return {number.value, number.saturated || place.outside};
  }
  static Weight coefficient(std::uint32_t word) { return signed_word(word); }
  static Point point(std::uint32_t word, int /*exponent*/ = 0) { return signed_word(word); }

  static Weight mul(Weight a, Weight b) {
    return with_flag(round_to<Number>(Int128{a.value} * b.value, kWeightFraction, W),
                     a.saturated || b.saturated);
  }
  static Sum term(Weight weight, Point point) {
    Sum sum;
    sum.value = static_cast<decltype(sum.value)>(weight.value) * point.value;
    sum.saturated = weight.saturated || point.saturated;
    return sum;
  }
  static Sum add(Sum a, Sum b) {
    Sum sum;
    sum.value = a.value + b.value;
    sum.saturated = a.saturated || b.saturated;
    return sum;
  }
  static Sum mac(Sum sum, Weight weight, Point point) { return add(sum, term(weight, point)); }
  static Weight step(Weight coefficient, Weight coordinate, Weight weight) {
    const Int128 exact = Int128{coefficient.value} * (Int128{1} << kWeightFraction) +
                         Int128{coordinate.value} * weight.value;
    return with_flag(round_to<Number>(exact, kWeightFraction, W),
                     coefficient.saturated || coordinate.saturated || weight.saturated);
  }
  static Weight scale(Weight weight, int shift) {
    return with_flag(round_to<Number>(Int128{weight.value} * (1 << shift), 0, W), weight.saturated);
  }
  /// The sum times 2^-shift.
  static Point narrow(Sum sum, int shift = 0) {
    return with_flag(round_to<Number>(Int128{sum.value}, kSumFraction - kPointFraction + shift, W),
                     sum.saturated);
  }
  /// A sum times 2^shift, shift -1 to 3, as a point.
  static Point rescale(Sum sum, int shift) {
    const Int128 doubled = Int128{sum.value} * (Int128{1} << (shift + 1));
    return with_flag(round_to<Number>(doubled, kSumFraction - kPointFraction + 1, W),
                     sum.saturated);
  }
  /// 2 x - 1 of a coordinate in [0, 1], exact.
  static Weight centre(Weight coordinate) {
    return {2 * coordinate.value - (std::int64_t{1} << kWeightFraction), coordinate.saturated};
  }
  /// binom(power, k) / 2^power, exact; power and k 0 to 3.
  static Weight binomial(int power, int k) {
    return {(std::int64_t{kBinomial[power][k]} << kWeightFraction) >> power, false};
  }
  /// A point times 2^shift, shift 0 to 2, as a sum, exact.
  static Sum widen(Point point, int shift) {
    constexpr int kPlaces = kSumFraction - kPointFraction;
    Sum sum;
    sum.value =
        static_cast<decltype(sum.value)>(point.value) * (std::int64_t{1} << (kPlaces + shift));
    sum.saturated = point.saturated;
    return sum;
  }
  /// Twice the product, exact: one point's digits as a weight.
  static Sum product(Point a, Point b) { return term(a, b); }
  static Sum negate(Sum sum) {
    sum.value = -sum.value;
    return sum;
  }
  /// The sum times 2^-shift.
  static OutWord out(Sum sum, int /*exponent*/ = 0, int shift = 0) {
    const int fraction = kSumFraction + shift;
    const int pad = std::max(31 - fraction, 0);
    const int drop = std::max(fraction - 31, 0);
    const Number number = round_to<Number>(Int128{sum.value} * (1 << pad), drop, 32);
    return {static_cast<std::uint32_t>(number.value), number.saturated || sum.saturated, false};
  }

  static Weight zero_weight() { return {}; }
  static Sum zero_sum() { return {}; }

  /// saturate(floor(value / 2^drop + 1/2)) to a signed word of `width` bits.
  template <class Result>
  static Result round_to(Int128 value, int drop, int width) {
    const Int128 half = drop > 0 ? Int128{1} << (drop - 1) : Int128{0};
    const Int128 rounded = (value + half) >> drop;
    const Int128 top = (Int128{1} << (width - 1)) - 1;
    const Int128 clamped = std::clamp(rounded, -top - 1, top);
    return {static_cast<std::int64_t>(clamped), clamped != rounded};
  }

 private:
  static Number signed_word(std::uint32_t word) {
    constexpr int kPad = std::max(W - 32, 0);
    return round_to<Number>(Int128{static_cast<std::int32_t>(word)} * (1 << kPad), 32 - W + kPad,
                            W);
  }
  static Number with_flag(Number number, bool flag) {
    return {number.value, number.saturated || flag};
  }
};

}  // namespace hwffd
