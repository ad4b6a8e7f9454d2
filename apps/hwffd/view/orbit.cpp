#include "view/orbit.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

namespace hwffd::view {
namespace {

constexpr double kSteepest = 1.5;  // radians
constexpr double kNearest = 0.2;   // of the size of all points
constexpr double kFarthest = 10;   // of the same

}  // namespace

Orbit::Orbit(const Points& points, const Point& from, double aspect) {
  const picture::Camera camera = picture::Camera::around(points, from, aspect);
  target_ = camera.target;
  size_ = (points.colwise().maxCoeff() - points.colwise().minCoeff()).norm();
  const Point back = camera.eye - camera.target;
  distance_ = back.norm();
  angle_ = std::atan2(back.x(), back.z());
  elevation_ = std::asin(back.y() / distance_);
}

void Orbit::turn(double right, double down) {
  angle_ -= right;
  elevation_ = std::clamp(elevation_ + down, -kSteepest, kSteepest);
}

void Orbit::zoom(double factor) {
  distance_ = std::clamp(distance_ / factor, kNearest * size_, kFarthest * size_);
}

picture::Camera Orbit::camera() const {
  picture::Camera camera;
  camera.target = target_;
  camera.eye =
      target_ + distance_ * Point(std::cos(elevation_) * std::sin(angle_), std::sin(elevation_),
                                  std::cos(elevation_) * std::cos(angle_));
  camera.nearest = std::max(distance_ - 2 * size_, distance_ / 100);
  camera.farthest = distance_ + 4 * size_;
  return camera;
}

}  // namespace hwffd::view
