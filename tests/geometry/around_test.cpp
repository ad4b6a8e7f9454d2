// lattice_around: the room that it leaves, so that the points it was made for are inside in
// binary32 as well.
#include "hwffd/lattice/around.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

#include "hwffd/lattice/embedder.hpp"
#include "hwffd/lattice/shape.hpp"

namespace hwffd {
namespace {

Points cloud(std::uint64_t seed, const Point& at, const Point& extent) {
  std::mt19937_64 random(seed);
  Points points(1000, 3);
  for (double& x : points.reshaped()) x = static_cast<double>(random() >> 11) * 0x1p-53 - 0.5;
  return (points * extent.asDiagonal()).rowwise() + at.transpose();
}

std::size_t outside(const Lattice& lattice, const Points& points) {
  return summarize(Embedder(lattice).embed(points)).outside;
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

}  // namespace
}  // namespace hwffd
