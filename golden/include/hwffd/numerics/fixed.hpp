#pragma once

#include <algorithm>
#include <cstdint>
#include <type_traits>

#include "hwffd/numerics/lanes.hpp"
#include "hwffd/numerics/out_word.hpp"

namespace hwffd {

__extension__ using Int128 = __int128;

/// The number format `fxW`: weights Q2.(W-2), points Q1.(W-1), sums Q9.(2W-3), exact; one rounding,
/// half up; saturation flagged, and the flag stays with the number (docs/numerics.md section 3).
///
/// `WordType` is a number, or `Lanes` of as many vertices, whose bits are the same: W to 24, or
/// where whoever takes them has made sure that 64 bits hold what is computed.
///
/// Mirrors rtl/number with FORMAT = W.
template <int W, class WordType = std::int64_t>
struct Fixed {
  static_assert(W >= 8 && W <= 40, "fixed point words have 8 to 40 bits");

  using Word = WordType;
  using Flag = FlagOf<Word>;
  /// Whether 64 bits hold whatever is computed on the way.
  static constexpr bool kShort = 2 * W + 14 <= 62;
  static constexpr bool kLaned = std::is_same_v<Word, Lanes>;
  using Wide = std::conditional_t<kShort || kLaned, Word, Int128>;
  using SumWord = std::conditional_t<2 * W + 6 <= 62 || kLaned, Word, Int128>;

  /// A weight (also coordinate, coefficient) or a point: `value` counts units in the last place.
  struct OfNumber;
  using Number = Flagged<Word, OfNumber>;
  /// A sum of up to 64 products.
  struct OfSum;
  using Sum = Flagged<SumWord, OfSum>;
  using Weight = Number;
  using Point = Number;
  /// Of what a gradient is expanded into: a bit more than a point, in the same units. A wide one
  /// has `kWidePartBits`.
  using Part = Number;

  static constexpr int kWeightFraction = W - 2;
  static constexpr int kPointFraction = W - 1;
  static constexpr int kSumFraction = 2 * W - 3;
  static constexpr int kWidePartBits = 35;
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
    return with_flag(round_to(Wide{place.clamped}, 33 - W, W), place.outside);
  }
  static Weight coefficient(std::uint32_t word) { return signed_word(word); }
  static Point point(std::uint32_t word, int /*exponent*/ = 0) { return signed_word(word); }
  /// Of a word that is there as a whole number, in units of 2^-31.
  static Point point_of_units(Wide units) {
    constexpr int kPad = std::max(W - 32, 0);
    return round_to(units * (std::int64_t{1} << kPad), 32 - W + kPad, W);
  }

  static Weight mul(Weight a, Weight b) {
    return with_flag(round_to(static_cast<Wide>(a.value) * b.value, kWeightFraction, W),
                     either(a.saturated, b.saturated));
  }
  static Sum term(Weight weight, Point point) {
    return {static_cast<SumWord>(weight.value) * point.value,
            either(weight.saturated, point.saturated)};
  }
  static Sum add(Sum a, Sum b) { return {a.value + b.value, either(a.saturated, b.saturated)}; }
  static Sum mac(Sum sum, Weight weight, Point point) { return add(sum, term(weight, point)); }
  static Weight step(Weight coefficient, Weight coordinate, Weight weight) {
    const Wide exact = static_cast<Wide>(coefficient.value) * (std::int64_t{1} << kWeightFraction) +
                       static_cast<Wide>(coordinate.value) * weight.value;
    return with_flag(round_to(exact, kWeightFraction, W),
                     either(either(coefficient.saturated, coordinate.saturated), weight.saturated));
  }
  static Weight scale(Weight weight, int shift) {
    return with_flag(round_to(static_cast<Wide>(weight.value) * (std::int64_t{1} << shift), 0, W),
                     weight.saturated);
  }
  /// The sum times 2^-shift.
  static Point narrow(Sum sum, int shift = 0) {
    return with_flag(
        round_to(static_cast<Wide>(sum.value), kSumFraction - kPointFraction + shift, W),
        sum.saturated);
  }
  /// Twice the product, exact: one point's digits as a weight.
  static Sum product(Point a, Point b) { return term(a, b); }
  static Sum negate(Sum sum) { return {-sum.value, sum.saturated}; }

  /// The sum of two weights as a weight.
  static Weight cumulate(Weight a, Weight b) {
    return with_flag(round_to(static_cast<Wide>(a.value) + b.value, 0, W),
                     either(a.saturated, b.saturated));
  }
  /// A weight times a part, rounded to a part.
  static Part share(Weight weight, Part part) {
    return with_flag(round_to(static_cast<Wide>(weight.value) * part.value, kWeightFraction, W + 1),
                     either(weight.saturated, part.saturated));
  }
  /// The difference of two parts.
  static Part less(Part a, Part b) {
    return with_flag(round_to(static_cast<Wide>(a.value) - b.value, 0, W + 1),
                     either(a.saturated, b.saturated));
  }

  /// A weight times a sum of parts, rounded to a wide part.
  static Part wide_share(Weight weight, Part part) {
    return with_flag(
        round_to(static_cast<Wide>(weight.value) * part.value, kWeightFraction, kWidePartBits),
        either(weight.saturated, part.saturated));
  }
  /// The difference of two wide parts.
  static Part wide_less(Part a, Part b) {
    return with_flag(round_to(static_cast<Wide>(a.value) - b.value, 0, kWidePartBits),
                     either(a.saturated, b.saturated));
  }

  /// The sum times 2^-shift, in units of the word that the stream returns.
  static Number out_units(Sum sum, int shift = 0) {
    const int fraction = kSumFraction + shift;
    const int pad = std::max(31 - fraction, 0);
    const int drop = std::max(fraction - 31, 0);
    return with_flag(round_to(static_cast<Wide>(sum.value) * (std::int64_t{1} << pad), drop, 32),
                     sum.saturated);
  }
  /// The same as that word.
  static OutWord out(Sum sum, int /*exponent*/ = 0, int shift = 0) {
    const Number number = out_units(sum, shift);
    return {static_cast<std::uint32_t>(number.value), number.saturated, false};
  }

  static Weight zero_weight() { return {everywhere<Word>(0), everywhere<Flag>(0)}; }
  static Sum zero_sum() { return {everywhere<SumWord>(0), everywhere<Flag>(0)}; }

 private:
  /// saturate(floor(value / 2^drop + 1/2)) to a signed word of `width` bits.
  static Number round_to(Wide value, int drop, int width) {
    const Wide rounded = (value + (drop > 0 ? std::int64_t{1} << (drop - 1) : 0)) >> drop;
    const Wide top = everywhere<Wide>((std::int64_t{1} << (width - 1)) - 1);
    const Wide bottom = -top - 1;
    const Wide clamped = rounded < bottom ? bottom : (rounded > top ? top : rounded);
    return {static_cast<Word>(clamped), clamped != rounded};
  }
  static Number signed_word(std::uint32_t word) {
    return point_of_units(everywhere<Wide>(static_cast<std::int32_t>(word)));
  }
  static Number with_flag(Number number, Flag flag) {
    return {number.value, either(number.saturated, flag)};
  }
};

}  // namespace hwffd
