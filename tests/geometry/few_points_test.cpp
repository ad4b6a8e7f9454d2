// Lattices of 2 or 3 points along some axes: their maps are those of the curves that such points
// make, and what evaluates cells refuses them.

#include "hwffd/lattice/few_points.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <string>

#include "cube.hpp"
#include "errors.hpp"
#include "hwffd/lattice/around.hpp"
#include "hwffd/lattice/closure.hpp"
#include "hwffd/lattice/deformation.hpp"
#include "hwffd/lattice/embedder.hpp"
#include "hwffd/lattice/fold.hpp"
#include "hwffd/lattice/nearest_place.hpp"
#include "same_bits.hpp"

namespace hwffd {
namespace {

constexpr double kFewPointsTiny = 1e-13;

using Weights = std::array<double, 3>;

/// Weights of the 2 or 3 points of a Bezier curve.
Weights bezier(int n, double x) {
  const double y = 1 - x;
  if (n == 2) return {y, x, 0};
  return {y * y, 2 * x * y, x * x};
}

/// Those of straight lines from point to point, over all cells from 0 to 1.
Weights polyline(int n, double x) {
  Weights weights{};
  for (int i = 0; i < n; ++i) {
    weights[static_cast<std::size_t>(i)] = std::max(0.0, 1 - std::abs(x * (n - 1) - i));
  }
  return weights;
}

/// A lattice with so many points that is no box.
Lattice moved(const Index3& dims, const Family& family) {
  return Deformation::parse("random:5").apply(lattice_around("box", cube(), dims, family));
}

/// The point at coordinates from 0 to 1 over all cells.
Point evaluated(const Lattice& lattice, const Family& family, const Point& at) {
  const Index3 count = family.cells(lattice.dims());
  Index3 cell{};
  Eigen::Vector3d local;
  for (std::size_t a = 0; a < 3; ++a) {
    const auto axis = static_cast<Eigen::Index>(a);
    cell[a] = std::min(static_cast<int>(at[axis] * count[a]), count[a] - 1);
    local[axis] = at[axis] * count[a] - cell[a];
  }
  return Oracle().evaluate(family.support(lattice, cell), local[0], local[1], local[2]);
}

Point wanted(const Lattice& lattice, const Point& at, Weights (*weights)(int, double)) {
  std::array<Weights, 3> axes;
  for (std::size_t a = 0; a < 3; ++a) {
    axes[a] = weights(lattice.dims()[a], at[static_cast<Eigen::Index>(a)]);
  }
  Point sum = Point::Zero();
  for (const auto& [i, j, k] : places(lattice.dims())) {
    const double weight = axes[0][static_cast<std::size_t>(i)] *
                          axes[1][static_cast<std::size_t>(j)] *
                          axes[2][static_cast<std::size_t>(k)];
    sum += weight * lattice.point(i, j, k);
  }
  return sum;
}

class FewPoints : public testing::TestWithParam<std::string> {
 protected:
  const Family family = Family::parse(GetParam());
};

TEST_P(FewPoints, TheMapIsThatOfTheCurves) {
  const auto weights = family.kind() == Family::Kind::kBernstein ? bezier : polyline;
  for (const Index3& dims : {Index3{2, 2, 2}, Index3{3, 2, 3}, Index3{2, 3, 2}, Index3{3, 3, 3}}) {
    const bool straight = dims == Index3{2, 2, 2};
    if (family.kind() == Family::Kind::kCatmullRom && !straight) continue;
    const Lattice few = moved(dims, family);
    const Lattice more = whole(few, family);
    for (const double s : {0.0, 0.2, 0.5, 0.9}) {
      for (const double t : {0.1, 0.5, 1.0}) {
        const Point at(s, t, 0.7);
        EXPECT_LT((evaluated(more, family, at) - wanted(few, at, weights)).norm(), kFewPointsTiny)
            << dims[0] << dims[1] << dims[2] << " at " << at.transpose();
      }
    }
  }
}

TEST_P(FewPoints, ComeBack) {
  for (const Index3& dims : {Index3{2, 3, 4}, Index3{3, 7, 2}, Index3{2, 2, 2}}) {
    const Lattice few = moved(dims, family);
    const Lattice again = thinned(whole(few, family), dims, family);
    EXPECT_LT((again.points() - few.points()).norm(), kFewPointsTiny);
  }
  const Lattice enough = moved({4, 7, 4}, family);
  EXPECT_TRUE(same_bits(whole(enough, family).points(), enough.points()));
}

TEST_P(FewPoints, BoxesAtRestStayBoxes) {
  const Lattice rest = whole(lattice_around("box", cube(), Index3{2, 3, 4}, family), family);
  const Embedder embedder(rest, family);
  for (Eigen::Index row = 0; row < cube().rows(); ++row) {
    const Point corner = cube().row(row);
    const Embedding embedding = embedder.embed(corner);
    EXPECT_EQ(embedding.status, EmbeddingStatus::kInside);
    EXPECT_LT((embedder.point(embedding.at) - corner).norm(), kFewPointsTiny);
  }
  EXPECT_EQ(check_folds(rest, 4, family).verdict, FoldCheck::Verdict::kProved);
}

TEST_P(FewPoints, EvaluatorsOfCellsRefuseThem) {
  const char* const text = "lattice of 2 x 3 x 4 points: each axis takes 4 to 64 points";
  const Lattice few = moved({2, 3, 4}, family);
  EXPECT_ERROR(Embedder(few, family), text);
  EXPECT_ERROR(NearestPlace(few, family), text);
  EXPECT_ERROR(check_folds(few, 4, family), text);
  EXPECT_ERROR(family.evaluable(few), text);
  EXPECT_EQ(few.cells(), (Index3{0, 0, 1}));
  EXPECT_FALSE(Closure(few).joined());
}

INSTANTIATE_TEST_SUITE_P(, FewPoints, testing::Values("bernstein", "catmull-rom", "linear"),
                         [](const auto& info) {
                           return info.param.substr(0, info.param.find('-'));
                         });

TEST(FewPointsOf, FamiliesThatInterpolate) {
  for (const char* const name : {"catmull-rom", "linear"}) {
    const Family family = Family::parse(name);
    const Lattice few = moved({3, 2, 3}, family);
    const Lattice more = whole(few, family);
    for (const auto& [i, j, k] : places(few.dims())) {
      const Point at(i / 2.0, j, k / 2.0);
      EXPECT_LT((evaluated(more, family, at) - few.point(i, j, k)).norm(), kFewPointsTiny);
    }
  }
}

TEST(FewPointsOf, OtherFamiliesAreRefused) {
  for (const char* const name : {"bspline", "clamped"}) {
    EXPECT_ERROR(whole_dims({4, 3, 4}, Family::parse(name)),
                 std::string("lattice of 4 x 3 x 4 points: each axis takes 4 to 64 points where "
                             "the family is ") +
                     name + ", and from 2 on where it is one of bernstein, catmull-rom, linear");
  }
  EXPECT_ERROR(whole_dims({4, 1, 4}, Family::parse("linear")),
               "lattice of 4 x 1 x 4 points: each axis takes 2 to 64 points");
  EXPECT_ERROR(Lattice({1, 4, 4}, Points::Zero(16, 3)),
               "lattice of 1 x 4 x 4 points: each axis takes 2 to 64 points");
}

}  // namespace
}  // namespace hwffd
