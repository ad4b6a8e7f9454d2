// Families of blending functions: what their functions are, how cells join, and that points
// embedded with them come back.

#include "hwffd/lattice/family.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "cube.hpp"
#include "errors.hpp"
#include "hwffd/lattice/around.hpp"
#include "hwffd/lattice/attachment.hpp"
#include "hwffd/lattice/deformation.hpp"
#include "hwffd/lattice/fold.hpp"
#include "hwffd/lattice/lattice_evaluator.hpp"
#include "same_bits.hpp"

namespace hwffd {
namespace {

constexpr double kTiny = 1e-13;

std::vector<Family> families() {
  std::vector<Family> all;
  for (const std::string& name : Family::names()) all.push_back(Family::parse(name));
  return all;
}

/// Seven points an axis suit all of them.
Lattice moved(const Family& family) {
  const Lattice box = lattice_around("box", cube(), family.bspline_dims({7, 10, 7}));
  return Deformation::parse("random:3").apply(family.from_bspline(box));
}

/// The function of a clamped spline by the recursion itself, in t.
double clamped_function(int points, int i, int degree, double t) {
  const auto knot = [&](int k) {
    return static_cast<double>(std::min(std::max(k - 3, 0), points - 3));
  };
  if (degree == 0) return knot(i) <= t && t < knot(i + 1) ? 1.0 : 0.0;
  double sum = 0;
  const double rise = knot(i + degree) - knot(i);
  const double fall = knot(i + degree + 1) - knot(i + 1);
  if (rise > 0) sum += (t - knot(i)) / rise * clamped_function(points, i, degree - 1, t);
  if (fall > 0) {
    sum += (knot(i + degree + 1) - t) / fall * clamped_function(points, i + 1, degree - 1, t);
  }
  return sum;
}

TEST(Family, NamesAreReadAndRefused) {
  for (const std::string& name : Family::names()) EXPECT_EQ(Family::parse(name).name(), name);
  EXPECT_EQ(Family().name(), "bspline");
  EXPECT_USAGE_ERROR(Family::parse("bezier"),
                     "blending functions 'bezier' are unknown; one of bspline, clamped, bernstein, "
                     "catmull-rom, linear");
}

TEST(Family, BernsteinWantsWholeCells) {
  const Family family = Family::parse("bernstein");
  for (const int n : {4, 7, 49}) EXPECT_NO_THROW(family.check_dims({n, 4, 7}));
  for (const int n : {5, 6, 52, 64}) {
    EXPECT_ERROR_PART(family.check_dims({4, n, 4}), "takes 4, 7, 10, ... or 49 points");
  }
  EXPECT_EQ(family.cells({4, 7, 49}), (Index3{1, 2, 16}));
  EXPECT_EQ(family.bspline_dims({4, 7, 49}), (Index3{4, 5, 19}));
}

TEST(Family, FunctionsSumToOneAndClampedOnesAreThoseOfTheirKnots) {
  for (const Family& family : families()) {
    for (const int points : {4, 7, 10}) {
      for (int cell = 0; cell < family.cells({points, 4, 4})[0]; ++cell) {
        EXPECT_TRUE(Oracle::sum_to_one(family.functions(points, cell))) << family.name();
      }
    }
  }
  const Family clamped = Family::parse("clamped");
  for (const int points : {4, 5, 6, 7, 12}) {
    for (int cell = 0; cell < points - 3; ++cell) {
      for (const double x : {0.0, 0.3, 0.99}) {
        const Eigen::Vector4d got =
            clamped.functions(points, cell) * Eigen::Vector4d(1, x, x * x, x * x * x);
        for (int l = 0; l < 4; ++l) {
          EXPECT_NEAR(got[l], clamped_function(points, cell + l, 3, cell + x), kTiny);
        }
      }
    }
  }
  EXPECT_TRUE(clamped.functions(4, 0).isApprox(Oracle::bernstein(), kTiny));
}

TEST(Family, SupportsAreTheMapOfTheFamily) {
  for (const Family& family : families()) {
    const Lattice lattice = moved(family);
    const Family::Evaluable evaluable = family.evaluable(lattice);
    for (const Index3& cell : places(family.cells(lattice.dims()))) {
      Embedded at{cell, {0.2, 0.7, 0.4}, true};
      const Oracle own(family.functions(lattice.dims()[0], cell[0]),
                       family.functions(lattice.dims()[1], cell[1]),
                       family.functions(lattice.dims()[2], cell[2]));
      const Support points =
          lattice.support({family.first(cell[0]), family.first(cell[1]), family.first(cell[2])});
      const Point exact = own.evaluate(points, 0.2, 0.7, 0.4);
      const Point by_support = Oracle().evaluate(family.support(lattice, cell), 0.2, 0.7, 0.4);
      EXPECT_LT((by_support - exact).norm(), 1e-12) << family.name();
      const Points by_device =
          evaluate_in(evaluable.lattice, {evaluable.at(at)}, evaluable.blending);
      EXPECT_LT((by_device.row(0).transpose() - exact).norm(), 1e-12) << family.name();
    }
    EXPECT_ERROR_PART(family.support(lattice, {0, 9, 0}), "is outside the lattice");
  }
}

TEST(Family, LatticesOfBsplinesKeepTheirMap) {
  const Lattice bspline =
      Deformation::parse("random:2").apply(lattice_around("cylinder", cube(), {5, 5, 8}));
  for (const std::string name : {"clamped", "bernstein"}) {
    const Family family = Family::parse(name);
    const Lattice lattice = family.from_bspline(bspline);
    ASSERT_EQ(family.bspline_dims(lattice.dims()), bspline.dims());
    for (const Index3& cell : places(bspline.cells())) {
      EXPECT_LT((family.support(lattice, cell) - bspline.support(cell)).norm(), 1e-11) << name;
    }
  }
  EXPECT_TRUE(same_bits(Family::parse("linear").from_bspline(bspline).points(), bspline.points()));
}

TEST(Family, PointsComeBackFromTheirPlaces) {
  for (const Family& family : families()) {
    const Lattice rest = moved(family);
    const Points points = 0.3 * Points::Random(200, 3);
    const Attachment attachment(rest, points, Outside::parse("keep"), family);
    ASSERT_EQ(attachment.summary().inside, 200u) << family.name();
    EXPECT_LT(attachment.summary().worst_residual, 1e-11) << family.name();
    const Family::Evaluable evaluable = family.evaluable(rest);
    std::vector<Embedded> places;
    for (const Embedded& place : attachment.places()) places.push_back(evaluable.at(place));
    const Points back =
        attachment.follow(evaluate_in(evaluable.lattice, places, evaluable.blending));
    EXPECT_LT((back - points).cwiseAbs().maxCoeff(), 1e-11) << family.name();
    for (const Eigen::Matrix3d& gradient : attachment.gradients(rest)) {
      EXPECT_TRUE(gradient.isIdentity(1e-9)) << family.name();
    }
  }
}

TEST(Family, BoxesOfAllFamiliesHoldWhatTheyWereMadeFor) {
  Points points = Points::Random(500, 3);
  for (const Family& family : families()) {
    const Lattice rest =
        family.from_bspline(lattice_around("box", points, family.bspline_dims({7, 7, 4})));
    const Attachment attachment(rest, points, Outside::parse("keep"), family);
    EXPECT_EQ(attachment.summary().inside, 500u) << family.name();
    EXPECT_EQ(check_folds(rest, 6, family).verdict, FoldCheck::Verdict::kProved) << family.name();
  }
}

TEST(Family, PointsOutsideFollowTheNearestPlace) {
  const Points far = (Points(3, 3) << 3, 0.1, 0.2, -0.1, -4, 0, 2, 2, 2).finished();
  for (const Family& family : families()) {
    const Lattice rest =
        family.from_bspline(lattice_around("sphere", cube(), family.bspline_dims({7, 10, 10})));
    const Lattice lifted(rest.dims(), rest.points().rowwise() + Eigen::RowVector3d(0, 5, 0));
    const Attachment attachment(rest, far, Outside::parse("clamp"), family);
    ASSERT_EQ(attachment.places().size(), 3u);
    const Family::Evaluable evaluable = family.evaluable(lifted);
    std::vector<Embedded> places;
    for (const Embedded& place : attachment.places()) places.push_back(evaluable.at(place));
    const Points moved =
        attachment.follow(evaluate_in(evaluable.lattice, places, evaluable.blending));
    EXPECT_LT((moved - far - Points(Points::Zero(3, 3).rowwise() + Eigen::RowVector3d(0, 5, 0)))
                  .cwiseAbs()
                  .maxCoeff(),
              1e-6)
        << family.name();
  }
}

}  // namespace
}  // namespace hwffd
