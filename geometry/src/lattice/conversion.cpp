#include "hwffd/lattice/conversion.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>

#include "hwffd/error.hpp"

namespace hwffd {

Eigen::Matrix4d conversion(const Eigen::Matrix4d& from, const Eigen::Matrix4d& to) {
  const Eigen::FullPivLU<Eigen::Matrix4d> solver(to.transpose());
  if (!to.allFinite() || !solver.isInvertible()) {
    throw Error(
        "control points cannot be converted to these blending functions: they do not span the "
        "cubics; use a family of degree 3");
  }
  return solver.solve(from.transpose());
}

Support convert(const Support& support, const std::array<Eigen::Matrix4d, 3>& axes) {
  Support now = support;
  for (int axis = 0; axis < 3; ++axis) {
    const int step = 16 >> (2 * axis);  // rows between neighbours along the axis
    const Support before = now;
    for (int p = 0; p < 64; ++p) {
      const int at = p / step % 4;
      const int first = p - at * step;
      now.row(p).setZero();
      for (int l = 0; l < 4; ++l) now.row(p) += axes[axis](at, l) * before.row(first + l * step);
    }
  }
  return now;
}

Operations conversion_operations(const std::array<Eigen::Matrix4d, 3>& axes) {
  constexpr double kTiny = 1e-12;
  constexpr int kRows = 16 * 3;  // of four numbers, along one axis
  Operations total;
  for (const Eigen::Matrix4d& axis : axes) {
    for (int row = 0; row < 4; ++row) {
      int terms = 0;
      for (int column = 0; column < 4; ++column) {
        const double size = std::abs(axis(row, column));
        if (size < kTiny) continue;
        ++terms;
        if (std::abs(size - 1) >= kTiny) total.multiplications += kRows;
      }
      total.additions += kRows * std::max(terms - 1, 0);
    }
  }
  return total;
}

}  // namespace hwffd
