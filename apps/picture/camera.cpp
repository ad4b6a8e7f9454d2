#include "picture/camera.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

namespace hwffd::picture {
namespace {

constexpr double kRadiansPerDegree = 3.14159265358979323846 / 180.0;
constexpr double kFilled = 0.94;  // of the picture's width or height, by what is looked at

/// Rows: right, up, and back to the eye.
Eigen::Matrix3d axes(const Point& back, const Point& up) {
  Eigen::Matrix3d rows;
  rows.row(2) = back.normalized();
  rows.row(0) = up.cross(back).normalized();
  rows.row(1) = rows.row(2).cross(rows.row(0));
  return rows;
}

double slope(double angle) { return std::tan(angle / 2 * kRadiansPerDegree); }

}  // namespace

Camera Camera::around(const Points& points, const Point& from, double aspect) {
  Camera camera;
  const Eigen::Matrix3d rows = axes(from, camera.up);
  const Points seen = points * rows.transpose();
  // A point is inside the right edge if x + slope*z <= eye_x + slope*eye_z, inside the left one if
  // -x + slope*z <= -eye_x + slope*eye_z; so the greatest of both sides place the eye.
  Point eye = Point::Constant(-HUGE_VAL);
  for (const int axis : {0, 1}) {
    const double edge = kFilled * slope(camera.angle) * (axis == 0 ? aspect : 1.0);
    const double above = (seen.col(axis) + edge * seen.col(2)).maxCoeff();
    const double below = (-seen.col(axis) + edge * seen.col(2)).maxCoeff();
    eye[axis] = (above - below) / 2;
    eye.z() = std::max(eye.z(), (above + below) / (2 * edge));
  }
  const double front_z = seen.col(2).maxCoeff();
  const double back_z = seen.col(2).minCoeff();
  camera.eye = rows.transpose() * eye;
  camera.target = rows.transpose() * Point(eye.x(), eye.y(), (front_z + back_z) / 2);
  const double depth = eye.z() - back_z;
  camera.nearest = std::max((eye.z() - front_z) / 2, depth / 100);
  camera.farthest = 2 * depth;
  return camera;
}

Eigen::Matrix4d Camera::view() const {
  const Eigen::Matrix3d rows = axes(eye - target, up);
  Eigen::Matrix4d matrix = Eigen::Matrix4d::Identity();
  matrix.topLeftCorner<3, 3>() = rows;
  matrix.topRightCorner<3, 1>() = -rows * eye;
  return matrix;
}

Eigen::Matrix4d Camera::projection(double aspect) const {
  const double edge = slope(angle);
  Eigen::Matrix4d matrix = Eigen::Matrix4d::Zero();
  matrix(0, 0) = 1 / (edge * aspect);
  matrix(1, 1) = 1 / edge;
  matrix(2, 2) = (farthest + nearest) / (nearest - farthest);
  matrix(2, 3) = 2 * farthest * nearest / (nearest - farthest);
  matrix(3, 2) = -1;
  return matrix;
}

}  // namespace hwffd::picture
