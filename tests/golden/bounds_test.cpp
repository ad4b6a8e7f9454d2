// The proved bounds of errors: their parts against what is computed at every coordinate, and one
// worked out by hand. The studies hold them against the models.
#include <gtest/gtest.h>

#include <cmath>

#include "hwffd/bounds/axis_error.hpp"
#include "hwffd/bounds/bound.hpp"
#include "hwffd/oracle/oracle.hpp"

namespace hwffd::test {
namespace {

/// What is propagated must cover what looking at every coordinate finds, and not by far.
void expect_covered(const bounds::AxisError& all, const bounds::AxisError& propagated) {
  for (int i = 0; i < bounds::kPieces; ++i) {
    EXPECT_LE(all[i].error, propagated[i].error) << "piece " << i;
    EXPECT_GE(3 * all[i].error, propagated[i].error) << "piece " << i;
    for (int l = 0; l < 4; ++l) EXPECT_LE(all[i].weight[l], propagated[i].weight[l] + 1e-15);
  }
}

TEST(AxisError, PropagatedErrorCoversTheExhaustiveOne) {
  expect_covered(bounds::exhaustive_axis_error<16>(), bounds::propagated_axis_error(16));
}

TEST(AxisError, PropagatedErrorOfPowersCoversTheExhaustiveOne) {
  expect_covered(bounds::exhaustive_powers_error<16>(), bounds::propagated_powers_error(16));
  expect_covered(bounds::exhaustive_powers_error<17>(), bounds::propagated_powers_error(17));
}

// The functions that the proof stands on are those of the oracle, and each other's derivatives.
TEST(AxisError, BlendingFunctionsAndSlopes) {
  const Oracle oracle;
  for (int i = 0; i <= 100; ++i) {
    const double x = i / 100.0;
    const Eigen::Vector4d exact = oracle.blending(Oracle::kS, x);
    for (int l = 0; l < 4; ++l) {
      EXPECT_NEAR(bounds::bspline(x)[l], exact[l], 1e-15);
      const double slope = (bounds::bspline(x + 1e-6)[l] - bounds::bspline(x - 1e-6)[l]) / 2e-6;
      EXPECT_NEAR(bounds::bspline_slope(x)[l], slope, 1e-8);
    }
  }
}

// The bound worked out by hand: where two weights of an axis are 1/2 and two are 0, 4 products of
// two weights and 8 of three are rounded.
TEST(ProductBound, HandValue) {
  constexpr double kUnit = 0x1p-16;
  constexpr double kError = 0x1p-12;
  constexpr double kSmall = 0x1p-18;  // a quarter of a unit
  bounds::AxisError axis;
  for (bounds::AxisPiece& piece : axis) piece = {kError, {0.5, 0.5, 0, 0}};
  const double weights = std::pow(1 + kError, 3) - 1 + 2 * kUnit * (1 + kError) + 4 * kUnit;
  const double bound = weights + (1 + weights) * kUnit / 2 + 0x1p-31;
  EXPECT_NEAR(bounds::fixed_product_bound(18, axis), bound, 1e-12);
  // A third weight below half a unit: its 5 products of two are rounded to 0, and so are the 4 of
  // three that have it as their last.
  for (bounds::AxisPiece& piece : axis) piece.weight[2] = kSmall;
  const double more = (4 * kSmall / 2 + kSmall * kSmall) * (1 + kError) + 4 * kSmall * 0.25;
  EXPECT_NEAR(bounds::fixed_product_bound(18, axis), bound + more * (1 + kUnit / 2), 1e-9);
}

}  // namespace
}  // namespace hwffd::test
