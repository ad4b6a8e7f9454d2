#pragma once

#include <Eigen/Core>

#include "hwffd/points.hpp"

namespace hwffd::picture {

/// A view in perspective: what OpenGL's two matrices say, right-handed, depth -1 (near) to 1.
struct Camera {
  Point eye{0, 0, 1};
  Point target{0, 0, 0};  ///< in the middle of the picture; not the eye
  Point up{0, 1, 0};      ///< towards the upper edge; not along the view
  double angle = 30.0;    ///< degrees from the lower edge to the upper
  double nearest = 0.1;   ///< depths between which things are drawn, positive
  double farthest = 10.0;

  /// The camera nearest to the points that has all of them in its picture, with a margin; up is y.
  /// @param points  n x 3, n > 0, not all equal
  /// @param from    where the eye is, seen from the points; not zero, not vertical
  /// @param aspect  width by height of the picture
  static Camera around(const Points& points, const Point& from, double aspect);

  /// From object space to the eye's: x right, y up, the view along -z.
  Eigen::Matrix4d view() const;
  /// From the eye's space to clip coordinates.
  Eigen::Matrix4d projection(double aspect) const;
};

}  // namespace hwffd::picture
