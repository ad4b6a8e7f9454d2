#include "hwffd/lattice/nearest_place.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <random>

#include "embed/samples.hpp"
#include "hwffd/lattice/cylinder.hpp"
#include "hwffd/lattice/deformation.hpp"
#include "hwffd/lattice/embedder.hpp"
#include "hwffd/lattice/sphere.hpp"

namespace hwffd {
namespace {

const Eigen::Matrix3d kUnit = Eigen::Matrix3d::Identity();

/// Points within `reach` sizes of the lattice's middle that are outside.
Points points_outside(const Embedder& embedder, int count, double reach, std::uint64_t seed) {
  const Points& control = embedder.lattice().points();
  const Point middle = (control.colwise().minCoeff() + control.colwise().maxCoeff()) / 2;
  std::mt19937_64 random(seed);
  Points points(count, 3);
  for (int found = 0; found < count;) {
    Point way;
    for (double& x : way) x = static_cast<double>(random() >> 11) * 0x1p-52 - 1;
    const Point point = middle + reach * embedder.size() * way;
    if (embedder.embed(point).status != EmbeddingStatus::kOutside) continue;
    points.row(found++) = point;
  }
  return points;
}

/// A grid of n x n x n places of every cell.
Points sampled(const Embedder& embedder, int n) {
  std::vector<Embedded> grid;
  for (const Index3& cell : places(embedder.lattice().cells())) {
    for (const auto& [i, j, k] : places({n, n, n})) {
      grid.push_back({cell, Eigen::Vector3d(i, j, k) / (n - 1), true});
    }
  }
  return embed::points_at(embedder, grid);
}

struct Case {
  const char* name;
  Lattice lattice;
};

std::vector<Case> cases() {
  Eigen::Matrix3d slanted;
  slanted << 1, 0.6, 0, 0, 1, 0.3, 0.2, 0, 2;
  return {{"box", embed::sample_lattice("box", embed::corners())},
          {"slanted", Box(Point(1, 2, 3), slanted).lattice({4, 5, 6})},
          {"cylinder", embed::sample_lattice("cylinder", embed::corners())},
          {"tube", Cylinder(Point::Zero(), slanted, 0.6).lattice({4, 4, 9})},
          {"sphere", embed::sample_lattice("sphere", embed::corners())},
          {"shell", Sphere(Point::Ones(), kUnit, 0.5).lattice({4, 6, 8})},
          {"custom", embed::sample_lattice("custom", embed::corners())}};
}

/// The place is one of the lattice, and no sampled one is nearer.
TEST(NearestPlace, NoSampledPlaceIsNearer) {
  for (const Case& c : cases()) {
    const Embedder embedder(c.lattice);
    const NearestPlace nearest(c.lattice);
    const Points samples = sampled(embedder, 9);
    for (const double reach : {0.6, 3.0}) {
      const Points points = points_outside(embedder, 60, reach, 5);
      for (Eigen::Index i = 0; i < points.rows(); ++i) {
        const Point point = points.row(i);
        const NearestPlace::Result found = nearest.find(point);
        const double least = (samples.rowwise() - point.transpose()).rowwise().norm().minCoeff();
        EXPECT_LE(found.distance, least + 1e-7 * embedder.size()) << c.name << " " << i;
        EXPECT_LT((embedder.point(found.at) - found.point).norm(), 1e-12 * embedder.size());
        EXPECT_NEAR((found.point - point).norm(), found.distance, 1e-12 * embedder.size());
        EXPECT_TRUE(found.at.inside);
        EXPECT_TRUE((found.at.local.array() >= 0).all() && (found.at.local.array() <= 1).all());
      }
    }
  }
}

/// Few cells, so curved that Newton's method from the middle of each face misses some places: the
/// search of their parts finds them.
TEST(NearestPlace, MiddlesOfFacesAreNotEnough) {
  const Lattice box = Box(Point::Zero(), kUnit).lattice({4, 4, 4});
  for (const Lattice& lattice : {Sphere(Point::Zero(), kUnit, 0.5).lattice({4, 5, 6}),
                                 Deformation::parse("twist:80").apply(box)}) {
    const Embedder embedder(lattice);
    const NearestPlace nearest(lattice);
    const Points samples = sampled(embedder, 9);
    for (const double reach : {0.7, 2.5}) {
      const Points points = points_outside(embedder, 1000, reach, 3);
      for (Eigen::Index i = 0; i < points.rows(); ++i) {
        const Point point = points.row(i);
        const double least = (samples.rowwise() - point.transpose()).rowwise().norm().minCoeff();
        EXPECT_LE(nearest.find(point).distance, least + 1e-7 * embedder.size()) << i;
      }
    }
  }
}

/// Where the nearest place is known.
TEST(NearestPlace, KnownPlaces) {
  const NearestPlace box(Box(Point(0, 0, 0), kUnit).lattice({6, 5, 4}));
  EXPECT_EQ(box.find(Point(2, 0.25, -3)).point, Point(1, 0.25, 0));
  EXPECT_EQ(box.find(Point(2, 0.25, -3)).at.cell, (Index3{2, 0, 0}));
  EXPECT_EQ(box.find(Point(2, 0.25, -3)).at.local, Eigen::Vector3d(1, 0.5, 0));
  const NearestPlace can(Cylinder(Point(5, 0, 0), kUnit).lattice({4, 6, 11}));
  for (const double x : {4.2, 4.7, 5.0, 5.2, 5.6}) {
    for (const double z : {-0.5, 0.0, 0.3}) {
      const NearestPlace::Result found = can.find(Point(x, 3, z));
      EXPECT_LT((found.point - Point(x, 1, z)).norm(), 1e-7) << found.point.transpose();
    }
  }
  // Above the pole of a ball; the equator at u = 0 lies in the middle of a cell, touches the ball.
  const NearestPlace ball(Sphere(Point(5, 0, 0), kUnit).lattice({4, 6, 11}));
  EXPECT_NEAR(ball.find(Point(5, 7, 0)).distance, 6.0, 0.02);
  EXPECT_LT((ball.find(Point(5, 7, 0)).point - Point(5, 1, 0)).norm(), 0.02);
}

/// The nearest places of a convex shape are no further apart than the points: also across cells and
/// poles.
TEST(NearestPlace, NeighboursHaveNeighbouringPlaces) {
  for (const char* const kind : {"box", "cylinder", "sphere"}) {
    const Embedder embedder(embed::sample_lattice(kind, embed::corners()));
    const NearestPlace nearest(embedder.lattice());
    const double step = 1e-6 * embedder.size();
    const Points points = points_outside(embedder, 400, 0.8, 7);
    for (Eigen::Index i = 0; i < points.rows(); ++i) {
      const Point point = points.row(i);
      const Point place = nearest.find(point).point;
      for (int a = 0; a < 3; ++a) {
        const Point other = nearest.find(Point(point + step * Point::Unit(a))).point;
        EXPECT_LT((other - place).norm(), 1.2 * step) << kind << " " << i;
      }
    }
  }
}

/// From the middle of a hollow all places of its wall are about as near: the search stays bounded.
TEST(NearestPlace, SearchIsBounded) {
  const NearestPlace tube(Cylinder(Point::Zero(), kUnit, 0.5).lattice({5, 6, 16}));
  const NearestPlace::Result inside = tube.find(Point(0, 0.5, 0));
  EXPECT_NEAR(inside.distance, 0.5, 1e-3);
  EXPECT_LT(inside.parts, 2500);
  double parts = 0.0;
  const Embedder embedder(embed::sample_lattice("sphere", embed::corners()));
  const NearestPlace sphere(embedder.lattice());
  const Points points = points_outside(embedder, 200, 0.7, 6);
  for (Eigen::Index i = 0; i < points.rows(); ++i) parts += sphere.find(Point(points.row(i))).parts;
  std::printf("%.1f parts a point\n", parts / 200);
  EXPECT_LT(parts / 200, 200);
}

}  // namespace
}  // namespace hwffd
