#pragma once

#include "hwffd/lattice/lattice.hpp"

namespace hwffd {

/// A cylinder or tube, also elliptic or slanted, as a lattice: s runs outwards from the axis, t
/// along the axis, u around it, from the first edge towards the third.
///
/// Around the axis the lattice closes by repeating points: of n_u points the last three are the
/// first three, bit for bit, so n_u - 3 cells go around and every cell still sees four points in a
/// row. The seam between the last cell and the first is C2 like any other.
///
/// The map is exactly linear in s and t. Around, the B-spline through the control points is not
/// quite a circle: it touches the cylinder in the middle of each cell and bulges a little beyond it
/// elsewhere (by 0.015 % of the radius for 13 cells, by 14 % for 3). The cylinder is so wholly
/// inside.
///
/// A solid cylinder (inner 0) has its axis on the face s = 0 of the innermost cells, where the map
/// is not invertible: all u give the same point. Its innermost layer of control points lies
/// beyond the axis, on the other side.
class Cylinder {
 public:
  /// @param base   the centre of the bottom, t = 0
  /// @param edges  3 x 3: columns are the radius at u = 0, the axis from bottom to top, and the
  ///               radius a quarter turn on
  /// @param inner  inner radius of a tube in parts of the outer, 0 to less than 1
  /// @throws Error if the edges are not finite or span no volume, or inner is out of range
  Cylinder(const Point& base, const Eigen::Matrix3d& edges, double inner = 0.0);

  /// The vertical cylinder around the bounding box's centre that holds all points (n x 3, n > 0).
  /// @param room  left free beyond the points along x, y, z
  /// @throws Error if there is no point or one is not finite
  static Cylinder around(const Points& points, const Point& room = Point::Zero());

  /// @param dims  points an axis, 4 to 64; along u at least 6
  /// @throws Error for dims out of range
  Lattice lattice(const Index3& dims) const;

 private:
  Point base_;
  Eigen::Matrix3d edges_;
  double inner_;
};

}  // namespace hwffd
