#include "hwffd/bounds/axis_error.hpp"

namespace hwffd::bounds {
namespace {

constexpr double kRoundoff = 0x1p-24;  // binary32: a rounding's largest relative error

/// How each watertight B_l(x) changes with the rounded sixth.
std::array<double, 4> by_sixth(double x) {
  const double cube = x * x * x;
  return {1 - cube, -2 + 3 * cube, 1 - 3 * cube, cube};
}

double sum_of_magnitudes(const std::array<double, 4>& values) {
  double sum = 0;
  for (const double value : values) sum += std::abs(value);
  return sum;
}

/// For functions that are largest at an end of a piece: those of docs/numerics.md section 7 are.
template <class Function>
double at_worse_end(double low, double high, const Function& function) {
  return std::max(function(low), function(high));
}

double largest_slope(double low, double high) {
  return at_worse_end(low, high, [](double x) { return sum_of_magnitudes(bspline_slope(x)); });
}

double weight_limit(double low, double high, int l) {
  return at_worse_end(low, high, [l](double x) { return bspline(x)[l]; });
}

/// |v| where v = c0 + x(c1 + x(c2 + x c3)) is evaluated up to the power given, x in [low, high].
double partial_limit(const std::array<double, 4>& c, int power, double low, double high) {
  double least = c[3];
  double most = c[3];
  for (int p = 2; p >= power; --p) {
    const double smallest = std::min(least * low, least * high);
    const double largest = std::max(most * low, most * high);
    least = c[p] + smallest;
    most = c[p] + largest;
  }
  return std::max(std::abs(least), std::abs(most));
}

/// The error of Horner's rule in binary32: each step rounds the product (unless it is fused) and
/// the sum.
double binary32_horner(const std::array<double, 4>& c, double low, double high, bool fused) {
  double error = 0;
  for (int power = 2; power >= 0; --power) {
    const double product = high * (partial_limit(c, power + 1, low, high) + error);
    const double before = high * error + (fused ? 0 : kRoundoff * product);
    error = before + kRoundoff * (partial_limit(c, power, low, high) + before);
  }
  return error;
}

template <class ErrorOfWeight>
AxisError of_pieces(double reach, const ErrorOfWeight& error_of_weight) {
  AxisError pieces;
  for (int i = 0; i < kPieces; ++i) {
    const double low = static_cast<double>(i) / kPieces;
    const double high = static_cast<double>(i + 1) / kPieces;
    pieces[i].error = reach * largest_slope(low, high) + 3 * reach * reach;
    for (int l = 0; l < 4; ++l) {
      const double error = error_of_weight(low, high, l);
      pieces[i].error += error;
      pieces[i].weight[l] = weight_limit(low, high, l) + error;
    }
  }
  return pieces;
}

/// Horner's rule in fixed point, each step rounded by half a unit; `sixth` is the error of one
/// sixth.
AxisError of_fixed_horner(double reach, double unit, double sixth) {
  return of_pieces(reach, [=](double low, double high, int l) {
    const double by = at_worse_end(low, high, [l](double x) { return std::abs(by_sixth(x)[l]); });
    return sixth * by + unit / 2 * (1 + high + high * high);
  });
}

}  // namespace

std::array<double, 4> bspline(double x) {
  const double y = 1 - x;
  return {y * y * y / 6, (4 - 6 * x * x + 3 * x * x * x) / 6, (4 - 6 * y * y + 3 * y * y * y) / 6,
          x * x * x / 6};
}

std::array<double, 4> bspline_slope(double x) {
  return {-(1 - x) * (1 - x) / 2, x * (3 * x - 4) / 2, (1 - x) * (1 + 3 * x) / 2, x * x / 2};
}

AxisError propagated_axis_error(int width) {
  const double unit = std::ldexp(1, 2 - width);
  return of_fixed_horner(coordinate_reach(width), unit, unit / 3);
}

AxisError propagated_powers_error(int width) {
  const double unit = std::ldexp(1, 2 - width);
  const double cut = unit / 8;   // of a power
  const double last = unit / 8;  // of a sixth of the cube, and of one sixth itself: cuts of 1/64
  return of_pieces(coordinate_reach(width), [=](double, double high, int l) {
    const double of_cube = high * unit / 2 + cut;
    const double of_sixth = of_cube / 6 + last;
    const std::array<double, 4> cuts{cut / 2 + last + of_sixth, cut + 2 * last + of_cube / 2,
                                     cut / 2 + last + of_cube / 2, of_sixth};
    return cuts[l] + unit / 2 * (l == 1 ? 3 : 1);
  });
}

AxisError block_axis_error(int width) {
  const double unit = std::ldexp(1, 2 - width);
  return of_fixed_horner(unit / 2, unit, 0x1p-30 / 3);
}

AxisError binary32_axis_error(bool fused) {
  const Blending blending = watertight_bspline(WordCodec("fp32"));
  return of_pieces(0x1p-25, [&](double low, double high, int l) {
    const double sixth =
        at_worse_end(low, high, [l](double x) { return std::abs(by_sixth(x)[l]); });
    return 0x1p-24 / 3 * sixth + binary32_horner(blending.coefficient[l], low, high, fused);
  });
}

}  // namespace hwffd::bounds
