#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <random>

#include "errors.hpp"
#include "hwffd/lattice/cylinder.hpp"
#include "hwffd/lattice/embedder.hpp"
#include "hwffd/lattice/sphere.hpp"

namespace hwffd {
namespace {

const Eigen::Matrix3d kUnit = Eigen::Matrix3d::Identity();

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

TEST(RoundLattice, AroundHoldsItsPoints) {
  int checked = 0;
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    std::mt19937_64 random(seed);
    Points points(30, 3);
    for (Eigen::Index i = 0; i < points.size(); ++i) {
      points.data()[i] = static_cast<double>(random() >> 11) * 0x1p-53 * (i % 3 == 0 ? 5 : 1);
    }
    for (const Lattice& lattice :
         {Cylinder::around(points).lattice({4, 4, 6}), Sphere::around(points).lattice({4, 5, 6})}) {
      for (const Embedding& e : Embedder(lattice).embed(points)) {
        EXPECT_EQ(e.status, EmbeddingStatus::kInside);
        ++checked;
      }
    }
  }
  EXPECT_EQ(checked, 20 * 2 * 30);
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
  EXPECT_ERROR_PART(Sphere(Point::Zero(), kUnit).lattice({4, 5, 17}),
                    "each axis takes 4 to 16 points");
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
