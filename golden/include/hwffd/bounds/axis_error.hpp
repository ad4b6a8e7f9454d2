#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "hwffd/model/coefficients.hpp"
#include "hwffd/model/org_powers.hpp"
#include "hwffd/numerics/fixed.hpp"
#include "hwffd/stream/blending.hpp"

namespace hwffd::bounds {

/// A coordinate's range is cut into this many equal pieces, and each has its own bound.
constexpr int kPieces = 32;

/// What is proved of the weights of one axis, while its coordinate is in one piece of [0, 1].
struct AxisPiece {
  double error = 0;                ///< of sum_l |w_l - B_l|, coordinate rounding included
  std::array<double, 4> weight{};  ///< of |w_l|
};
using AxisError = std::array<AxisPiece, kPieces>;

/// B_0 to B_3 of the uniform cubic B-spline, and their derivatives.
std::array<double, 4> bspline(double x);
std::array<double, 4> bspline_slope(double x);

/// Fixed point of any width by propagation of errors: coordinate, rounded one sixth, three
/// roundings of Horner's rule (docs/numerics.md section 7).
AxisError propagated_axis_error(int width);

/// The same of the evaluator `powers`: s^2 as the second multiplication takes it, what is cut, and
/// the roundings of three weights, all of which the fourth has.
AxisError propagated_powers_error(int width);

/// Block floating point of words of any width from 32 up, in the same way: the coordinate's word is
/// exact, and one sixth is rounded to its own word, Q2.30 (docs/numerics.md section 10).
AxisError block_axis_error(int width);

/// binary32 by propagation of errors, the steps fused or not.
AxisError binary32_axis_error(bool fused);

/// The watertight B-spline and its derivatives as a format loads them, the same on all axes.
template <class F>
model::CoefficientBank<F> bspline_bank(const char* format) {
  const WordCodec codec(format);
  const AxisWords axis = encode(watertight_bspline(codec), codec);
  model::CoefficientBank<F> bank;
  for (int a = 0; a < 3; ++a) {
    for (int l = 0; l < 4; ++l) {
      bank.load(a, l, axis.degree, axis.shift, axis.word[l]);
      bank.load_derivative(a, l, axis.degree, axis.derivative.shift, axis.derivative.word[l]);
    }
  }
  return bank;
}

/// The name of fixed point of a width, e.g. "fx18".
inline std::string fixed_name(int width) { return "fx" + std::to_string(width); }

/// A coordinate or a weight of `fxW` that counts k units.
template <int W>
double weight_value(std::int64_t k) {
  return std::ldexp(static_cast<double>(k), 2 - W);
}

/// The weights that the model computes at coordinate k units.
template <int W>
std::array<double, 4> weights_at(const model::CoefficientBank<Fixed<W>>& bank, std::int64_t k) {
  std::array<double, 4> weights{};
  for (int l = 0; l < 4; ++l) {
    weights[l] = weight_value<W>(model::polynomial<Fixed<W>>(bank, 0, l, {k, false}).value);
  }
  return weights;
}

/// Those of the evaluator `powers`.
template <int W>
std::array<double, 4> powers_at(std::int64_t k) {
  const auto computed = model::PowersBspline<Fixed<W>>::weights({k, false});
  std::array<double, 4> weights{};
  for (int l = 0; l < 4; ++l) weights[l] = weight_value<W>(computed[l].value);
  return weights;
}

/// The largest sum_l |w_l - B_l(s)| over all s that are rounded to x: the B_l are lines but for
/// reach^2 / 2 times their second derivatives, whose magnitudes sum to less than 6, and a sum of
/// magnitudes of lines is largest at an end.
inline double error_around(const std::array<double, 4>& weights, double x, double reach) {
  const std::array<double, 4> exact = bspline(x);
  const std::array<double, 4> slope = bspline_slope(x);
  double below = 0;
  double above = 0;
  for (int l = 0; l < 4; ++l) {
    below += std::abs(weights[l] - exact[l] + reach * slope[l]);
    above += std::abs(weights[l] - exact[l] - reach * slope[l]);
  }
  return std::max(below, above) + 3 * reach * reach;
}

/// From the stream's coordinate to the format's: half a unit of each.
inline double coordinate_reach(int width) { return std::ldexp(1, 1 - width) + 0x1p-32; }

/// Fixed point by looking at every coordinate, all 2^(W-2) + 1, at each of which `weights_of` says
/// what is computed.
template <int W, class Weights>
AxisError error_at_every_coordinate(const Weights& weights_of) {
  constexpr std::int64_t kLength = (std::int64_t{1} << (W - 2)) / kPieces;
  AxisError pieces;
  for (int i = 0; i < kPieces; ++i) {
    for (std::int64_t k = i * kLength; k <= (i + 1) * kLength; ++k) {
      const std::array<double, 4> weights = weights_of(k);
      const double error = error_around(weights, weight_value<W>(k), coordinate_reach(W));
      pieces[i].error = std::max(pieces[i].error, error);
      for (int l = 0; l < 4; ++l) {
        pieces[i].weight[l] = std::max(pieces[i].weight[l], std::abs(weights[l]));
      }
    }
  }
  return pieces;
}

/// That of the polynomials.
template <int W>
AxisError exhaustive_axis_error() {
  const auto bank = bspline_bank<Fixed<W>>(fixed_name(W).c_str());
  return error_at_every_coordinate<W>([&](std::int64_t k) { return weights_at<W>(bank, k); });
}

/// That of the evaluator `powers`.
template <int W>
AxisError exhaustive_powers_error() {
  return error_at_every_coordinate<W>(powers_at<W>);
}

}  // namespace hwffd::bounds
