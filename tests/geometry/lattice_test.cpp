#include "hwffd/lattice/lattice.hpp"

#include <gtest/gtest.h>

#include <limits>

#include "errors.hpp"

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
  for (const Index3& dims : {Index3{3, 4, 4}, Index3{4, 17, 4}, Index3{4, 4, -1}}) {
    const std::string text = message_of<Error>([&] { Lattice(dims, Points(0, 3)); });
    expect_part(text, "each axis takes 4 to 16 points");
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

}  // namespace
}  // namespace hwffd
