#include "hwffd/lattice/bezier_volume.hpp"

#include <gtest/gtest.h>

#include <Eigen/LU>
#include <cmath>
#include <random>

#include "hwffd/oracle/oracle.hpp"

namespace hwffd {
namespace {

double uniform(std::mt19937_64& random) {
  return static_cast<double>(random() >> 11) * 0x1p-52 - 1;
}

Support random_support(std::uint64_t seed) {
  std::mt19937_64 random(seed);
  Support support;
  for (Eigen::Index i = 0; i < support.size(); ++i) support.data()[i] = uniform(random);
  return support;
}

double bernstein(int n, int i, double x) {
  double value = std::pow(x, i) * std::pow(1 - x, n - i);
  for (int k = 1; k <= i; ++k) value = value * (n - k + 1) / k;
  return value;
}

/// The volume at a place, by the definition.
Eigen::RowVectorXd at(const BezierVolume& volume, const Eigen::Vector3d& x) {
  const Index3& n = volume.degree();
  Eigen::RowVectorXd sum = Eigen::RowVectorXd::Zero(volume.coefficients().cols());
  for (Eigen::Index row = 0; row < volume.coefficients().rows(); ++row) {
    const Index3 i = volume.place(row);
    sum += volume.coefficients().row(row) * bernstein(n[0], i[0], x[0]) *
           bernstein(n[1], i[1], x[1]) * bernstein(n[2], i[2], x[2]);
  }
  return sum;
}

TEST(BezierVolume, CellAndDeterminantAgainstTheOracle) {
  const Oracle oracle;
  for (std::uint64_t seed = 1; seed <= 5; ++seed) {
    const Support support = random_support(seed);
    const BezierVolume map = BezierVolume::of_cell(support);
    const BezierVolume determinant = jacobian_determinant(map);
    EXPECT_EQ(determinant.degree(), (Index3{8, 8, 8}));
    for (const Eigen::Vector3d& x :
         {Eigen::Vector3d(0, 0, 0), Eigen::Vector3d(1, 1, 0), Eigen::Vector3d(0.2, 0.9, 0.4)}) {
      const Oracle::Jet jet = oracle.jet(support, x);
      EXPECT_LT((at(map, x).transpose() - jet.value).norm(), 1e-14);
      EXPECT_NEAR(at(determinant, x)[0], jet.jacobian.determinant(), 1e-13);
    }
  }
}

TEST(BezierVolume, PartsAreTheWholeSeenCloser) {
  const BezierVolume map = BezierVolume::of_cell(random_support(7));
  const Eigen::Vector3d x(0.3, 0.8, 0.1);
  const auto octants = map.octants();
  for (int o = 0; o < 8; ++o) {
    const Eigen::Vector3d corner(o >> 2 & 1, o >> 1 & 1, o & 1);
    const Eigen::Vector3d whole = (corner + x) / 2;
    EXPECT_LT((at(octants[static_cast<std::size_t>(o)], x) - at(map, whole)).norm(), 1e-14);
  }
}

TEST(BezierVolume, IntegralIsTheMeanOfItsValues) {
  const BezierVolume determinant = jacobian_determinant(BezierVolume::of_cell(random_support(8)));
  // Gauss-Legendre of 5 points is exact to degree 9.
  const std::array<double, 5> nodes{-0.906179845938664, -0.5384693101056831, 0.0,
                                    0.5384693101056831, 0.906179845938664};
  const std::array<double, 5> weights{0.2369268850561891, 0.4786286704993665, 0.5688888888888889,
                                      0.4786286704993665, 0.2369268850561891};
  double sum = 0.0;
  for (std::size_t i = 0; i < 125; ++i) {
    const std::size_t a = i / 25;
    const std::size_t b = i / 5 % 5;
    const std::size_t c = i % 5;
    const Eigen::Vector3d x((1 + nodes[a]) / 2, (1 + nodes[b]) / 2, (1 + nodes[c]) / 2);
    sum += weights[a] * weights[b] * weights[c] / 8 * at(determinant, x)[0];
  }
  EXPECT_NEAR(determinant.integral()[0], sum, 1e-13);
}

/// (2 - s + t u) times s^2, (1 - t) or u, and the factor out again.
TEST(BezierVolume, FactorsDivideOut) {
  BezierVolume::Coefficients c(8, 1);
  for (int i = 0; i < 8; ++i) c(i, 0) = 2.0 - (i >> 2 & 1) + ((i & 3) == 3 ? 1 : 0);
  const BezierVolume plain({1, 1, 1}, c);
  const auto times = [&](const Index3& degree, const std::vector<double>& factor) {
    const Eigen::Map<const Eigen::VectorXd> column(factor.data(),
                                                   static_cast<Eigen::Index>(factor.size()));
    return product(plain, BezierVolume(degree, column));
  };
  const auto same = [&](const BezierVolume& other) {
    return other.degree() == plain.degree() &&
           (other.coefficients() - plain.coefficients()).norm() < 1e-15;
  };
  EXPECT_PRED1(same, times({2, 0, 0}, {0, 0, 1}).without_factor(0, 0, 2));
  EXPECT_PRED1(same, times({0, 1, 0}, {1, 0}).without_factor(1, 1, 1));
  EXPECT_PRED1(same, times({0, 0, 1}, {0, 1}).without_factor(2, 0, 1));
}

TEST(OracleJet, AgainstEvaluateAndDifferences) {
  const Oracle oracle(Oracle::uniform_bspline(), Oracle::bernstein(), Oracle::catmull_rom());
  const Support support = random_support(9);
  const Eigen::Vector3d x(0.15, 0.6, 0.95);
  const Oracle::Jet jet = oracle.jet(support, x);
  const auto value = [&](const Eigen::Vector3d& p) {
    return oracle.evaluate(support, p[0], p[1], p[2]);
  };
  EXPECT_LT((jet.value - value(x)).norm(), 1e-15);
  for (int a = 0; a < 3; ++a) {
    const Eigen::Vector3d step = 1e-5 * Eigen::Vector3d::Unit(a);
    const Eigen::Vector3d slope = (value(x + step) - value(x - step)) / 2e-5;
    EXPECT_LT((jet.jacobian.col(a) - slope).norm(), 1e-9);
  }
}

}  // namespace
}  // namespace hwffd
