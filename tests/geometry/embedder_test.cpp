// Where points are in a lattice, and which place of it is nearest to one outside.

#include "hwffd/lattice/embedder.hpp"

#include <gtest/gtest.h>

#include <Eigen/LU>
#include <array>
#include <cmath>
#include <cstdio>
#include <random>

#include "errors.hpp"
#include "hwffd/lattice/cylinder.hpp"
#include "hwffd/lattice/deformation.hpp"
#include "hwffd/lattice/fold.hpp"
#include "hwffd/lattice/nearest_place.hpp"
#include "hwffd/lattice/sphere.hpp"
#include "hwffd/mesh/mesh.hpp"
#include "named.hpp"
#include "sample_lattices.hpp"
#include "uniform.hpp"

namespace hwffd {
namespace {

constexpr double kBound = 1e-9;  // of the lattice's size
constexpr std::size_t kPoints = 10000;

const Eigen::Matrix3d kUnitBox = Eigen::Matrix3d::Identity();

Embedder around_corners(const std::string& kind) {
  return Embedder(test::sample_lattice(kind, test::corners()));
}

/// Embeds points of known places: all must be inside and come back.
EmbeddingSummary expect_back(const Embedder& embedder, std::size_t count, std::uint64_t seed) {
  const auto places = test::known_places(embedder.lattice(), count, seed);
  const Points points = test::points_at(embedder, places);
  const std::vector<Embedding> embeddings = embedder.embed(points);
  EXPECT_EQ(embeddings.size(), count);
  double worst = 0.0;
  for (std::size_t i = 0; i < count; ++i) {
    const Point wanted = points.row(static_cast<Eigen::Index>(i));
    const Embedding& e = embeddings[i];
    EXPECT_EQ(e.status, EmbeddingStatus::kInside) << i << ": " << wanted.transpose();
    EXPECT_TRUE(e.at.inside);
    EXPECT_TRUE((e.at.local.array() >= 0).all() && (e.at.local.array() <= 1).all());
    worst = std::max(worst, (embedder.point(e.at) - wanted).norm());
  }
  EXPECT_LE(worst, kBound * embedder.size());
  const EmbeddingSummary summary = summarize(embeddings);
  EXPECT_EQ(summary.inside, count);
  EXPECT_EQ(summary.outside, 0u);
  EXPECT_EQ(summary.not_converged, 0u);
  EXPECT_LE(summary.worst_residual, kBound * embedder.size());
  return summary;
}

class EmbedderKind : public testing::TestWithParam<std::string> {};

TEST_P(EmbedderKind, KnownPlacesComeBack) {
  EXPECT_LT(expect_back(around_corners(GetParam()), kPoints, 1).mean_iterations, 6.0);
  EXPECT_EQ(around_corners(GetParam()).affine(), GetParam() == "box");
}

TEST_P(EmbedderKind, MeshesAreEmbedded) {
  int meshes = 0;
  for (const char* const name : {"cat.3ds", "horse.3ds", "bunny.obj"}) {
    std::filesystem::path path;
    try {
      path = find_model(name);
    } catch (const Error&) {
      continue;
    }
    const Points points = Mesh::load(path).positions();
    const Embedder embedder(test::sample_lattice(GetParam(), points));
    const EmbeddingSummary summary = summarize(embedder.embed(points));
    EXPECT_EQ(summary.not_converged, 0u) << name;
    EXPECT_EQ(summary.inside + summary.outside, static_cast<std::size_t>(points.rows())) << name;
    if (GetParam() != "custom") {
      EXPECT_EQ(summary.outside, 0u) << name;
    }
    EXPECT_GT(summary.inside, summary.points / 2) << name;
    EXPECT_LE(summary.worst_residual, kBound * embedder.size()) << name;
    ++meshes;
  }
  if (meshes == 0) GTEST_SKIP() << "no cat.3ds, horse.3ds or bunny.obj; package glmark2-data";
}

INSTANTIATE_TEST_SUITE_P(, EmbedderKind, testing::ValuesIn(test::lattice_kinds()), test::by_name);

/// Coarse, stretched and far away: three cells around, one along each other axis it allows.
TEST(Embedder, ExtremeLatticesComeBack) {
  Eigen::Matrix3d flat;
  flat << 100, 0, 0.3, 0, 0.1, 0, 0, 0, 1;
  const Point far(1e6, -1e6, 1e6);
  expect_back(Embedder(Cylinder(Point::Zero(), kUnitBox).lattice({4, 4, 6})), 2000, 2);
  expect_back(Embedder(Sphere(Point::Zero(), kUnitBox).lattice({4, 5, 6})), 2000, 3);
  expect_back(Embedder(Sphere(Point::Zero(), flat).lattice({4, 6, 8})), 2000, 4);
  expect_back(Embedder(Cylinder(far, kUnitBox, 0.9).lattice({5, 4, 16})), 2000, 5);
  expect_back(Embedder(Sphere(far, kUnitBox, 0.1).lattice({16, 16, 16})), 2000, 6);
}

/// A strongly bent cell in which Newton-Raphson from 0.5 alone does not find all points.
Lattice crooked_cell() {
  const Lattice box = Box(Point::Zero(), kUnitBox).lattice({4, 4, 4});
  return Deformation::parse("bend:300").apply(Deformation::parse("twist:80").apply(box));
}

/// Iterations that plain Newton-Raphson from 0.5 takes; 0 if it leaves the cell or does not end.
int plain_newton(const Lattice& lattice, const Point& point) {
  const Oracle oracle;
  const Support support = lattice.support({0, 0, 0});
  Eigen::Vector3d local = Eigen::Vector3d::Constant(0.5);
  for (int n = 1; n <= 50; ++n) {
    const Oracle::Jet jet = oracle.jet(support, local);
    local -= jet.jacobian.inverse() * (jet.value - point);
    if (!local.allFinite()) return 0;
    const bool inside = (local.array() > -1e-9).all() && (local.array() < 1 + 1e-9).all();
    const Eigen::Vector3d value = oracle.evaluate(support, local[0], local[1], local[2]);
    if ((value - point).norm() < 1e-12) return inside ? n : 0;
  }
  return 0;
}

TEST(Embedder, FindsWhatPlainNewtonMisses) {
  const Lattice lattice = crooked_cell();
  const Embedder embedder(lattice);
  expect_back(embedder, 3000, 7);
  const Points points = test::points_at(embedder, test::known_places(lattice, 3000, 7));
  int missed = 0;
  for (Eigen::Index i = 0; i < points.rows(); ++i) {
    if (plain_newton(lattice, Point(points.row(i))) == 0) ++missed;
  }
  EXPECT_GT(missed, 0) << "the cell is too tame to try the safeguard";
}

TEST(Embedder, OutsideIsProvedAndNear) {
  const Embedder ball(Sphere(Point(1, 2, 3), kUnitBox).lattice({4, 9, 16}));
  for (int n = 0; n < 400; ++n) {
    const double angle = 0.7 * n;
    const double height = 2.0 * n / 400 - 1;
    const Point way(std::sqrt(1 - height * height) * std::cos(angle), height,
                    std::sqrt(1 - height * height) * std::sin(angle));
    for (const double distance : {1.01, 1.5, 100.0}) {
      const Embedding e = ball.embed(Point(Point(1, 2, 3) + distance * way));
      EXPECT_EQ(e.status, EmbeddingStatus::kOutside);
      EXPECT_FALSE(e.at.inside);
      EXPECT_NEAR(e.residual, distance - 1, 0.005 + 1e-3 * distance);
    }
    EXPECT_EQ(ball.embed(Point(Point(1, 2, 3) + 0.9999 * way)).status, EmbeddingStatus::kInside);
  }
}

/// A hair outside the outer face, closer than anything but the tolerance tells apart.
TEST(Embedder, DecidesClosePointsAtFaces) {
  const Embedder tube(Cylinder(Point::Zero(), kUnitBox, 0.5).lattice({5, 5, 10}));
  const Embedded edge{{1, 1, 3}, {1.0, 1.0, 0.37}, true};
  const Point on = tube.point(edge);
  for (const double above : {1e-3, 1e-6, 1e-9, 1e-11}) {
    EXPECT_EQ(tube.embed(Point(on + Point(0, above, 0))).status, EmbeddingStatus::kOutside)
        << above;
  }
  EXPECT_EQ(tube.embed(on).status, EmbeddingStatus::kInside);
  EXPECT_EQ(tube.embed(Point(on * (1 + 1e-14))).status, EmbeddingStatus::kInside);
}

TEST(Embedder, BoxesAreAffineInAnyOrientation) {
  Eigen::Matrix3d edges;
  edges << 1, 2, 0, -2, 1, 0, 0, 0.5, 3;
  const Box box(Point(5, 6, 7), edges);
  const Index3 dims{4, 9, 6};
  const Embedder embedder(box.lattice(dims));
  ASSERT_TRUE(embedder.affine());
  const Embedding closing = embedder.embed(Point(box.origin() + edges * Point(1, 1, 1)));
  EXPECT_EQ(closing.status, EmbeddingStatus::kInside);
  EXPECT_EQ(closing.at.cell, (Index3{0, 5, 2}));
  EXPECT_EQ(closing.at.local, Eigen::Vector3d(1, 1, 1));
  EXPECT_EQ(closing.iterations, 0);
  const Point beyond = box.origin() + edges * Point(0.5, 1.25, 0.5);
  const Embedding outside = embedder.embed(beyond);
  EXPECT_EQ(outside.status, EmbeddingStatus::kOutside);
  EXPECT_LT((embedder.point(outside.at) - beyond).norm(), 1e-13);
  Points points = box.lattice(dims).points();
  points(17, 0) += 1e-9;
  EXPECT_FALSE(Embedder(Lattice(dims, points)).affine());
}

TEST(Embedder, Summary) {
  std::vector<Embedding> all(4);
  all[0] = {{}, EmbeddingStatus::kInside, 0.25, 4};
  all[1] = {{}, EmbeddingStatus::kInside, 0.5, 7};
  all[2] = {{}, EmbeddingStatus::kOutside, 9.0, 100};
  all[3] = {{}, EmbeddingStatus::kNotConverged, 8.0, 200};
  const EmbeddingSummary summary = summarize(all);
  EXPECT_EQ(summary.points, 4u);
  EXPECT_EQ(summary.inside, 2u);
  EXPECT_EQ(summary.outside, 1u);
  EXPECT_EQ(summary.not_converged, 1u);
  EXPECT_EQ(summary.worst_residual, 0.5);
  EXPECT_EQ(summary.mean_iterations, 5.5);
  EXPECT_EQ(summarize({}).mean_iterations, 0.0);
}

/// Points within `reach` sizes of the lattice's middle that are outside.
Points points_outside(const Embedder& embedder, int count, double reach, std::uint64_t seed) {
  const Points& control = embedder.lattice().points();
  const Point middle = (control.colwise().minCoeff() + control.colwise().maxCoeff()) / 2;
  std::mt19937_64 random(seed);
  Points points(count, 3);
  for (int count_outside = 0; count_outside < count;) {
    Point way;
    for (double& x : way) x = 2 * unit(random) - 1;
    const Point point = middle + reach * embedder.size() * way;
    if (embedder.embed(point).status != EmbeddingStatus::kOutside) continue;
    points.row(count_outside++) = point;
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
  return test::points_at(embedder, grid);
}

struct Case {
  const char* name;
  Lattice lattice;
};

std::vector<Case> cases() {
  Eigen::Matrix3d slanted;
  slanted << 1, 0.6, 0, 0, 1, 0.3, 0.2, 0, 2;
  return {{"box", test::sample_lattice("box", test::corners())},
          {"slanted", Box(Point(1, 2, 3), slanted).lattice({4, 5, 6})},
          {"cylinder", test::sample_lattice("cylinder", test::corners())},
          {"tube", Cylinder(Point::Zero(), slanted, 0.6).lattice({4, 4, 9})},
          {"sphere", test::sample_lattice("sphere", test::corners())},
          {"shell", Sphere(Point::Ones(), kUnitBox, 0.5).lattice({4, 6, 8})},
          {"custom", test::sample_lattice("custom", test::corners())}};
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
        const NearestPlace::Result place = nearest.find(point);
        const double least = (samples.rowwise() - point.transpose()).rowwise().norm().minCoeff();
        EXPECT_LE(place.distance, least + 1e-7 * embedder.size()) << c.name << " " << i;
        EXPECT_LT((embedder.point(place.at) - place.point).norm(), 1e-12 * embedder.size());
        EXPECT_NEAR((place.point - point).norm(), place.distance, 1e-12 * embedder.size());
        EXPECT_TRUE(place.at.inside);
        EXPECT_TRUE((place.at.local.array() >= 0).all() && (place.at.local.array() <= 1).all());
      }
    }
  }
}

/// Few cells, so curved that Newton's method from the middle of each face misses some places: the
/// search of their parts finds them.
TEST(NearestPlace, MiddlesOfFacesAreNotEnough) {
  const Lattice box = Box(Point::Zero(), kUnitBox).lattice({4, 4, 4});
  for (const Lattice& lattice : {Sphere(Point::Zero(), kUnitBox, 0.5).lattice({4, 5, 6}),
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
  const NearestPlace box(Box(Point(0, 0, 0), kUnitBox).lattice({6, 5, 4}));
  EXPECT_EQ(box.find(Point(2, 0.25, -3)).point, Point(1, 0.25, 0));
  EXPECT_EQ(box.find(Point(2, 0.25, -3)).at.cell, (Index3{2, 0, 0}));
  EXPECT_EQ(box.find(Point(2, 0.25, -3)).at.local, Eigen::Vector3d(1, 0.5, 0));
  const NearestPlace can(Cylinder(Point(5, 0, 0), kUnitBox).lattice({4, 6, 11}));
  for (const double x : {4.2, 4.7, 5.0, 5.2, 5.6}) {
    for (const double z : {-0.5, 0.0, 0.3}) {
      const NearestPlace::Result place = can.find(Point(x, 3, z));
      EXPECT_LT((place.point - Point(x, 1, z)).norm(), 1e-7) << place.point.transpose();
    }
  }
  // Above the pole of a ball; the equator at u = 0 lies in the middle of a cell, touches the ball.
  const NearestPlace ball(Sphere(Point(5, 0, 0), kUnitBox).lattice({4, 6, 11}));
  EXPECT_NEAR(ball.find(Point(5, 7, 0)).distance, 6.0, 0.02);
  EXPECT_LT((ball.find(Point(5, 7, 0)).point - Point(5, 1, 0)).norm(), 0.02);
}

/// Layers that repeat close a B-spline; an axis with clamped knots ends at its first layer all the
/// same.
TEST(NearestPlace, ClampedAxesEndWhereBsplinesClose) {
  const std::array<double, 7> repeating{0, 1, 2, 3, 0, 1, 2};
  Points points(7 * 6 * 6, 3);
  for (int row = 0; row < points.rows(); ++row) {
    points.row(row) << repeating[static_cast<std::size_t>(row / 36)], row / 6 % 6, row % 6;
  }
  const NearestPlace nearest(Lattice({7, 6, 6}, points), Family(Family::Kind::kClamped));
  const NearestPlace::Result place = nearest.find(Point(-1, 2.5, 2.5));
  EXPECT_NEAR(place.distance, 1.0, 1e-6);
  EXPECT_EQ(place.at.cell, (Index3{0, 1, 1}));
  EXPECT_EQ(place.at.local[0], 0.0);
}

/// The nearest places of a convex shape are no further apart than the points: also across cells and
/// poles.
TEST(NearestPlace, NeighboursHaveNeighbouringPlaces) {
  for (const char* const kind : {"box", "cylinder", "sphere"}) {
    const Embedder embedder(test::sample_lattice(kind, test::corners()));
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
  const NearestPlace tube(Cylinder(Point::Zero(), kUnitBox, 0.5).lattice({5, 6, 16}));
  const NearestPlace::Result inside = tube.find(Point(0, 0.5, 0));
  EXPECT_NEAR(inside.distance, 0.5, 1e-3);
  EXPECT_LT(inside.parts, 2500);
  double total_parts = 0.0;
  const Embedder embedder(test::sample_lattice("sphere", test::corners()));
  const NearestPlace sphere(embedder.lattice());
  const Points points = points_outside(embedder, 200, 0.7, 6);
  for (Eigen::Index i = 0; i < points.rows(); ++i)
    total_parts += sphere.find(Point(points.row(i))).parts;
  std::printf("%.1f parts a point\n", total_parts / 200);
  EXPECT_LT(total_parts / 200, 200);
}

}  // namespace
}  // namespace hwffd
