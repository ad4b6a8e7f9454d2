#include "hwffd/bounds/bound.hpp"

namespace hwffd::bounds {
namespace {

constexpr double kDouble = 1e-13;  // covers the roundings of the oracle and of these sums

/// sum |w_l w_m w_n - B_l B_m B_n|, from each axis's sum |w - B|: the B_l sum to 1.
double three_axes(double s, double t, double u) { return (1 + s) * (1 + t) * (1 + u) - 1; }

/// The products of a piece of s and one of t, and what rounding them may cost.
struct Products {
  std::array<double, 16> limit{};  // of |product| after rounding
  double rounding = 0;             // sum of the 16 errors
};

/// A product below half a unit is rounded to 0, and is then its own error.
Products products(const AxisPiece& s, const AxisPiece& t, double half) {
  Products result;
  for (int i = 0; i < 16; ++i) {
    const double exact = s.weight[i / 4] * t.weight[i % 4];
    result.limit[i] = exact < half ? 0 : exact + half;
    result.rounding += std::min(exact, half);
  }
  return result;
}

/// The sum of the errors of the 64 weights, products rounded to half a unit each.
double weights_error(const AxisPiece& s, const AxisPiece& t, const AxisPiece& u,
                     const Products& pairs, double half) {
  double rounding = pairs.rounding * (1 + u.error);
  for (const double pair : pairs.limit) {
    for (const double weight : u.weight) rounding += std::min(pair * weight, half);
  }
  return three_axes(s.error, t.error, u.error) + rounding;
}

/// The largest of that over all pieces.
double worst_weights_error(int width, const AxisError& axis) {
  const double half = std::ldexp(1, 1 - width);
  double worst = 0;
  for (const AxisPiece& s : axis) {
    for (const AxisPiece& t : axis) {
      const Products pairs = products(s, t, half);
      for (const AxisPiece& u : axis) {
        worst = std::max(worst, weights_error(s, t, u, pairs, half));
      }
    }
  }
  return worst;
}

/// Weights, points and narrowed sums of the factored form, the latter two off by `rounding` each.
double factored_error(const AxisError& axis, double rounding) {
  double error = 0;
  for (const AxisPiece& piece : axis) error = std::max(error, piece.error);
  // What an axis's weights can make of an error: the sum of their magnitudes.
  const double gain = 1 + error;
  return three_axes(error, error, error) + rounding * (gain * gain * gain + gain * gain + gain);
}

/// An error relative to 2^exponent in ulp of the largest point, which is 2^(exponent - 24) or more
/// than that; and half an ulp, from the result's rounding.
double in_ulp(double error) { return std::ldexp(error + kDouble, 24) + 0.5; }

}  // namespace

double fixed_product_bound(int width, const AxisError& axis) {
  const double weights = worst_weights_error(width, axis);
  // A point: at most a unit of Q1.(W-1), at the top where it saturates. The output: one of Q1.31.
  return weights + (1 + weights) * std::ldexp(1, 1 - width) + 0x1p-31 + kDouble;
}

double fixed_factored_bound(int width, const AxisError& axis) {
  // Points and twice narrowed sums: at most a unit of Q1.(W-1) each, at the top where it saturates.
  return factored_error(axis, std::ldexp(1, 1 - width)) + 0x1p-31 + kDouble;
}

double block_product_bound(int width, const AxisError& axis) {
  const double weights = worst_weights_error(width, axis);
  return in_ulp(weights + (1 + weights) * std::ldexp(1, -width));
}

double block_factored_bound(int width, const AxisError& axis) {
  return in_ulp(factored_error(axis, std::ldexp(1, -width)));
}

double binary32_product_bound(int n, bool fused) {
  double axis = 0;
  for (const AxisPiece& piece : binary32_axis_error(fused)) axis = std::max(axis, piece.error);
  constexpr double kUnit = 0x1p-24;
  // Roundings that a term meets: two of its weight, its own, and those of the sums behind it. One
  // after the other the first term is added to 0, exactly, and in a tree each meets six additions.
  // A fused operation spares some terms their own rounding, but not the one that counts.
  const int roundings = 3 + (n == 1 ? 63 : 6);
  const double gamma = roundings * kUnit / (1 - roundings * kUnit);
  const double weights = three_axes(axis, axis, axis);
  const double point = 0x1p-25;
  // Underflow: an absolute 2^-150 for each of less than 2^10 operations.
  return weights + (1 + weights) * (point + gamma * (1 + point)) + 0x1p-140 + kDouble;
}

}  // namespace hwffd::bounds
