// Points that are no numbers or too large for them, lattices without a volume, control points that
// are not there: refused, before anything is computed with them.
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <limits>

#include "errors.hpp"
#include "hwffd/lattice/around.hpp"
#include "hwffd/lattice/attachment.hpp"
#include "hwffd/lattice/box.hpp"
#include "hwffd/lattice/coordinates.hpp"
#include "hwffd/lattice/deformation.hpp"
#include "hwffd/lattice/embedder.hpp"
#include "hwffd/lattice/shape.hpp"

namespace hwffd {
namespace {

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
constexpr double kInfinity = std::numeric_limits<double>::infinity();

Lattice around_cube(const std::string& shape) {
  const Points corners = (Points(2, 3) << -1, -1, -1, 1, 1, 1).finished();
  return lattice_around(shape, corners, usual_dims(shape));
}

TEST(Limits, PointsThatAreNoNumbersAreOutside) {
  for (const std::string& shape : shape_names()) {
    const Embedder embedder(around_cube(shape));
    for (const double bad : {kNan, kInfinity, -kInfinity, 1e160}) {
      for (int axis = 0; axis < 3; ++axis) {
        Point point = Point::Zero();
        point[axis] = bad;
        const Embedding e = embedder.embed(point);
        EXPECT_EQ(e.status, EmbeddingStatus::kOutside) << shape << " " << bad;
        EXPECT_FALSE(e.at.inside) << shape << " " << bad;
        EXPECT_EQ(e.at.cell, (Index3{0, 0, 0})) << shape << " " << bad;
        EXPECT_TRUE(e.at.local.allFinite()) << shape << " " << bad;
        EXPECT_EQ(e.residual, kInfinity) << shape << " " << bad;
      }
    }
  }
}

TEST(Limits, PointsFarAwayHavePlacesThatAreNumbers) {
  for (const std::string& shape : shape_names()) {
    const Embedder embedder(around_cube(shape));
    for (const Point& point : {Point(1e40, 3, -2), Point(1e9, 1e99, 3), Point(-1e100, 1e100, 0)}) {
      const Embedding e = embedder.embed(point);
      EXPECT_EQ(e.status, EmbeddingStatus::kOutside) << shape << " " << point.transpose();
      EXPECT_TRUE(e.at.local.allFinite()) << shape << " " << point.transpose();
      EXPECT_TRUE(std::isfinite(e.residual)) << shape << " " << point.transpose();
    }
  }
}

TEST(Limits, ABoxHasACellForThem) {
  const Embedded nowhere =
      Box(Point(0, 0, 0), Eigen::Matrix3d::Identity()).embed({5, 5, 5}, Point(kNan, 0.7, 9));
  EXPECT_EQ(nowhere.cell, (Index3{0, 0, 0}));
  EXPECT_FALSE(nowhere.inside);
  Eigen::Matrix3d slanted;
  slanted << 1, 1, 0, 0, 1, 0, 0, 0, 1;
  const Point far = Point::Constant(std::numeric_limits<double>::max());
  const Embedded there = Box(Point(0, 0, 0), slanted * 1e-5).embed({4, 4, 4}, far);
  EXPECT_EQ(there.cell, (Index3{0, 0, 0})) << "infinity less infinity along s";
  EXPECT_FALSE(there.inside);
}

TEST(Limits, PointsBeyondTheLargestCoordinateAreRefused) {
  for (const std::string& shape : shape_names()) {
    const Lattice lattice = around_cube(shape);
    for (const char* outside : {"keep", "clamp", "fade:1e150"}) {
      const Points points = (Points(2, 3) << 0, 0.5, 0, -1e160, 0, 0).finished();
      EXPECT_ERROR_PART(Attachment(lattice, points, Outside::parse(outside)),
                        "point 1 has a coordinate beyond 1e+100");
    }
    const Points far = (Points(1, 3) << -kLargestCoordinate, 0, 0).finished();
    const Attachment attachment(lattice, far, Outside::parse("clamp"));
    ASSERT_EQ(attachment.places().size(), 1u) << shape;
    const Points moved = attachment.follow(Points::Zero(1, 3));
    EXPECT_TRUE(moved.allFinite()) << shape;
    EXPECT_NEAR(moved(0, 0) / kLargestCoordinate, -1, 1e-12) << shape;
  }
}

TEST(Limits, LatticesTakeCoordinatesUpToTheLargest) {
  Points points = around_cube("box").points();
  points(7, 2) = kLargestCoordinate;
  EXPECT_EQ(Lattice({4, 4, 4}, points).points(), points);
  points(7, 2) = std::nextafter(kLargestCoordinate, kInfinity);
  EXPECT_ERROR(Lattice({4, 4, 4}, points),
               "lattice point 7 has a coordinate beyond 1e+100; give smaller ones");
}

TEST(Limits, LatticesAtRestSpanAVolume) {
  Eigen::Matrix3d turn;
  turn = Eigen::AngleAxisd(0.7, Eigen::Vector3d(1, 2, 3).normalized());
  const Points cube = around_cube("box").points();
  for (const int dimensions : {0, 1, 2}) {
    Points flat = cube;
    flat.rightCols(3 - dimensions).setZero();
    for (const Point& at : {Point(0, 0, 0), Point(100, -20, 3)}) {
      const Points placed = (flat * turn.transpose()).rowwise() + at.transpose();
      const Lattice lattice({4, 4, 4}, placed);
      EXPECT_ERROR_PART(Embedder embedder(lattice), "span no volume");
    }
  }
  Points thin = cube;
  thin.col(2) *= 1e-6;
  EXPECT_EQ(Embedder(Lattice({4, 4, 4}, thin)).embed(Point(0, 0, 0)).status,
            EmbeddingStatus::kInside);
}

TEST(Limits, ControlPointsThatAreNotThereDoNotMove) {
  const Lattice cube = around_cube("box");
  for (const Index3 place : {Index3{-1, 0, 0}, Index3{0, -7, 0}, Index3{0, 0, -1}, Index3{0, 4, 0},
                             Index3{std::numeric_limits<int>::min(), 0, 0}}) {
    EXPECT_ERROR_PART(Deformation::move(place, {1, 0, 0}).apply(cube),
                      "no point " + std::to_string(place[0]));
  }
  const Lattice ball = around_cube("sphere");
  EXPECT_THROW(Deformation::move({0, 0, -1}, {1, 0, 0}).apply(ball), Error) << "a closed axis";
}

}  // namespace
}  // namespace hwffd
