#include "picture/camera.hpp"

#include <gtest/gtest.h>

#include <Eigen/Geometry>

#include "colours.hpp"
#include "hwffd/lattice/box.hpp"

namespace hwffd::picture {
namespace {

Points corners() {
  return Box(Point(-3, 2, 10), Point(4, 1, 7).asDiagonal()).lattice({4, 4, 4}).points();
}

TEST(Camera, LooksAtItsTargetFromItsEye) {
  Camera camera;
  camera.eye = Point(1, 2, 3);
  camera.target = Point(4, 2, 3);
  EXPECT_LE(seen_at(camera, 2.0, camera.target).norm(), 1e-12);
  EXPECT_GT(seen_at(camera, 2.0, Point(4, 2, 3.1)).x(), 0.0) << "looking along x, z is right";
  EXPECT_GT(seen_at(camera, 2.0, Point(4, 2.1, 3)).y(), 0.0) << "y is up";
  const Eigen::Vector4d seen = camera.view() * Point(6, 2, 3).homogeneous();
  EXPECT_NEAR(seen.z(), -5.0, 1e-12);
}

TEST(Camera, AngleReachesFromEdgeToEdge) {
  Camera camera;
  camera.angle = 90;
  camera.eye = Point(0, 0, 2);
  EXPECT_NEAR(seen_at(camera, 3.0, Point(0, 2, 0)).y(), 1.0, 1e-12);
  EXPECT_NEAR(seen_at(camera, 3.0, Point(6, 0, 0)).x(), 1.0, 1e-12);
}

/// Nothing is cut off, in x, y or depth, and in one direction both margins are equal and small.
TEST(Camera, AroundPointsIsAsNearAsItCanBe) {
  for (const double aspect : {0.4, 1.0, 2.5}) {
    for (const Point& from : {Point(0.3, 0.2, 1), Point(-1, 0.7, -0.2), Point(0, 0, 5)}) {
      const Camera camera = Camera::around(corners(), from, aspect);
      EXPECT_LE((camera.eye - camera.target).normalized().cross(from.normalized()).norm(), 1e-12);
      Eigen::Vector2d low(9, 9);
      Eigen::Vector2d high(-9, -9);
      for (Eigen::Index i = 0; i < corners().rows(); ++i) {
        const Point point = corners().row(i);
        low = low.cwiseMin(seen_at(camera, aspect, point));
        high = high.cwiseMax(seen_at(camera, aspect, point));
        const double depth = -(camera.view() * point.homogeneous()).z();
        EXPECT_GT(depth, camera.nearest);
        EXPECT_LT(depth, camera.farthest);
      }
      EXPECT_LE(high.maxCoeff(), 0.94 + 1e-9);
      EXPECT_GE(low.minCoeff(), -0.94 - 1e-9);
      EXPECT_NEAR((high - low).maxCoeff(), 2 * 0.94, 1e-9) << aspect << " " << from.transpose();
    }
  }
}

}  // namespace
}  // namespace hwffd::picture
