#include "hwffd/lattice/refine.hpp"

#include <fmt/format.h>

#include <utility>

#include "hwffd/error.hpp"

namespace hwffd {
namespace {

/// A sum of two doubles, the second far smaller than the first: twice the digits of one.
struct Pair {
  double high = 0.0;
  double low = 0.0;
};

/// Knuth's sum, whose rounding is no error but the second number.
Pair operator+(const Pair& a, const Pair& b) {
  const double sum = a.high + b.high;
  const double of_b = sum - a.high;
  const double rounding = (a.high - (sum - of_b)) + (b.high - of_b);
  const double low = rounding + (a.low + b.low);
  const double high = sum + low;
  return {high, low - (high - sum)};
}

Pair scaled(const Pair& a, double power_of_two) {
  return {a.high * power_of_two, a.low * power_of_two};
}

using Pairs = Eigen::Matrix<double, Eigen::Dynamic, 6, Eigen::RowMajor>;  // x, y, z, and the rest

Pair at(const Pairs& pairs, Eigen::Index row, int component) {
  return {pairs(row, component), pairs(row, 3 + component)};
}

/// Points as [outer][n][inner], refined along n.
Pairs refined_along(const Pairs& points, Eigen::Index outer, Eigen::Index n, Eigen::Index inner) {
  const Eigen::Index m = 2 * (n - 3) + 3;
  Pairs result(outer * m * inner, 6);
  for (Eigen::Index row = 0; row < result.rows(); ++row) {
    const Eigen::Index q = row / inner % m;
    const Eigen::Index first = (row / inner / m * n + q / 2) * inner + row % inner;
    for (int c = 0; c < 3; ++c) {
      const Pair a = at(points, first, c);
      const Pair b = at(points, first + inner, c);
      Pair value;
      if (q % 2 == 0) {
        value = scaled(a + b, 0.5);
      } else {
        const Pair outside = a + at(points, first + 2 * inner, c);
        value = scaled(outside + (scaled(b, 4) + scaled(b, 2)), 0.125);
      }
      result(row, c) = value.high;
      result(row, 3 + c) = value.low;
    }
  }
  return result;
}

}  // namespace

Index3 refined_dims(const Index3& dims, const std::array<bool, 3>& axes) {
  Index3 result = dims;
  for (std::size_t a = 0; a < 3; ++a) {
    if (axes[a]) result[a] = 2 * (dims[a] - 3) + 3;
  }
  return result;
}

Lattice refined(const Lattice& lattice, const std::array<bool, 3>& axes, const Family& family) {
  if (family.kind() != Family::Kind::kBspline) {
    throw Error(fmt::format(
        "refine: knots are inserted into uniform B-splines, not into '{}'; give a lattice of the "
        "family bspline",
        family.name()));
  }
  const Index3 dims = refined_dims(lattice.dims(), axes);
  Lattice::check_dims(lattice.dims());
  for (std::size_t a = 0; a < 3; ++a) {
    if (dims[a] <= Lattice::kMaxPoints) continue;
    throw Error(fmt::format(
        "refine: {} points along {} would be {}; give at most {}, or leave that axis as it is",
        lattice.dims()[a], "stu"[a], dims[a], (Lattice::kMaxPoints - 3) / 2 + 3));
  }
  Pairs points = Pairs::Zero(lattice.points().rows(), 6);
  points.leftCols<3>() = lattice.points();
  Index3 now = lattice.dims();
  for (std::size_t a = 0; a < 3; ++a) {
    if (!axes[a]) continue;
    Eigen::Index outer = 1;
    Eigen::Index inner = 1;
    for (std::size_t b = 0; b < a; ++b) outer *= now[b];
    for (std::size_t b = a + 1; b < 3; ++b) inner *= now[b];
    points = refined_along(points, outer, now[a], inner);
    now[a] = dims[a];
  }
  return {dims, points.leftCols<3>()};
}

}  // namespace hwffd
