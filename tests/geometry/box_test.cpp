#include "hwffd/lattice/box.hpp"

#include <gtest/gtest.h>

#include <limits>
#include <random>

#include "errors.hpp"
#include "hwffd/oracle/oracle.hpp"

namespace hwffd {
namespace {

/// A box with slanted edges of different lengths, left-handed to boot.
Box slanted() {
  Eigen::Matrix3d edges;
  edges.col(0) << 3.0, 0.5, -0.25;
  edges.col(1) << 0.25, -2.0, 0.5;
  edges.col(2) << -0.5, 0.125, 5.0;
  return Box(Point(1.0, -2.0, 7.0), edges);
}

Point through_oracle(const Lattice& lattice, const Embedded& at) {
  return Oracle().evaluate(lattice.support(at.cell), at.local[0], at.local[1], at.local[2]);
}

TEST(Box, SingleCellSitsInTheMiddle) {
  Points corners(2, 3);
  corners << 0, 0, 0, 1, 2, 4;
  const Lattice lattice = Box::around(corners).lattice({4, 4, 4});
  EXPECT_EQ(lattice.point(0, 0, 0), Point(-1, -2, -4));
  EXPECT_EQ(lattice.point(1, 1, 1), Point(0, 0, 0));
  EXPECT_EQ(lattice.point(2, 2, 2), Point(1, 2, 4));
  EXPECT_EQ(lattice.point(3, 3, 3), Point(2, 4, 8));
  EXPECT_EQ(lattice.point(3, 1, 0), Point(2, 0, -4));
}

TEST(Box, CellsFillTheBox) {
  const Box box(Point(0, 0, 0), Eigen::Vector3d(2, 6, 12).asDiagonal());
  const Lattice lattice = box.lattice({5, 6, 7});
  EXPECT_EQ(lattice.point(1, 1, 1), Point(0, 0, 0));
  EXPECT_EQ(lattice.point(3, 4, 5), Point(2, 6, 12));
  EXPECT_EQ(lattice.point(2, 3, 2), Point(1, 4, 3));
}

/// A regular lattice deforms nothing (identity), and point() undoes embed().
TEST(Box, RegularLatticeIsTheIdentity) {
  const Box box = slanted();
  for (const Index3& dims : {Index3{4, 4, 4}, Index3{4, 5, 6}, Index3{16, 7, 4}}) {
    const Lattice lattice = box.lattice(dims);
    std::mt19937_64 random(3);
    for (int i = 0; i < 500; ++i) {
      Eigen::Vector3d at;
      for (int a = 0; a < 3; ++a) at[a] = static_cast<double>(random() >> 11) * 0x1p-53;
      const Point p = box.origin() + box.edges() * at;
      const Embedded e = box.embed(dims, p);
      ASSERT_TRUE(e.inside);
      EXPECT_GE(e.local.minCoeff(), 0.0);
      EXPECT_LE(e.local.maxCoeff(), 1.0);
      EXPECT_LT((box.point(dims, e) - p).norm(), 1e-13);
      EXPECT_LT((through_oracle(lattice, e) - p).norm(), 1e-13);
    }
  }
}

/// A lattice moved by an affine map moves every embedded point by that map.
TEST(Box, AffineMapMovesEmbeddedPoints) {
  Eigen::Matrix3d linear;
  linear << 0.5, 1.0, -0.25, -1.5, 0.25, 0.75, 0.125, 2.0, 1.0;
  const Eigen::RowVector3d shift(-4.0, 9.0, 1.0);
  const Box box = slanted();
  const Index3 dims{6, 4, 9};
  const Lattice before = box.lattice(dims);
  const Points moved = (before.points() * linear.transpose()).rowwise() + shift;
  const Lattice after(dims, moved);
  std::mt19937_64 random(4);
  for (int i = 0; i < 300; ++i) {
    Eigen::Vector3d at;
    for (int a = 0; a < 3; ++a) at[a] = static_cast<double>(random() >> 11) * 0x1p-53;
    const Point p = box.origin() + box.edges() * at;
    const Point expected = linear * p + shift.transpose();
    EXPECT_LT((through_oracle(after, box.embed(dims, p)) - expected).norm(), 1e-13);
  }
}

TEST(Box, FacesBetweenCellsAndLastFace) {
  const Box box(Point(0, 0, 0), Eigen::Vector3d(2, 3, 4).asDiagonal());
  const Index3 dims{5, 6, 7};
  const Embedded first = box.embed(dims, Point(0, 0, 0));
  EXPECT_TRUE(first.inside);
  EXPECT_EQ(first.cell, (Index3{0, 0, 0}));
  EXPECT_EQ(first.local, Eigen::Vector3d(0, 0, 0));
  const Embedded between = box.embed(dims, Point(1, 1, 3));
  EXPECT_TRUE(between.inside);
  EXPECT_EQ(between.cell, (Index3{1, 1, 3}));
  EXPECT_EQ(between.local, Eigen::Vector3d(0, 0, 0));
  const Embedded last = box.embed(dims, Point(2, 3, 4));
  EXPECT_TRUE(last.inside);
  EXPECT_EQ(last.cell, (Index3{1, 2, 3}));
  EXPECT_EQ(last.local, Eigen::Vector3d(1, 1, 1));
}

TEST(Box, OutsideIsFlaggedAndHasTheNearestCell) {
  const Box box(Point(0, 0, 0), Eigen::Matrix3d::Identity());
  const Index3 dims{5, 5, 5};
  const Embedded beyond = box.embed(dims, Point(1.25, 0.25, 0.75));
  EXPECT_FALSE(beyond.inside);
  EXPECT_EQ(beyond.cell, (Index3{1, 0, 1}));
  EXPECT_EQ(beyond.local, Eigen::Vector3d(1.5, 0.5, 0.5));
  const Embedded before = box.embed(dims, Point(0.5, -0.25, 0.5));
  EXPECT_FALSE(before.inside);
  EXPECT_EQ(before.cell, (Index3{1, 0, 1}));
  EXPECT_EQ(before.local, Eigen::Vector3d(0, -0.5, 0));
  const Embedded far = box.embed(dims, Point(0.5, 0.5, 1e300));
  EXPECT_FALSE(far.inside);
  EXPECT_EQ(far.cell, (Index3{1, 1, 1}));
  EXPECT_FALSE(box.embed(dims, Point(0.5, 0.5, 1.0 + 1e-9)).inside);
  EXPECT_FALSE(box.embed(dims, Point(-1e-9, 0.5, 0.5)).inside);
}

/// Every point that made the bounding box is inside it, whatever the rounding.
TEST(Box, BoundingBoxHoldsItsPoints) {
  int checked = 0;
  for (std::uint64_t seed = 1; seed <= 200; ++seed) {
    std::mt19937_64 random(seed);
    Points points(20, 3);
    for (Eigen::Index i = 0; i < points.size(); ++i) {
      const double x = static_cast<double>(random() >> 11) * 0x1p-53;
      points.data()[i] = static_cast<float>((x - 0.3) * (seed % 2 == 0 ? 1e3 : 1.0));
    }
    for (const Embedded& e : Box::around(points).embed({7, 4, 16}, points)) {
      EXPECT_TRUE(e.inside);
      ++checked;
    }
  }
  EXPECT_EQ(checked, 4000);
}

TEST(Box, FlatModelGetsThickness) {
  Points points(2, 3);
  points << 0, 5, 0, 2, 5, 8;
  const Box box = Box::around(points);
  EXPECT_EQ(box.origin(), Point(0, 1, 0));
  EXPECT_EQ(Point(box.edges().diagonal()), Point(2, 8, 8));
  EXPECT_EQ(box.embed({4, 4, 4}, Point(1, 5, 4)).local, Eigen::Vector3d(0.5, 0.5, 0.5));
  EXPECT_EQ(Point(Box::around(points.topRows(1)).edges().diagonal()), Point(1, 1, 1));
}

TEST(Box, Refuses) {
  Eigen::Matrix3d flat = Eigen::Matrix3d::Identity();
  flat.col(2) = flat.col(0) + flat.col(1);
  const std::string volume =
      "box lattice: its three edges span no volume; give finite edges in three directions";
  EXPECT_ERROR(Box(Point::Zero(), flat), volume);
  EXPECT_ERROR(Box(Point::Zero(), Eigen::Matrix3d::Zero()), volume);
  const double inf = std::numeric_limits<double>::infinity();
  EXPECT_ERROR(Box(Point(inf, 0, 0), Eigen::Matrix3d::Identity()), volume);
  const std::string bounds = "box lattice: no bounding box; give at least one point, all finite";
  EXPECT_ERROR(Box::around(Points(0, 3)), bounds);
  EXPECT_ERROR(Box::around(Points::Constant(2, 3, inf)), bounds);
  EXPECT_ERROR_PART(slanted().lattice({4, 4, 3}), "4 to 16 points");
}

}  // namespace
}  // namespace hwffd
