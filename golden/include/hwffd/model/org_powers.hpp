#pragma once

#include "hwffd/model/org_factored.hpp"
#include "hwffd/numerics/fixed.hpp"

namespace hwffd::model {

/// The uniform cubic B-spline of an axis from the powers s^2 and s^3, whatever is loaded: four
/// weights that sum to one, of a derivative, halved, to zero (docs/numerics.md section 5). `F` is
/// fixed point. Mirrors ffd_num_powers.
template <class F>
class PowersBspline {
 public:
  using Word = typename F::Word;
  using Wide = typename F::Wide;
  using Weights = std::array<typename F::Weight, 4>;  ///< B_0 to B_3

  /// The weights at a coordinate of [0, 1].
  static Weights weights(typename F::Weight coordinate) {
    const Word s = coordinate.value;
    const Word square = cut(s, s);
    const Word cube = cut(s, rounded(static_cast<Wide>(s) * s, kFraction));
    // Sixths have three digits more.
    const Word sixth_of_cube = eight_sixths(cube);
    const Word bend = square - (s << kGuard);
    const Word rise = square + (s << kGuard) - cube;
    const Word at_end = s == kOne ? everywhere<Word>(kOver) : everywhere<Word>(0);
    return completed(kOne, rounded(kSixth + 4 * bend - sixth_of_cube, kGuard + 3),
                     rounded(kSixth + 4 * rise, kGuard + 3) - at_end,
                     rounded(sixth_of_cube, kGuard + 3), coordinate.saturated);
  }

  /// Half the derivatives' weights.
  static Weights slopes(typename F::Weight coordinate) {
    const Word square = cut(coordinate.value, coordinate.value);
    const std::int64_t one = kOne << kGuard;
    const Word twice = coordinate.value << (kGuard + 1);
    return completed(0, rounded(twice - one - square, kGuard + 2),
                     rounded(one + twice - 3 * square, kGuard + 2), rounded(square, kGuard + 2),
                     coordinate.saturated);
  }

 private:
  static constexpr int kFraction = F::kWeightFraction;
  static constexpr int kGuard = 3;  // digits behind a weight's last that powers are cut to
  static constexpr std::int64_t kOne = std::int64_t{1} << kFraction;
  static constexpr std::int64_t kSixth = (kOne << (kGuard + 3)) / 6;
  /// By how many units 2/3 is rounded above what two sixths, rounded, leave of 1: 1 or -1.
  static constexpr std::int64_t kOver = (2 * kOne + 1) / 3 - (kOne - 2 * ((kOne + 3) / 6));

  static Word floor_of(Wide value, int drop) { return static_cast<Word>(value >> drop); }
  static Word rounded(Wide value, int drop) {
    return floor_of(value + (std::int64_t{1} << (drop - 1)), drop);
  }
  /// A product of two weights, cut.
  static Word cut(Word a, Word b) { return floor_of(static_cast<Wide>(a) * b, kFraction - kGuard); }
  /// 8/6 of a power: 1 + 1/4 times 1 + 1/16 times 1 + 1/256 and so on, each product cut.
  static Word eight_sixths(Word power) {
    for (int shift = 2; shift < kFraction + kGuard; shift *= 2) power += power >> shift;
    return power;
  }
  static Weights completed(std::int64_t whole, Word w0, Word w2, Word w3, typename F::Flag flag) {
    return {{{w0, flag}, {whole - w0 - w2 - w3, flag}, {w2, flag}, {w3, flag}}};
  }
};

/// The four weights of each axis, by bank.
template <class F>
AxisWeights<F> powers_of(const LocalVertex<F>& vertex) {
  AxisWeights<F> weight;
  for (int axis = 0; axis < 3; ++axis) {
    const auto own = axis == vertex.derivative ? PowersBspline<F>::slopes(vertex.local[axis])
                                               : PowersBspline<F>::weights(vertex.local[axis]);
    for (int b = 0; b < 4; ++b) weight[axis][b] = own[local_of_bank(b, vertex.cell[axis])];
  }
  return weight;
}

/// Organizations `factored` and `affine` with these weights: as they sum to one, what three of them
/// leave is the fourth, so both give the same bits.
template <class F>
class OrgPowers {
 public:
  explicit OrgPowers(const Configuration& /*configuration*/) {}

  VectorSum<F> evaluate(const LocalVertex<F>& vertex, const Support<F>& support,
                        const CoefficientBank<F>& bank) const {
    return contract_axes<F>(weights(vertex, bank), by_bank<F>(support, vertex.cell));
  }

  /// Those that the axes are contracted with.
  static AxisWeights<F> weights(const LocalVertex<F>& vertex, const CoefficientBank<F>& /*bank*/) {
    return powers_of<F>(vertex);
  }
};

}  // namespace hwffd::model
