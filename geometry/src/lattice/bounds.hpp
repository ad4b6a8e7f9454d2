#pragma once

#include "hwffd/points.hpp"

namespace hwffd {

/// The middle of the bounding box of points.
inline Point middle_of(const Points& points) {
  return (points.colwise().minCoeff() + points.colwise().maxCoeff()) / 2;
}

/// The distance from a point to the box between two corners; 0 inside.
inline double distance_to_box(const Point& point, const Point& low, const Point& high) {
  return (low - point).cwiseMax(point - high).cwiseMax(0.0).norm();
}

}  // namespace hwffd
