#include "view/screen.hpp"

#include <gtest/gtest.h>

#include <Eigen/Geometry>

namespace hwffd::view {
namespace {

/// From (0, 0, 2) with a right angle: at z = 0 a height of 400 pixels shows -2 to 2.
picture::Camera straight() {
  picture::Camera camera;
  camera.angle = 90;
  camera.eye = Point(0, 0, 2);
  return camera;
}

TEST(Screen, PointsAreSeenWhereTheyBelong) {
  const Screen screen(straight(), 600, 400);
  const std::optional<Screen::Seen> seen = screen.project(Point(1, 0.5, 0));
  ASSERT_TRUE(seen);
  EXPECT_NEAR(seen->place.x(), 300 + 100, 1e-9);  // right
  EXPECT_NEAR(seen->place.y(), 200 - 50, 1e-9);   // up; rows run from the top
  EXPECT_NEAR(seen->depth, 2, 1e-12);
  EXPECT_NEAR(screen.project(Point(1, 0.5, 1))->place.x(), 300 + 200, 1e-9);  // nearer
}

TEST(Screen, NothingIsSeenBehindTheEye) {
  const Screen screen(straight(), 600, 400);
  EXPECT_FALSE(screen.project(Point(0, 0, 2)));
  EXPECT_FALSE(screen.project(Point(1, 1, 5)));
}

TEST(Screen, AgreesWithTheMatricesOfOpenGl) {
  picture::Camera camera;
  camera.eye = Point(3, 2, 4);
  camera.target = Point(0.5, -0.2, 0.1);
  const Screen screen(camera, 640, 480);
  const Point point(0.3, 0.7, -0.4);
  const Eigen::Vector4d clip =
      camera.projection(640.0 / 480.0) * camera.view() * point.homogeneous();
  const std::optional<Screen::Seen> seen = screen.project(point);
  ASSERT_TRUE(seen);
  EXPECT_NEAR(seen->place.x(), (1 + clip.x() / clip.w()) / 2 * 640, 1e-9);
  EXPECT_NEAR(seen->place.y(), (1 - clip.y() / clip.w()) / 2 * 480, 1e-9);
  EXPECT_LT((screen.unproject(seen->place, seen->depth) - point).norm(), 1e-12);
}

}  // namespace
}  // namespace hwffd::view
