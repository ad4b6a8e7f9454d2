#include "hwffd/oracle/oracle.hpp"

#include <gtest/gtest.h>

#include <Eigen/LU>
#include <random>

#include "hwffd/lattice/box.hpp"
#include "uniform.hpp"

namespace hwffd {
namespace {

constexpr double kTiny = 1e-14;

Support random_support(std::uint64_t seed) {
  std::mt19937_64 random(seed);
  Support support;
  for (int i = 0; i < 192; ++i) support(i / 3, i % 3) = 2 * unit(random) - 1;
  return support;
}

void expect_weights(const Oracle& oracle, double x, const Eigen::Vector4d& expected) {
  for (const Oracle::Axis axis : {Oracle::kS, Oracle::kT, Oracle::kU}) {
    EXPECT_LT((oracle.blending(axis, x) - expected).cwiseAbs().maxCoeff(), kTiny)
        << "axis " << axis << ", x = " << x;
  }
}

TEST(Oracle, PublishedBSplineValues) {
  const Oracle oracle;
  expect_weights(oracle, 0.0, Eigen::Vector4d(1, 4, 1, 0) / 6.0);
  expect_weights(oracle, 1.0, Eigen::Vector4d(0, 1, 4, 1) / 6.0);
  expect_weights(oracle, 0.5, Eigen::Vector4d(1, 23, 23, 1) / 48.0);
  expect_weights(oracle, 1.0 / 3.0, Eigen::Vector4d(8, 93, 60, 1) / 162.0);
}

TEST(Oracle, PublishedBernsteinValues) {
  const Oracle oracle(Oracle::bernstein());
  expect_weights(oracle, 0.0, {1, 0, 0, 0});
  expect_weights(oracle, 1.0, {0, 0, 0, 1});
  expect_weights(oracle, 0.5, Eigen::Vector4d(1, 3, 3, 1) / 8.0);
  expect_weights(oracle, 0.25, Eigen::Vector4d(27, 27, 9, 1) / 64.0);
}

TEST(Oracle, PartitionOfUnityAndRange) {
  for (const auto& coefficients : {Oracle::uniform_bspline(), Oracle::bernstein()}) {
    const Oracle oracle(coefficients);
    for (int i = 0; i <= 1000; ++i) {
      const Eigen::Vector4d b = oracle.blending(Oracle::kS, i / 1000.0);
      EXPECT_NEAR(b.sum(), 1.0, kTiny);
      EXPECT_GE(b.minCoeff(), -kTiny);
    }
  }
}

TEST(Oracle, MirroredCoordinateMirrorsTheWeights) {
  for (const auto& coefficients : {Oracle::uniform_bspline(), Oracle::bernstein()}) {
    const Oracle oracle(coefficients);
    for (int i = 0; i <= 100; ++i) {
      const Eigen::Vector4d here = oracle.blending(Oracle::kU, i / 100.0);
      const Eigen::Vector4d there = oracle.blending(Oracle::kU, 1.0 - i / 100.0);
      EXPECT_LT((here - there.reverse()).cwiseAbs().maxCoeff(), kTiny);
    }
  }
}

/// One control point is 1 and all others 0: the result is the product of its three weights, so
/// a swapped axis or a wrong index shows.
TEST(Oracle, EachControlPointHasItsOwnWeight) {
  const Oracle oracle(Oracle::uniform_bspline(), Oracle::bernstein(), Oracle::uniform_bspline());
  const double s = 0.125;
  const double t = 0.375;
  const double u = 0.8125;
  for (int l = 0; l < 4; ++l) {
    for (int m = 0; m < 4; ++m) {
      for (int n = 0; n < 4; ++n) {
        Support support = Support::Zero();
        support.row(16 * l + 4 * m + n) << 1.0, -2.0, 4.0;
        const double weight = oracle.blending(Oracle::kS, s)[l] *
                              oracle.blending(Oracle::kT, t)[m] * oracle.blending(Oracle::kU, u)[n];
        const Eigen::Vector3d expected = weight * Eigen::Vector3d(1.0, -2.0, 4.0);
        EXPECT_LT((oracle.evaluate(support, s, t, u) - expected).norm(), kTiny);
      }
    }
  }
}

/// The paper's formulas written out once more, in another form and another order of summation.
TEST(Oracle, AgreesWithTheFormulasOfThePaper) {
  const auto paper = [](double x) -> Eigen::Vector4d {
    return Eigen::Vector4d((1 - x) * (1 - x) * (1 - x), 4 - 6 * x * x + 3 * x * x * x,
                           1 + 3 * x + 3 * x * x - 3 * x * x * x, x * x * x) /
           6.0;
  };
  const Support support = random_support(1);
  const Oracle oracle;
  std::mt19937_64 random(2);
  for (int i = 0; i < 200; ++i) {
    Eigen::Vector3d at;
    for (double& x : at) x = unit(random);
    const Eigen::Vector4d b_s = paper(at[0]);
    const Eigen::Vector4d b_t = paper(at[1]);
    const Eigen::Vector4d b_u = paper(at[2]);
    Eigen::Vector3d expected = Eigen::Vector3d::Zero();
    for (int p = 63; p >= 0; --p) {
      expected += support.row(p).transpose() * b_u[p % 4] * b_t[p / 4 % 4] * b_s[p / 16];
    }
    EXPECT_LT((oracle.evaluate(support, at[0], at[1], at[2]) - expected).norm(), kTiny);
  }
}

/// Moving all control points by an affine map moves every result by that map.
TEST(Oracle, AffineMapsGoThrough) {
  Eigen::Matrix3d linear;
  linear << 1.5, -0.25, 0.5, 0.125, 0.75, -1.0, 2.0, 0.375, -0.5;
  ASSERT_GT(std::abs(linear.determinant()), 0.1);
  const Eigen::RowVector3d shift(3.0, -7.0, 0.5);
  for (const auto& coefficients : {Oracle::uniform_bspline(), Oracle::bernstein()}) {
    const Oracle oracle(coefficients);
    for (std::uint64_t seed = 1; seed <= 50; ++seed) {
      const Support before = random_support(seed);
      const Support after = (before * linear.transpose()).rowwise() + shift;
      const double s = static_cast<double>(seed) / 50.0;
      const Eigen::Vector3d q = oracle.evaluate(before, s, 1.0 - s, s * s);
      const Eigen::Vector3d expected = linear * q + shift.transpose();
      EXPECT_LT((oracle.evaluate(after, s, 1.0 - s, s * s) - expected).norm(), 1e-13);
    }
  }
}

}  // namespace
}  // namespace hwffd
