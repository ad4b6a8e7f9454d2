// The kinds of lattice that are made: boxes, cylinders, spheres, and those around points.

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <limits>
#include <random>

#include "errors.hpp"
#include "hwffd/lattice/around.hpp"
#include "hwffd/lattice/box.hpp"
#include "hwffd/lattice/cylinder.hpp"
#include "hwffd/lattice/embedder.hpp"
#include "hwffd/lattice/shape.hpp"
#include "hwffd/lattice/sphere.hpp"
#include "hwffd/oracle/oracle.hpp"
#include "uniform.hpp"

namespace hwffd {
namespace {

const Point kOnes = Point::Ones();

Points cloud(std::uint64_t seed, const Point& at, const Point& extent) {
  std::mt19937_64 random(seed);
  Points points(1000, 3);
  for (double& x : points.reshaped()) x = unit(random) - 0.5;
  return (points * extent.asDiagonal()).rowwise() + at.transpose();
}

std::size_t outside(const Lattice& lattice, const Points& points) {
  return summarize(Embedder(lattice).embed(points)).outside;
}

/// The points themselves need no room.
TEST(Around, HoldsItsPoints) {
  Fit exactly;
  exactly.room = 0.0;
  for (const Shape& shape : shapes()) {
    for (std::uint64_t seed = 1; seed <= 20; ++seed) {
      Points points = cloud(seed, Point(0.2, -3, 0.2), seed % 2 == 0 ? Point(1e3, 1, 1) : kOnes);
      for (const Index3& dims : {shape.usual, shape.several}) {
        EXPECT_EQ(outside(lattice_around(shape.name, points, dims, exactly), points), 0u)
            << shape.name;
        points = points.cast<float>().cast<double>().eval();
      }
    }
  }
}

TEST(Around, HoldsItsPointsInBinary32) {
  const Point extents[] = {{2, 3, 1}, {1, 1e-3, 1}, {1, 0, 1}};
  for (const std::string& shape : shape_names()) {
    for (const Point& at : {Point(0, 0, 0), Point(1, -2, 3), Point(1e3, 0, -7)}) {
      for (const Point& extent : extents) {
        for (std::uint64_t seed = 1; seed <= 5; ++seed) {
          const Points points = cloud(seed, at, extent);
          const Lattice lattice = lattice_around(shape, points, usual_dims(shape));
          EXPECT_EQ(outside(lattice, points), 0u) << shape;
          const Points words = points.cast<float>().cast<double>();
          EXPECT_EQ(outside(lattice, words), 0u)
              << shape << " at " << at.transpose() << ", extent " << extent.transpose();
        }
      }
    }
  }
}

// What is known of a kind of lattice follows from its line in the list of shapes.
TEST(Around, EveryShapeIsRegisteredWhole) {
  ASSERT_GE(shapes().size(), 3u);
  for (const Shape& shape : shapes()) {
    EXPECT_EQ(find_shape(shape.name), &shape);
    EXPECT_EQ(usual_dims(shape.name), shape.usual);
    const Lattice unit = shape.placed({}, shape.several);
    EXPECT_EQ(unit.dims(), shape.several) << shape.name;
    EXPECT_NE(shape_list().find(shape.name), std::string::npos);
    for (int a = 0; a < 3; ++a) EXPECT_GE(shape.several[a], shape.usual[a]) << shape.name;
  }
  EXPECT_EQ(find_shape("torus of nothing"), nullptr);
  EXPECT_EQ(shape_list().rfind("box, cylinder, sphere", 0), 0u);
  const std::string last = shape_names().back();
  EXPECT_NE(shape_list(" or ").find(" or " + last), std::string::npos);
  EXPECT_EQ(shape_list(" or ").find(", " + last), std::string::npos);
}

/// By the shortest way: about an axis that stands on both directions.
TEST(Around, FrameWithAxisTurnsYThere) {
  for (const Point& direction : {Point(0, 1, 0), Point(3, 0, 0), Point(0, 0, -0.25), Point(1, 2, 3),
                                 Point(1, -5, 0.5), Point(1e-7, -1, 0), Point(0, -2, 1e-160),
                                 Point(0, -2, 0), Point(0, 1e-200, 0), Point(1e300, 1e300, 0)}) {
    const Point unit = direction / direction.stableNorm();
    const Eigen::Matrix3d frame = frame_with_axis(direction);
    EXPECT_LT((frame.col(1) - unit).norm(), 1e-14) << unit;
    EXPECT_LT((frame * frame.transpose() - Eigen::Matrix3d::Identity()).norm(), 1e-14) << unit;
    EXPECT_GT(frame.determinant(), 0.9) << unit;
    EXPECT_NEAR(frame.trace(), 1 + 2 * unit[1], 1e-14) << unit;  // of a turn by their angle
  }
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const double inf = std::numeric_limits<double>::infinity();
  for (const Point& direction : {Point(0, 0, 0), Point(0, nan, 0), Point(inf, 1, 0)}) {
    EXPECT_USAGE_ERROR(frame_with_axis(direction),
                       "axis: no direction; give three finite numbers, not all of them 0");
  }
}

TEST(Around, CornersOfARegion) {
  const Point low(4, -1, 0);
  const Point high(1, 2, 8);  // either may be the lower one
  Points expected(8, 3);
  expected << 4, -1, 0, 1, -1, 0, 4, 2, 0, 1, 2, 0, 4, -1, 8, 1, -1, 8, 4, 2, 8, 1, 2, 8;
  EXPECT_EQ(corners_of(low, high), expected);
  const double inf = std::numeric_limits<double>::infinity();
  for (const Point& other : {Point(1, -1, 8), Point(4, 2, 8), Point(1, 2, 0), Point(1, 2, inf)}) {
    for (const bool swapped : {false, true}) {
      EXPECT_USAGE_ERROR(
          swapped ? corners_of(other, low) : corners_of(low, other),
          "region: spans no volume; give two corners, finite and different along x, y and z");
    }
  }
}

/// A turned lattice is the upright one around the points turned back; one that is sheared, too.
TEST(Around, TurnedLatticeHoldsItsPoints) {
  Fit turned;
  turned.frame = frame_with_axis(Point(1, 2, 3));
  Fit sheared;
  sheared.frame << 1, 0.5, 0, 0, 2, 0, -0.25, 0, -1;
  for (const Fit& fit : {turned, sheared}) {
    Fit upright;
    upright.room = 2 * fit.room;
    for (const Shape& shape : shapes()) {
      const Points points = cloud(7, Point(1, -2, 3), Point(4, 1, 2));
      const Lattice lattice = lattice_around(shape.name, points, shape.several, fit);
      EXPECT_EQ(outside(lattice, points), 0u) << shape.name;
      const Points back = points * fit.frame.inverse().transpose();
      const Points expected =
          lattice_around(shape.name, back, shape.several, upright).points() * fit.frame.transpose();
      EXPECT_LT((lattice.points() - expected).cwiseAbs().maxCoeff(), 1e-5) << shape.name;
      EXPECT_EQ(lattice.dims(), shape.several) << shape.name;
    }
  }
}

/// Along the directions of the frame, in their units.
TEST(Around, PaddingIsLeftFree) {
  Points points(2, 3);
  points << 0, 0, 0, 1, 2, 4;
  Fit fit;
  fit.room = 0;
  fit.padding = Point(0.5, 0.25, 0.125);
  const Lattice upright = lattice_around("box", points, {4, 4, 4}, fit);
  EXPECT_EQ(upright.point(1, 1, 1), Point(-0.5, -0.25, -0.125));
  EXPECT_EQ(upright.point(2, 2, 2), Point(1.5, 2.25, 4.125));
  fit.frame << 0, 0, 1, 0, 1, 0, -1, 0, 0;  // x to -z, z to x
  const Lattice turned = lattice_around("box", points, {4, 4, 4}, fit);
  EXPECT_LT((turned.point(1, 1, 1) - Point(-0.125, -0.25, 4.5)).norm(), 1e-15);
  EXPECT_LT((turned.point(2, 2, 2) - Point(1.125, 2.25, -0.5)).norm(), 1e-15);
}

TEST(Around, RefusesWhatIsNoFit) {
  const Points points = cloud(1, kOnes, kOnes);
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const double inf = std::numeric_limits<double>::infinity();
  for (const Point& padding : {Point(0, -0.5, 0), Point(nan, 0, 0), Point(0, 0, inf)}) {
    Fit fit;
    fit.padding = padding;
    EXPECT_USAGE_ERROR(lattice_around("box", points, {4, 4, 4}, fit),
                       "padding: a finite number of at least 0, or one for x, y and z");
  }
  Eigen::Matrix3d flat = Eigen::Matrix3d::Identity();
  flat.col(2) = flat.col(0) + flat.col(1);
  Eigen::Matrix3d unknown = Eigen::Matrix3d::Identity();
  unknown(1, 2) = nan;
  for (const Eigen::Matrix3d& frame : {flat, unknown, Eigen::Matrix3d(Eigen::Matrix3d::Zero())}) {
    Fit fit;
    fit.frame = frame;
    EXPECT_USAGE_ERROR(lattice_around("sphere", points, {4, 5, 6}, fit),
                       "rotation: spans no volume; give 3 x 3 finite numbers, columns in three "
                       "directions");
  }
}

TEST(Around, LeavesNoMoreRoomThanIsSaid) {
  for (const double at : {0.0, 100.0}) {
    const Points points = cloud(1, Point::Constant(at), Point(2, 3, 1));
    const Points lattice = lattice_around("box", points, {4, 4, 4}).points();
    const double room = 0x1p-23 * points.cwiseAbs().maxCoeff();
    for (int axis = 0; axis < 3; ++axis) {
      const double low = points.col(axis).minCoeff();
      const double high = points.col(axis).maxCoeff();
      EXPECT_LT(lattice(21, axis), low);
      EXPECT_GE(lattice(21, axis), low - 1.001 * room);
      EXPECT_GT(lattice(42, axis), high);
      EXPECT_LE(lattice(42, axis), high + 1.001 * room);
    }
  }
}

const Eigen::Matrix3d kUnit = Eigen::Matrix3d::Identity();

/// A place in the unit cube.
Point anywhere(std::mt19937_64& random) {
  Point place;
  for (double& x : place) x = unit(random);
  return place;
}

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
      const Point p = box.origin() + box.edges() * anywhere(random);
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
    const Point p = box.origin() + box.edges() * anywhere(random);
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
  const Box box(Point(0, 0, 0), kUnit);
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
  Eigen::Matrix3d flat = kUnit;
  flat.col(2) = flat.col(0) + flat.col(1);
  const std::string volume =
      "box lattice: its three edges span no volume; give finite edges in three directions";
  EXPECT_ERROR(Box(Point::Zero(), flat), volume);
  EXPECT_ERROR(Box(Point::Zero(), Eigen::Matrix3d::Zero()), volume);
  const double inf = std::numeric_limits<double>::infinity();
  EXPECT_ERROR(Box(Point(inf, 0, 0), kUnit), volume);
  const std::string bounds = "box lattice: no bounding box; give at least one point, all finite";
  EXPECT_ERROR(Box::around(Points(0, 3)), bounds);
  EXPECT_ERROR(Box::around(Points::Constant(2, 3, inf)), bounds);
  EXPECT_ERROR_PART(slanted().lattice({4, 4, 3}), "4 to 64 points");
}

/// The point of a lattice at coordinates that run over all its cells, each from 0 to 1.
Point over_cells(const Lattice& lattice, const Eigen::Vector3d& at) {
  Embedded place;
  for (int a = 0; a < 3; ++a) {
    const auto axis = static_cast<std::size_t>(a);
    const int cells = lattice.cells()[axis];
    place.cell[axis] = std::min(static_cast<int>(at[a] * cells), cells - 1);
    place.local[a] = at[a] * cells - place.cell[axis];
  }
  return Oracle().evaluate(lattice.support(place.cell), place.local[0], place.local[1],
                           place.local[2]);
}

/// The smallest and largest of f over the shell s = 1.
template <typename F>
std::pair<double, double> range_on_shell(const Lattice& lattice, F f) {
  double least = 1e300;
  double most = -1e300;
  for (int j = 0; j <= 120; ++j) {
    for (int k = 0; k <= 840; ++k) {
      const double value = f(over_cells(lattice, {1.0, j / 120.0, k / 840.0}));
      least = std::min(least, value);
      most = std::max(most, value);
    }
  }
  return {least, most};
}

/// The last three points around are the first three, bit for bit, and so are the cells' ends.
TEST(RoundLattice, ClosesAround) {
  int checked = 0;
  for (const Lattice& lattice : {Cylinder(Point(1, 2, 3), kUnit, 0.2).lattice({4, 7, 6}),
                                 Cylinder(Point(1, 2, 3), kUnit).lattice({5, 4, 16}),
                                 Sphere(Point(-1, 0, 9), kUnit).lattice({4, 5, 9})}) {
    const Index3& dims = lattice.dims();
    for (const auto& [i, j, k] : places({dims[0], dims[1], 3})) {
      EXPECT_EQ(lattice.point(i, j, k), lattice.point(i, j, dims[2] - 3 + k));
      if (i == dims[0] - 1 && j == 2) {
        EXPECT_NE(lattice.point(i, j, k), lattice.point(i, j, k + 1));
      }
      checked += 1;
    }
    const Point first = over_cells(lattice, {0.7, 0.4, 0.0});
    EXPECT_LT((first - over_cells(lattice, {0.7, 0.4, 1.0})).norm(), 1e-15 * 10);
  }
  EXPECT_EQ(checked, 3 * (28 + 20 + 20));
}

TEST(RoundLattice, CylinderTouchesItsRadius) {
  const std::vector<std::pair<int, double>> bulges{{6, 0.143}, {7, 0.029}, {16, 0.00016}};
  for (const auto& [n, bulge] : bulges) {
    const Lattice lattice = Cylinder(Point::Zero(), kUnit).lattice({4, 4, n});
    const auto [least, most] =
        range_on_shell(lattice, [](const Point& p) { return std::hypot(p[0], p[2]); });
    EXPECT_GE(least, 1.0 - 1e-14);
    EXPECT_LE(least, 1.0 + 1e-4);
    EXPECT_LE(most, 1.0 + bulge);
  }
}

TEST(RoundLattice, SphereTouchesItsRadius) {
  for (const Index3& dims : {Index3{4, 5, 6}, Index3{5, 9, 11}, Index3{4, 16, 16}}) {
    const auto [least, most] = range_on_shell(Sphere(Point::Zero(), kUnit).lattice(dims),
                                              [](const Point& p) { return p.norm(); });
    EXPECT_GE(least, 1.0 - 1e-14);
    EXPECT_LE(least, 1.0 + 1e-3);
    EXPECT_LE(most, dims[2] == 16 ? 1.0003 : 1.6);
  }
}

/// The axes mean what the headers say: s outwards, t up, u from the first edge to the third.
TEST(RoundLattice, AxesInObjectSpace) {
  Eigen::Matrix3d edges;
  edges.col(0) << 0, 0, 2;
  edges.col(1) << 0, 6, 0;
  edges.col(2) << 4, 0, 0;
  const Lattice tube = Cylinder(Point(10, 20, 30), edges, 0.5).lattice({4, 5, 15});
  const auto near = [](const Point& a, const Point& b) { return (a - b).norm() < 0.01; };
  EXPECT_PRED2(near, over_cells(tube, {1, 0, 0}), Point(10, 20, 32));
  EXPECT_PRED2(near, over_cells(tube, {0, 0, 0}), Point(10, 20, 31));
  EXPECT_PRED2(near, over_cells(tube, {1, 0.5, 0}), Point(10, 23, 32));
  EXPECT_PRED2(near, over_cells(tube, {1, 0, 0.25}), Point(14, 20, 30));
  const Lattice ball = Sphere(Point(10, 20, 30), edges, 0.5).lattice({4, 16, 15});
  EXPECT_PRED2(near, over_cells(ball, {1, 0, 0.3}), Point(10, 14, 30));
  EXPECT_PRED2(near, over_cells(ball, {1, 1, 0.3}), Point(10, 26, 30));
  EXPECT_PRED2(near, over_cells(ball, {0.5, 1, 0.3}), Point(10, 24.5, 30));
  EXPECT_PRED2(near, over_cells(ball, {1, 0.5, 0.25}), Point(14, 20, 30));
}

TEST(RoundLattice, SolidOnesEndOnAxisPolesAndCentre) {
  const Lattice cylinder = Cylinder(Point(1, 2, 3), kUnit).lattice({5, 4, 9});
  const Lattice ball = Sphere(Point(1, 2, 3), kUnit).lattice({5, 6, 9});
  for (int n = 0; n <= 12; ++n) {
    const double x = n / 12.0;
    EXPECT_LT((over_cells(cylinder, {0, x, 1 - x}) - Point(1, 2 + x, 3)).norm(), 1e-14);
    EXPECT_LT((over_cells(ball, {0, x, 1 - x}) - Point(1, 2, 3)).norm(), 1e-14);
    const Point pole = over_cells(ball, {x, 1, 1 - x});
    EXPECT_LT(std::hypot(pole[0] - 1, pole[2] - 3), 1e-14);
  }
}

TEST(RoundLattice, AroundHoldsALineAndAPoint) {
  Points line(2, 3);
  line << 0, 1, 0, 0, 3, 0;
  EXPECT_EQ(Embedder(Cylinder::around(line).lattice({4, 4, 8})).embed(line)[1].status,
            EmbeddingStatus::kInside);
  EXPECT_EQ(Embedder(Sphere::around(line.topRows(1)).lattice({4, 6, 8})).embed(line)[0].status,
            EmbeddingStatus::kInside);
}

TEST(RoundLattice, Refuses) {
  EXPECT_ERROR(
      Cylinder(Point::Zero(), kUnit).lattice({4, 4, 5}),
      "cylinder lattice: 5 points along u, which goes around; give at least 6, as three of "
      "them repeat the first three");
  EXPECT_ERROR(Sphere(Point::Zero(), kUnit).lattice({4, 4, 6}),
               "sphere lattice: 4 points along t, which goes around; give at least 5, as three of "
               "them lie at and beyond the poles");
  EXPECT_ERROR_PART(Sphere(Point::Zero(), kUnit).lattice({4, 5, 65}),
                    "each axis takes 4 to 64 points");
  EXPECT_ERROR(Cylinder(Point::Zero(), kUnit, 1.0),
               "cylinder lattice: inner radius 1 of the outer; give 0 (solid) or more, and less "
               "than 1");
  EXPECT_ERROR_PART(Sphere(Point::Zero(), kUnit, -0.1), "inner radius -0.1");
  EXPECT_ERROR_PART(Sphere(Point::Zero(), Eigen::Matrix3d::Ones()),
                    "sphere lattice: its three edges span no volume");
  EXPECT_ERROR_PART(Cylinder::around(Points(0, 3)), "at least one point");
}

}  // namespace
}  // namespace hwffd
