#pragma once

#include "hwffd/lattice/lattice.hpp"

namespace hwffd {

/// A ball or shell, also an ellipsoid, as a lattice: s runs outwards from the centre, t from the
/// lower pole to the upper, u around the axis between them, from the first edge towards the third.
///
/// Around the axis the lattice closes as that of a Cylinder: the last three of n_u points are the
/// first three. Along t the points one step beyond a pole are those of the other side, so the cells
/// end exactly at the poles.
///
/// The map is exactly linear in s. Along t and u it bulges beyond the ball as a Cylinder does; the
/// ball is wholly inside. Where u has no meaning (the axis between the poles, faces t = 0 and
/// t = 1 of the outer cells) and at the centre of a solid ball (s = 0) it is not invertible.
class Sphere {
 public:
  /// @param centre the centre
  /// @param edges  3 x 3: columns are the radius at the equator at u = 0, the radius to the upper
  ///               pole, and the radius at the equator a quarter turn on
  /// @param inner  inner radius of a shell in parts of the outer, 0 to less than 1
  /// @throws Error if the edges are not finite or span no volume, or inner is out of range
  Sphere(const Point& centre, const Eigen::Matrix3d& edges, double inner = 0.0);

  /// The ball around the bounding box's centre that holds all points (n x 3, n > 0).
  /// @param room  left free beyond the points along x, y, z
  /// @throws Error if there is no point or one is not finite
  static Sphere around(const Points& points, const Point& room = Point::Zero());

  /// @param dims  points an axis, 4 to 64; along t at least 5, along u at least 6
  /// @throws Error for dims out of range
  Lattice lattice(const Index3& dims) const;

 private:
  Point centre_;
  Eigen::Matrix3d edges_;
  double inner_;
};

}  // namespace hwffd
