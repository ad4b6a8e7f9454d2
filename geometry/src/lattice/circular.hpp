#pragma once

#include <Eigen/Core>

#include "hwffd/points.hpp"

namespace hwffd {

/// What cylinders and spheres have in common: control points on a circle or an arc, and layers
/// around an axis or a centre.
///
/// A cubic B-spline with its control points `step` radians apart on a circle runs inside that
/// circle. round_radius() is the radius of the control points for which the curve stays outside
/// the unit circle and touches it: in the middle between knots, where it comes closest.
double round_radius(double step);

/// A shape around the bounding box of points: centre, half the extent along each axis, and the
/// largest distance from the centre, of all axes or without the vertical one.
struct Surround {
  Point centre;
  Point half;
  double radius = 0.0;             ///< from the centre
  double horizontal_radius = 0.0;  ///< from the vertical line through the centre
};

/// @param room  left free beyond the points along x, y, z
/// @throws Error if there is no point or one is not finite
Surround surround(const Points& points, const Point& room);

/// Throws Error unless inner is in [0, 1).
void check_inner(const char* shape, double inner);

/// Throws Error if an axis that goes around has too few points.
void check_round(const char* shape, const Index3& dims, int axis, int minimum);

/// Distance of layer i of n from the axis or centre, where inner and 1 bound the cells.
double layer_radius(int i, int n, double inner);

}  // namespace hwffd
