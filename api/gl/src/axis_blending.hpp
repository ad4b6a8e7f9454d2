#pragma once

#include "hwffd/device/device.hpp"

namespace hwffd::gl {

/// The blending functions of one axis: degree + 1 of them, so that many control points in a row
/// make a cell, and n points make n - degree cells.
class AxisBlending {
 public:
  static constexpr int kMaxDegree = 3;
  /// A core keeps lattices of at most 16 points an axis, 13 cells.
  static constexpr int kMaxCells = kAxisPoints - kMaxDegree;

  /// Bernstein polynomials.
  /// @param degree  0 to 3
  static AxisBlending bernstein(int degree);

  /// Functions as polynomials, row l of the matrix function l, columns the powers. Those of the
  /// uniform cubic B-spline within the rounding of GLfloat become exactly these, which devices
  /// evaluate watertight (docs/numerics.md section 5).
  AxisBlending(int degree, const Oracle::Coefficients& coefficients);

  int degree() const { return degree_; }
  const Oracle::Coefficients& coefficients() const { return coefficients_; }

  /// Cells of an axis of so many points; below 1 if they are too few for these functions.
  int cells(int points) const { return points - degree_; }
  /// Whether a device has room for an axis of so many points.
  bool fits(int points) const { return cells(points) >= 1 && cells(points) <= kMaxCells; }

 private:
  int degree_;
  Oracle::Coefficients coefficients_;
};

/// The blending functions of the three axes.
using VolumeBlending = std::array<AxisBlending, 3>;

}  // namespace hwffd::gl
