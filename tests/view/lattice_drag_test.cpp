#include "view/lattice_drag.hpp"

#include <gtest/gtest.h>

#include "hwffd/lattice/around.hpp"
#include "hwffd/lattice/closure.hpp"

namespace hwffd::view {
namespace {

const Points kCube = (Points(2, 3) << -1, -1, -1, 1, 1, 1).finished();

/// Looks along z at the middle of the box: no two of its points are seen in one place.
Screen screen() {
  picture::Camera camera;
  camera.eye = Point(0, 0, 16);
  return Screen(camera, 800, 600);
}

Pixels seen(const Screen& screen, const Point& point) { return screen.project(point)->place; }

/// Rows in which two lattices differ, by more than rounding.
std::vector<Eigen::Index> moved(const Lattice& a, const Lattice& b) {
  std::vector<Eigen::Index> rows;
  for (Eigen::Index row = 0; row < a.points().rows(); ++row) {
    if ((a.points().row(row) - b.points().row(row)).norm() > 1e-9) rows.push_back(row);
  }
  return rows;
}

TEST(LatticeDrag, EveryPointOfABoxFollowsTheMouseInThePlaneOfTheScreen) {
  const Lattice box = lattice_around("box", kCube, {4, 4, 4});
  const Screen view = screen();
  for (Eigen::Index row = 0; row < 64; ++row) {
    LatticeDrag drag(box, Family());
    const Point before = box.points().row(row);
    const Pixels mouse = seen(view, before) + Pixels(1, -1);
    ASSERT_TRUE(drag.grab(view, mouse)) << row;
    drag.drag(view, mouse + Pixels(5, 5));  // the way there does not matter
    drag.drag(view, mouse + Pixels(40, -25));
    ASSERT_EQ(moved(box, drag.lattice()), std::vector<Eigen::Index>{row});
    const Point after = drag.lattice().points().row(row);
    EXPECT_LT((seen(view, after) - seen(view, before) - Pixels(40, -25)).norm(), 1e-6) << row;
    EXPECT_NEAR(after.z(), before.z(), 1e-9) << "the plane through the point";
    EXPECT_GT(after.x(), before.x());
    EXPECT_GT(after.y(), before.y());
  }
}

TEST(LatticeDrag, WithoutAPointInReachNothingMoves) {
  const Lattice box = lattice_around("box", kCube, {4, 4, 4});
  const Screen view = screen();
  LatticeDrag drag(box, Family());
  const Pixels corner = seen(view, box.point(0, 0, 3));
  EXPECT_TRUE(drag.grab(view, corner + Pixels(-LatticeDrag::kReach + 0.1, 0)));
  drag.release();
  EXPECT_FALSE(drag.grab(view, corner + Pixels(-LatticeDrag::kReach - 0.1, 0)));
  EXPECT_FALSE(drag.holds());
  drag.drag(view, corner);
  EXPECT_TRUE(moved(box, drag.lattice()).empty());
}

TEST(LatticeDrag, OfPointsInOnePlaceTheNearestToTheEyeIsHeld) {
  const Lattice box = lattice_around("box", kCube, {4, 4, 4});
  picture::Camera camera;
  const Point corner = box.point(0, 0, 3);
  camera.eye = corner + 4 * (corner - box.point(0, 0, 0));  // along the edge behind it
  camera.target = corner;
  const Screen view(camera, 800, 600);
  LatticeDrag drag(box, Family());
  ASSERT_TRUE(drag.grab(view, Pixels(400, 300)));
  drag.drag(view, Pixels(420, 300));
  EXPECT_EQ(moved(box, drag.lattice()), std::vector<Eigen::Index>{box.index(0, 0, 3)});
}

TEST(LatticeDrag, ReleasedPointsStayAndAResetBringsThemBack) {
  const Lattice box = lattice_around("box", kCube, {4, 4, 4});
  const Screen view = screen();
  LatticeDrag drag(box, Family());
  for (const Eigen::Index row : {3, 60}) {
    const Pixels mouse = seen(view, drag.lattice().points().row(row));
    ASSERT_TRUE(drag.grab(view, mouse));
    drag.drag(view, mouse + Pixels(30, 0));
    drag.release();
    drag.drag(view, mouse + Pixels(90, 0));
  }
  EXPECT_EQ(moved(box, drag.lattice()), (std::vector<Eigen::Index>{3, 60}));
  drag.reset();
  EXPECT_TRUE(moved(box, drag.lattice()).empty());
  EXPECT_FALSE(drag.holds());
}

TEST(LatticeDrag, JointsOfACylinderStayClosed) {
  const Lattice cylinder = lattice_around("cylinder", kCube, {4, 4, 9});
  ASSERT_TRUE(Closure(cylinder).closed(2));
  const Screen view = screen();
  LatticeDrag drag(cylinder, Family());
  // Point 0 along u is also point 6.
  const Pixels mouse = seen(view, cylinder.point(3, 3, 6));
  ASSERT_TRUE(drag.grab(view, mouse));
  drag.drag(view, mouse + Pixels(30, 10));
  EXPECT_TRUE(Closure(drag.lattice()).closed(2));
  EXPECT_EQ(moved(cylinder, drag.lattice()),
            (std::vector<Eigen::Index>{cylinder.index(3, 3, 0), cylinder.index(3, 3, 6)}));
}

TEST(LatticeDrag, JointsOfOtherFamiliesStayClosedToo) {
  for (const std::string& name : Family::names()) {
    const Family family = Family::parse(name);
    const Index3 dims{4, 4, 13};
    const Lattice cylinder = lattice_around("cylinder", kCube, std::optional<Index3>(dims), family);
    const Closure closure(cylinder, family);
    ASSERT_TRUE(closure.closed(2)) << name;
    const int last = dims[2] - 1;
    const int first = last % (dims[2] - closure.repeated(2));  // the same point
    const Screen view = screen();
    for (const int k : {first, last}) {
      LatticeDrag drag(cylinder, family);
      const Pixels mouse = seen(view, cylinder.point(3, 3, k));
      ASSERT_TRUE(drag.grab(view, mouse)) << name;
      drag.drag(view, mouse + Pixels(30, 10));
      EXPECT_TRUE(Closure(drag.lattice(), family).closed(2)) << name;
      EXPECT_EQ(
          moved(cylinder, drag.lattice()),
          (std::vector<Eigen::Index>{cylinder.index(3, 3, first), cylinder.index(3, 3, last)}))
          << name;
    }
  }
}

}  // namespace
}  // namespace hwffd::view
