#pragma once

#include <optional>

#include "hwffd/points.hpp"
#include "picture/camera.hpp"

namespace hwffd::view {

/// A place on the screen: pixels from the left and from the top.
using Pixels = Eigen::Vector2d;

/// A camera's picture of a certain size: where points are seen, and back.
class Screen {
 public:
  /// @param width, height  in pixels, greater than 0
  Screen(const picture::Camera& camera, int width, int height);

  /// Where a point is seen, and its depth: its distance from the eye along the view.
  struct Seen {
    Pixels place;
    double depth;
  };
  /// Nothing for a point that is not in front of the eye.
  std::optional<Seen> project(const Point& point) const;

  /// The point that is seen there at this depth.
  Point unproject(const Pixels& place, double depth) const;

 private:
  Eigen::Matrix4d view_;
  double scale_;  ///< pixels for a slope of 1 from the view's axis
  Pixels middle_;
};

}  // namespace hwffd::view
