// C2 across cells (paper, section 2: FFDs "can control surface continuity"): derivatives of eq. (1)
// of orders 0, 1 and 2 are the same on both sides of a face, those of order 3 are not.
#include <gmpxx.h>
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstdio>
#include <random>

#include "hwffd/lattice/lattice.hpp"
#include "hwffd/oracle/oracle.hpp"
#include "uniform.hpp"

namespace hwffd {
namespace {

using Fraction = mpq_class;
using Place = std::array<Fraction, 3>;

constexpr std::size_t kSize = 5;  // points an axis: 2 x 2 x 2 cells
constexpr int kLattices = 8;

/// Control points, one component, small integers.
using Values = std::array<int, kSize * kSize * kSize>;

Values random_values(std::mt19937_64& random) {
  Values values{};
  for (int& value : values) value = static_cast<int>(random() % 41) - 20;
  return values;
}

/// Derivative of an order of B_l at x, exactly: six times the coefficients of the paper.
Fraction blending(int l, const Fraction& x, int order) {
  static constexpr std::array<std::array<int, 4>, 4> kSix{
      {{1, -3, 3, -1}, {4, 0, -6, 3}, {1, 3, 3, -3}, {0, 0, 0, 1}}};
  Fraction sum = 0;
  Fraction power = 1;
  for (int n = order; n < 4; ++n, power *= x) {
    int factor = kSix[static_cast<std::size_t>(l)][static_cast<std::size_t>(n)];
    for (int i = 0; i < order; ++i) factor *= n - i;
    sum += factor * power / 6;
  }
  return sum;
}

/// The mixed derivative of eq. (1) of these orders along s, t, u.
Fraction derivative(const Values& values, const Index3& cell, const Place& local,
                    const Index3& order) {
  Fraction sum = 0;
  for (int p = 0; p < 64; ++p) {
    const Index3 at{p / 16, p / 4 % 4, p % 4};
    Fraction weight = 1;
    std::size_t row = 0;
    for (std::size_t a = 0; a < 3; ++a) {
      weight *= blending(at[a], local[a], order[a]);
      row = row * kSize + cell[a] + at[a];
    }
    sum += weight * values[row];
  }
  return sum;
}

/// What the cells that share a place say of its derivatives.
struct Shared {
  int compared = 0;
  int differ = 0;
};

/// Compares the derivatives of an order along one axis, and of orders 0 to 2 along the others,
/// between the cells that share a place.
/// @param shared axes along which the place lies between two cells, as bits: one for a face, two
/// for
///               an edge, three for a corner
Shared compare(const Values& values, unsigned shared, const Place& inside, int axis, int order) {
  Shared result;
  for (int others = 0; others < 9; ++others) {
    Index3 orders{};
    orders[static_cast<std::size_t>(axis)] = order;
    orders[static_cast<std::size_t>((axis + 1) % 3)] = others / 3;
    orders[static_cast<std::size_t>((axis + 2) % 3)] = others % 3;
    Fraction first;
    for (unsigned sides = 0; sides < 8; ++sides) {
      if ((sides & ~shared) != 0) continue;
      Index3 cell{0, 0, 0};
      Place local = inside;
      for (std::size_t a = 0; a < 3; ++a) {
        if ((shared >> a & 1) == 0) continue;
        cell[a] = static_cast<int>(sides >> a) & 1;
        local[a] = cell[a] == 0 ? 1 : 0;
      }
      const Fraction value = derivative(values, cell, local, orders);
      if (sides == 0) {
        first = value;
        continue;
      }
      ++result.compared;
      if (value != first) ++result.differ;
    }
  }
  return result;
}

Shared compare_all(int order) {
  std::mt19937_64 random(11);
  Shared total;
  for (int n = 0; n < kLattices; ++n) {
    const Values values = random_values(random);
    Place inside;
    for (Fraction& x : inside) x = Fraction(random() % 8) / 7;
    for (unsigned shared = 1; shared < 8; ++shared) {
      for (int axis = 0; axis < 3; ++axis) {
        if ((shared >> axis & 1) == 0) continue;
        const Shared result = compare(values, shared, inside, axis, order);
        total.compared += result.compared;
        total.differ += result.differ;
      }
    }
  }
  return total;
}

// 3 faces with one other side, 3 edges with three, looked at along 2 axes, a corner
// with seven along 3: 42 pairs, each with 9 orders along the other axes.
constexpr int kCompared = kLattices * 42 * 9;

TEST(Continuity, DerivativesToTheSecondAreExactlyEqual) {
  for (int order = 0; order <= 2; ++order) {
    const Shared all = compare_all(order);
    EXPECT_EQ(all.compared, kCompared);
    EXPECT_EQ(all.differ, 0) << order;
  }
}

TEST(Continuity, ThirdDerivativesDiffer) {
  const Shared all = compare_all(3);
  EXPECT_EQ(all.compared, kCompared);
  EXPECT_GT(all.differ, kCompared / 2);
}

/// The same in double: positions and first derivatives by the oracle on both sides of a face,
/// second ones by differences of the first that stay on their side.
TEST(Continuity, InDoubleWithinRounding) {
  std::mt19937_64 random(12);
  const Oracle oracle;
  const double step = 1e-6;
  double worst = 0.0;
  double worst_second = 0.0;
  int faces = 0;
  for (int n = 0; n < 300; ++n, ++faces) {
    Points points(kSize * kSize * kSize, 3);
    for (int c = 0; c < 3; ++c) {
      const Values values = random_values(random);
      for (std::size_t i = 0; i < values.size(); ++i) {
        points(static_cast<Eigen::Index>(i), c) = values[i] / 20.0;
      }
    }
    const Lattice lattice({kSize, kSize, kSize}, points);
    const int axis = n % 3;
    Eigen::Vector3d local;
    for (double& x : local) x = unit(random);
    const auto jet = [&](int side, double inwards) {
      Index3 cell{0, 0, 0};
      cell[static_cast<std::size_t>(axis)] = side;
      Eigen::Vector3d at = local;
      at[axis] = side == 0 ? 1.0 - inwards : inwards;
      return oracle.jet(lattice.support(cell), at);
    };
    const Oracle::Jet below = jet(0, 0.0);
    const Oracle::Jet above = jet(1, 0.0);
    worst = std::max(worst, (below.value - above.value).norm());
    worst = std::max(worst, (below.jacobian - above.jacobian).norm());
    const Eigen::Matrix3d second = (below.jacobian - jet(0, step).jacobian) / step;
    const Eigen::Matrix3d other = (jet(1, step).jacobian - above.jacobian) / step;
    worst_second = std::max(worst_second, (second - other).norm());
  }
  std::printf("%d faces: positions and slopes differ by %.2g, curvatures by %.2g\n", faces, worst,
              worst_second);
  EXPECT_LE(worst, 1e-14);
  EXPECT_LE(worst_second, 1e-4);
  EXPECT_GT(worst_second, 0.0);
}

}  // namespace
}  // namespace hwffd
