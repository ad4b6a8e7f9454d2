#include "view/screen.hpp"

#include <Eigen/Geometry>

namespace hwffd::view {

Screen::Screen(const picture::Camera& camera, int width, int height)
    : view_(camera.view()),
      scale_(camera.projection(1.0)(1, 1) * height / 2),
      middle_(width / 2.0, height / 2.0) {}

std::optional<Screen::Seen> Screen::project(const Point& point) const {
  const Eigen::Vector4d eye = view_ * point.homogeneous();
  const double depth = -eye.z();
  if (depth <= 0) return std::nullopt;
  return Seen{middle_ + scale_ / depth * Pixels(eye.x(), -eye.y()), depth};
}

Point Screen::unproject(const Pixels& place, double depth) const {
  const Pixels slope = (place - middle_) / scale_;
  const Point eye(depth * slope.x(), -depth * slope.y(), -depth);
  return view_.topLeftCorner<3, 3>().transpose() * (eye - view_.topRightCorner<3, 1>());
}

}  // namespace hwffd::view
