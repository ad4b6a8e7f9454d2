// Lattices: order of their points, joints to themselves, and what lies between two of them.

#include "hwffd/lattice/lattice.hpp"

#include <gtest/gtest.h>

#include <limits>
#include <random>

#include "errors.hpp"
#include "hwffd/lattice/around.hpp"
#include "hwffd/lattice/box.hpp"
#include "hwffd/lattice/closure.hpp"
#include "hwffd/lattice/cylinder.hpp"
#include "hwffd/lattice/deformation.hpp"
#include "hwffd/lattice/sphere.hpp"
#include "same_bits.hpp"
#include "uniform.hpp"

namespace hwffd {
namespace {

/// Point (i, j, k) at (i, 10 j, 100 k), filled in the documented order.
Lattice numbered(const Index3& dims) {
  Points points(dims[0] * dims[1] * dims[2], 3);
  Eigen::Index row = 0;
  for (const auto& [i, j, k] : places(dims)) points.row(row++) << i, 10 * j, 100 * k;
  return Lattice(dims, points);
}

TEST(Lattice, OrderOfPoints) {
  const Lattice lattice = numbered({4, 5, 6});
  EXPECT_EQ(lattice.index(0, 0, 1), 1);
  EXPECT_EQ(lattice.index(0, 1, 0), 6);
  EXPECT_EQ(lattice.index(1, 0, 0), 30);
  EXPECT_EQ(lattice.index(3, 4, 5), 119);
  EXPECT_EQ(lattice.point(3, 2, 5), Point(3, 20, 500));
  EXPECT_EQ(lattice.cells(), (Index3{1, 2, 3}));
}

TEST(Lattice, SupportOfEveryCell) {
  const Lattice lattice = numbered({5, 6, 8});
  int checked = 0;
  for (const auto& [a, b, c] : places(lattice.cells())) {
    const Support support = lattice.support({a, b, c});
    for (int row = 0; row < 64; ++row) {
      const Index3 at{a + row / 16, b + row / 4 % 4, c + row % 4};
      const Point expected(at[0], 10 * at[1], 100 * at[2]);
      EXPECT_EQ(Point(support.row(row)), expected);
      ++checked;
    }
  }
  EXPECT_EQ(checked, 2 * 3 * 5 * 64);
}

TEST(Lattice, RefusesDimensions) {
  for (const Index3& dims : {Index3{1, 4, 4}, Index3{4, 65, 4}, Index3{4, 4, -1}}) {
    const std::string text = message_of<Error>([&] { Lattice(dims, Points(0, 3)); });
    expect_part(text, "each axis takes 2 to 64 points");
    expect_part(text, std::to_string(dims[0]) + " x " + std::to_string(dims[1]));
  }
  EXPECT_EQ(numbered({16, 16, 16}).points().rows(), 4096);
}

TEST(Lattice, RefusesPoints) {
  EXPECT_ERROR(Lattice({4, 4, 5}, Points::Zero(64, 3)),
               "lattice of 4 x 4 x 5 points: 64 points given; give 80");
  Points points = Points::Zero(64, 3);
  points(17, 2) = std::numeric_limits<double>::quiet_NaN();
  EXPECT_ERROR(Lattice({4, 4, 4}, points),
               "lattice point 17 is not finite; give finite coordinates");
  points(17, 2) = 0;
  points(17, 1) = -1e154;
  EXPECT_ERROR(Lattice({4, 4, 4}, points),
               "lattice point 17 has a coordinate beyond 1e+100; give smaller ones");
}

TEST(Lattice, RefusesCells) {
  const Lattice lattice = numbered({4, 5, 6});
  for (const Index3& cell : {Index3{1, 0, 0}, Index3{0, 2, 0}, Index3{0, 0, 3}, Index3{0, 0, -1}}) {
    EXPECT_ERROR_PART(lattice.support(cell), "is outside the lattice; it has 1 x 2 x 3 cells");
  }
}

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
    points.data()[i] += 0.1 * (2 * unit(random) - 1);
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

// Far from the origin coordinates are rounded by more than 1e-12 of the size.
TEST(Closure, FindsJointsFarFromTheOrigin) {
  for (const double far : {1e3, 1e6, 1e9}) {
    const Lattice ball = Sphere(Point(far, -far, 1), kUnit).lattice({5, 6, 9});
    const Lattice twisted = Deformation::parse("twist:50").apply(ball);
    EXPECT_EQ(joints(Closure(twisted)), joints(Closure(ball))) << far;
    EXPECT_EQ(joints(Closure(moved(ball))), "") << far;
  }
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

// <closed lattice, gradient> = <moved lattice, what is pulled back>.
TEST(Closure, PullBackIsTheTransposeOfRestore) {
  for (const std::string& name : Family::names()) {
    const Family family = Family::parse(name);
    for (const char* shape : {"box", "cylinder", "sphere"}) {
      const Points corners = corners_of(Point(-1, -1, -1), Point(1, 2, 1));
      const Lattice rest =
          lattice_around(shape, corners, std::optional<Index3>(Index3{4, 7, 10}), family);
      const Closure closure(rest, family);
      EXPECT_EQ(closure.joined(), shape != std::string("box"));
      const Lattice torn = moved(rest);
      const Points gradient = Points::Random(torn.points().rows(), 3);
      const Points pulled = closure.pull_back(gradient);
      EXPECT_NEAR(closure.restore(torn).points().cwiseProduct(gradient).sum(),
                  torn.points().cwiseProduct(pulled).sum(), 1e-11)
          << name << " " << shape;
      if (closure.joined()) continue;
      EXPECT_EQ(pulled, gradient) << name;
    }
  }
}

TEST(Closure, RefusesOtherDimensions) {
  const Lattice tube = Cylinder(Point::Ones(), kUnit).lattice({4, 5, 8});
  const Lattice other = Cylinder(Point::Ones(), kUnit).lattice({5, 5, 8});
  EXPECT_ERROR(Closure(tube).restore(other),
               "lattice to close has 5 x 5 x 8 points; give 4 x 5 x 8");
}

Lattice can() { return Cylinder(Point(0.1, 0.2, 0.3), kUnit).lattice({4, 5, 8}); }

TEST(Keyframe, EndsAreExact) {
  Points points = can().points();
  points(7, 1) = -0.0;
  const Lattice a(can().dims(), points);
  const Lattice b = Deformation::parse("bend:70").apply(a);
  EXPECT_TRUE(same_bits(between(a, b, 0.0).points(), a.points()));
  EXPECT_TRUE(same_bits(between(a, b, 1.0).points(), b.points()));
  EXPECT_FALSE(same_bits(between(a, b, 1e-3).points(), a.points()));
}

TEST(Keyframe, IsLinear) {
  const Lattice a = can();
  const Lattice b = Deformation::parse("twist:70").apply(a);
  for (const double fraction : {-0.5, 0.25, 0.5, 0.9, 2.0}) {
    const Lattice mixed = between(a, b, fraction);
    const Points expected = (1 - fraction) * a.points() + fraction * b.points();
    EXPECT_LT((mixed.points() - expected).norm(), 1e-13) << fraction;
    EXPECT_TRUE(Closure(mixed).closed(2));
  }
}

TEST(Keyframe, Refuses) {
  const Lattice other = Cylinder(Point::Zero(), kUnit).lattice({4, 5, 9});
  EXPECT_ERROR(between(can(), other, 0.5), "second keyframe has 4 x 5 x 9 points; give 4 x 5 x 8");
  const Lattice moved = Deformation::parse("move:0,0,0:1,0,0").apply(can());
  EXPECT_ERROR_PART(between(can(), moved, std::numeric_limits<double>::quiet_NaN()),
                    "is not finite");
}

}  // namespace
}  // namespace hwffd
