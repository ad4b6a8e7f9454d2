#include "hwffd/lattice/closure.hpp"

#include <gtest/gtest.h>

#include <random>

#include "errors.hpp"
#include "hwffd/lattice/box.hpp"
#include "hwffd/lattice/cylinder.hpp"
#include "hwffd/lattice/sphere.hpp"

namespace hwffd {
namespace {

const Eigen::Matrix3d kUnit = Eigen::Matrix3d::Identity();

/// The joints as text: axes that are closed, faces with the axis along which they are collapsed.
std::string joints(const Closure& closure) {
  std::string text;
  for (int a = 0; a < 3; ++a) {
    if (closure.closed(a)) text += std::string("closed ") + "stu"[a] + ";";
  }
  for (const Closure::Collapsed& face : closure.collapsed()) {
    text += std::string(" ") + "stu"[face.axis] + "=" + "01"[face.end] + " along " +
            "stu"[face.along] + ";";
  }
  return text;
}

/// Every point moved by itself, which tears the joints.
Lattice moved(const Lattice& lattice) {
  std::mt19937_64 random(3);
  Points points = lattice.points();
  for (Eigen::Index i = 0; i < points.size(); ++i) {
    points.data()[i] += 0.1 * (static_cast<double>(random() >> 11) * 0x1p-52 - 1);
  }
  return Lattice(lattice.dims(), points);
}

TEST(Closure, FindsJoints) {
  EXPECT_FALSE(Closure(Box(Point::Zero(), kUnit).lattice({4, 5, 6})).joined());
  EXPECT_TRUE(Closure(Cylinder(Point::Ones(), kUnit).lattice({4, 5, 6})).joined());
  EXPECT_EQ(joints(Closure(Box(Point::Zero(), kUnit).lattice({4, 5, 6}))), "");
  EXPECT_EQ(joints(Closure(Cylinder(Point::Ones(), kUnit).lattice({4, 5, 6}))),
            "closed u; s=0 along u;");
  EXPECT_EQ(joints(Closure(Cylinder(Point::Ones(), kUnit, 0.3).lattice({4, 5, 6}))), "closed u;");
  EXPECT_EQ(joints(Closure(Sphere(Point::Ones(), kUnit).lattice({4, 5, 6}))),
            "closed u; s=0 along t; s=0 along u; t=0 along u; t=1 along u;");
  EXPECT_EQ(joints(Closure(Sphere(Point::Ones(), kUnit, 0.3).lattice({4, 5, 6}))),
            "closed u; t=0 along u; t=1 along u;");
}

TEST(Closure, TornJointsAreFoundTorn) {
  const Lattice ball = Sphere(Point::Ones(), kUnit).lattice({5, 6, 9});
  EXPECT_EQ(joints(Closure(moved(ball))), "");
  const Closure closure(ball);
  EXPECT_EQ(joints(Closure(closure.restore(moved(ball)))), joints(closure));
  const Lattice tube = Cylinder(Point::Ones(), kUnit).lattice({4, 7, 8});
  EXPECT_EQ(joints(Closure(Closure(tube).restore(moved(tube)))), joints(Closure(tube)));
}

TEST(Closure, RestoreLeavesTheRestAlone) {
  const Lattice box = Box(Point::Zero(), kUnit).lattice({4, 5, 6});
  EXPECT_EQ(Closure(box).restore(moved(box)).points(), moved(box).points());
  const Lattice tube = Cylinder(Point::Ones(), kUnit).lattice({4, 5, 8});
  const Lattice restored = Closure(tube).restore(moved(tube));
  for (int i = 1; i < 4; ++i) {
    for (int k = 0; k < 5; ++k) {
      EXPECT_EQ(restored.point(i, 2, k), moved(tube).point(i, 2, k));
      EXPECT_NE(restored.point(i, 2, k), tube.point(i, 2, k));
    }
  }
}

TEST(Closure, RefusesOtherDimensions) {
  const Lattice tube = Cylinder(Point::Ones(), kUnit).lattice({4, 5, 8});
  const Lattice other = Cylinder(Point::Ones(), kUnit).lattice({5, 5, 8});
  EXPECT_ERROR(Closure(tube).restore(other),
               "lattice to close has 5 x 5 x 8 points; give 4 x 5 x 8");
}

}  // namespace
}  // namespace hwffd
