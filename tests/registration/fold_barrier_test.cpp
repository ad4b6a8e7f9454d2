#include "hwffd/registration/fold_barrier.hpp"

#include <gtest/gtest.h>

#include <Eigen/LU>
#include <cmath>

#include "errors.hpp"
#include "hwffd/lattice/box.hpp"
#include "hwffd/lattice/fold.hpp"
#include "hwffd/oracle/oracle.hpp"
#include "random_numbers.hpp"

namespace hwffd {
namespace {

Lattice box(const Index3& dims, double sign = 1) {
  Eigen::Matrix3d edges;
  edges << sign, 0.25, 0, 0, 2, 0, 0.5, 0, 3;
  return Box(Point(1, 2, 3), edges).lattice(dims);
}

/// Control points moved at random by up to that part of the spacing.
Points shaken(const Lattice& rest, double amount, std::uint64_t seed) {
  RandomNumbers random(seed);
  Points points = rest.points();
  for (Eigen::Index i = 0; i < points.size(); ++i) points.data()[i] += random(-amount, amount);
  return points;
}

/// The same of the oracle's Jacobians.
FoldBarrier::Result expected(const Lattice& rest, const Points& points) {
  const Lattice lattice(rest.dims(), points);
  const Oracle oracle;
  const double mean = oracle.jet(rest.support({0, 0, 0}), {0.3, 0.3, 0.3}).jacobian.determinant();
  FoldBarrier::Result result;
  int count = 0;
  const Index3& n = rest.dims();
  for (const Index3& at : places({2 * n[0] - 5, 2 * n[1] - 5, 2 * n[2] - 5})) {
    Index3 cell{};
    Eigen::Vector3d local;
    for (std::size_t a = 0; a < 3; ++a) {
      cell[a] = std::min(at[a] / 2, n[a] - 4);
      local[static_cast<int>(a)] = at[a] / 2.0 - cell[a];
    }
    const double d = oracle.jet(lattice.support(cell), local).jacobian.determinant() / mean;
    result.least = std::min(result.least, d);
    result.most = std::max(result.most, d);
    ++count;
    if (d < 0.3) result.penalty += std::pow(0.3 - d, 3) / (0.09 * d);
  }
  result.penalty /= count;
  return result;
}

TEST(FoldBarrier, IsWhatItsFormulaSays) {
  int positive = 0;
  for (const double sign : {1.0, -1.0}) {
    const Lattice rest = box({6, 5, 7}, sign);
    const FoldBarrier barrier(rest);
    for (std::uint64_t seed = 1; seed < 20; ++seed) {
      const Points points = shaken(rest, 0.02 * static_cast<double>(seed), seed);
      const FoldBarrier::Result wanted = expected(rest, points);
      const FoldBarrier::Result got = barrier(points);
      const FoldBarrier::Result range = jacobian_range(rest, Lattice(rest.dims(), points));
      EXPECT_NEAR(got.least, wanted.least, 1e-12);
      EXPECT_NEAR(got.most, wanted.most, 1e-12);
      EXPECT_NEAR(range.least, wanted.least, 1e-12);
      EXPECT_NEAR(range.most, wanted.most, 1e-12);
      if (wanted.least > 0.0) {
        EXPECT_NEAR(got.penalty, wanted.penalty, 1e-9 * wanted.penalty);
        positive += wanted.penalty > 0.0 ? 1 : 0;
      } else {
        EXPECT_EQ(got.penalty, std::numeric_limits<double>::infinity());
      }
    }
  }
  EXPECT_GE(positive, 2);
}

TEST(FoldBarrier, GradientIsThatOfDifferences) {
  const Lattice rest = box({6, 5, 7});
  const FoldBarrier barrier(rest);
  Points points = shaken(rest, 0.08, 5);
  double amount = 0.08;
  while (barrier(points).penalty < 1e-3) points = shaken(rest, amount += 0.005, 5);
  ASSERT_TRUE(std::isfinite(barrier(points).penalty));
  Points gradient = Points::Constant(points.rows(), 3, 1.0);
  barrier(points, 2.0, &gradient);
  double largest = 0.0;
  for (Eigen::Index at = 0; at < points.size(); ++at) {
    const double step = 1e-6;
    Points more = points;
    Points less = points;
    more.data()[at] += step;
    less.data()[at] -= step;
    const double difference = 2 * (barrier(more).penalty - barrier(less).penalty) / (2 * step);
    EXPECT_NEAR(gradient.data()[at] - 1, difference, 1e-6 * (std::abs(difference) + 0.01));
    largest = std::max(largest, std::abs(difference));
  }
  EXPECT_GT(largest, 1e-3);
}

/// What it proves check_folds() does not find folded; what that finds folded it does not prove.
TEST(FoldBarrier, ProofAgreesWithTheCheck) {
  int proved = 0;
  int folded = 0;
  int as_much = 0;
  for (const double sign : {1.0, -1.0}) {
    const Lattice rest = box({5, 5, 5}, sign);
    const FoldBarrier barrier(rest);
    for (std::uint64_t seed = 0; seed < 12; ++seed) {
      const Points points = shaken(rest, 0.1 * static_cast<double>(seed), seed);
      const bool proof = barrier.proves_no_fold(points);
      const auto verdict = check_folds(Lattice(rest.dims(), points)).verdict;
      if (proof) {
        EXPECT_EQ(verdict, FoldCheck::Verdict::kProved) << seed;
        ++proved;
      }
      if (verdict == FoldCheck::Verdict::kFolded) {
        EXPECT_FALSE(proof) << seed;
        ++folded;
      }
      as_much += proof == (verdict == FoldCheck::Verdict::kProved) ? 1 : 0;
    }
    EXPECT_FALSE(barrier.proves_no_fold(box({5, 5, 5}, -sign).points()));
  }
  EXPECT_GE(proved, 6);
  EXPECT_GE(folded, 5);
  EXPECT_GE(as_much, 22);
}

/// Single cells close to a fold: none that folds is proved.
TEST(FoldBarrier, ProofIsSound) {
  const Lattice rest = box({4, 4, 4});
  const FoldBarrier barrier(rest);
  int proved = 0;
  int folded = 0;
  for (std::uint64_t seed = 0; seed < 400; ++seed) {
    const Points points = shaken(rest, 1.0 + 0.01 * static_cast<double>(seed), seed);
    const auto verdict = check_folds(Lattice(rest.dims(), points)).verdict;
    const bool proof = barrier.proves_no_fold(points);
    folded += verdict == FoldCheck::Verdict::kFolded ? 1 : 0;
    proved += proof ? 1 : 0;
    EXPECT_FALSE(proof && verdict == FoldCheck::Verdict::kFolded) << seed;
  }
  EXPECT_GT(proved, 40);
  EXPECT_GT(folded, 40);
}

/// The most regular cell that folds: at s = 0 the derivative is half the sum of two differences.
TEST(FoldBarrier, LeastFoldIsNotProved) {
  const Lattice rest = box({4, 4, 4});
  const FoldBarrier barrier(rest);
  const Point edge = rest.point(1, 0, 0) - rest.point(0, 0, 0);
  for (const double sum : {-0.02, 0.02}) {
    const double off[4] = {0, sum - 1, sum - 2, 0};
    Points points = rest.points();
    for (Eigen::Index row = 0; row < 64; ++row) points.row(row) += off[row / 16] * edge;
    const bool folds = sum < 0;
    EXPECT_EQ(check_folds(Lattice(rest.dims(), points)).verdict,
              folds ? FoldCheck::Verdict::kFolded : FoldCheck::Verdict::kProved);
    EXPECT_EQ(barrier.proves_no_fold(points), !folds);
  }
}

TEST(FoldBarrier, QuickCheckIsTheCheck) {
  int proved = 0;
  for (const double sign : {1.0, -1.0}) {
    const Lattice rest = box({5, 7, 4}, sign);
    for (std::uint64_t seed = 0; seed < 10; ++seed) {
      const Lattice lattice(rest.dims(), shaken(rest, 0.12 * static_cast<double>(seed), seed));
      const FoldCheck wanted = check_folds(lattice);
      const FoldCheck got = check_bspline_folds(lattice);
      EXPECT_EQ(got.verdict, wanted.verdict);
      EXPECT_NEAR(got.volume, wanted.volume, 1e-12 * std::abs(wanted.volume));
      proved += got.verdict == FoldCheck::Verdict::kProved ? 1 : 0;
    }
  }
  EXPECT_GE(proved, 4);
  EXPECT_LE(proved, 16);
}

TEST(FoldBarrier, RefusesAStartThatFolds) {
  const Lattice rest = box({4, 4, 4});
  Points points = rest.points();
  points.row(rest.index(2, 2, 2)) = points.row(rest.index(0, 0, 0));
  points.row(rest.index(2, 1, 2)) = points.row(rest.index(0, 0, 0));
  const std::string text = message_of<Error>([&] { FoldBarrier(Lattice(rest.dims(), points)); });
  expect_part(text, "start without folds: the lattice is folded at (cell 0 0 0; ");
  expect_part(text, "; give a start that folds nowhere, or allow folds");
}

}  // namespace
}  // namespace hwffd
