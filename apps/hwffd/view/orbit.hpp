#pragma once

#include "hwffd/points.hpp"
#include "picture/camera.hpp"

namespace hwffd::view {

/// A camera that turns around what it looks at; up stays y.
class Orbit {
 public:
  /// Begins with all points in the picture, see Camera::around().
  Orbit(const Points& points, const Point& from, double aspect);

  /// Turns by angles in radians: what is seen goes to the right and down. Straight above and below
  /// it stops.
  void turn(double right, double down);
  /// Comes nearer by a factor above 1, goes away by one below; within limits.
  void zoom(double factor);

  picture::Camera camera() const;

 private:
  Point target_;
  double size_;  ///< of all points
  double distance_;
  double angle_;      ///< about the y axis
  double elevation_;  ///< above the horizon
};

}  // namespace hwffd::view
