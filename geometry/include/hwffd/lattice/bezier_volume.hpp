#pragma once

#include <array>

#include "hwffd/points.hpp"

namespace hwffd {

/// A polynomial in s, t, u over the unit cube in Bernstein form, of any degrees and with any number
/// of components. It lies in the convex hull of its coefficients: what holds for them is proved of
/// all its values.
class BezierVolume {
 public:
  /// A coefficient a row: (i, j, k), 0 to the degree along s, t, u, in row
  /// (i*(degree[1] + 1) + j)*(degree[2] + 1) + k; a component a column.
  using Coefficients = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

  /// @param coefficients as many rows as the degrees demand, unchecked
  BezierVolume(const Index3& degree, Coefficients coefficients);

  /// A cell of a uniform cubic B-spline: degrees 3, components x, y, z.
  static BezierVolume of_cell(const Support& support);

  const Index3& degree() const { return degree_; }
  const Coefficients& coefficients() const { return coefficients_; }
  BezierVolume component(int column) const { return {degree_, coefficients_.col(column)}; }

  /// Row of coefficient (i, j, k).
  Eigen::Index index(const Index3& at) const {
    return (static_cast<Eigen::Index>(at[0]) * (degree_[1] + 1) + at[1]) * (degree_[2] + 1) + at[2];
  }
  /// Place of a coefficient: the inverse of index().
  Index3 place(Eigen::Index row) const;

  /// The derivative along an axis; degree there at least 1.
  BezierVolume derivative(int axis) const;

  /// The face where the coordinate along an axis is 0 (end 0) or 1 (end 1): degree 0 along it.
  BezierVolume face(int axis, int end) const;

  /// The halves [0, 1/2] and [1/2, 1] along an axis, each over the unit cube again.
  std::array<BezierVolume, 2> halves(int axis) const;

  /// The eight octants: number 4a + 2b + c is the upper half along s if a, t if b, u if c.
  std::array<BezierVolume, 8> octants() const;

  /// The quotient by x^power (end 0) or (1 - x)^power (end 1), x the coordinate along axis. The
  /// coefficients of the layers that the factor makes zero are taken as zero.
  BezierVolume without_factor(int axis, int end, int power) const;

  /// The integral over the unit cube, a component a column.
  Eigen::RowVectorXd integral() const { return coefficients_.colwise().mean(); }

 private:
  /// Rows from one coefficient to the next along an axis.
  Eigen::Index step(int axis) const;

  Index3 degree_;
  Coefficients coefficients_;
};

/// The product of two volumes of one component.
BezierVolume product(const BezierVolume& a, const BezierVolume& b);

/// det J of a map of three components, J = (dq/ds, dq/dt, dq/du); degrees 8 for a cubic map.
BezierVolume jacobian_determinant(const BezierVolume& map);

}  // namespace hwffd
