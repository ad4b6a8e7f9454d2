// The B-spline from powers: what its four weights promise, at every coordinate where words are
// short, and how large its error is beside that of four polynomials.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <vector>

#include "hwffd/bounds/axis_error.hpp"
#include "hwffd/model/org_powers.hpp"
#include "hwffd/oracle/oracle.hpp"
#include "named.hpp"
#include "random_vertex.hpp"

namespace hwffd {
namespace {

template <int W>
using Powers = model::PowersBspline<Fixed<W>>;

/// Coordinates in units: all of them, or of long words some.
template <int W>
std::vector<std::int64_t> coordinates() {
  constexpr std::int64_t kOne = std::int64_t{1} << (W - 2);
  const std::int64_t apart = std::max<std::int64_t>(1, kOne / 70001);
  std::vector<std::int64_t> result{kOne};
  for (std::int64_t k = 0; k < kOne; k += apart) result.push_back(k);
  return result;
}

std::int64_t sum(const std::array<std::int64_t, 4>& values) {
  return values[0] + values[1] + values[2] + values[3];
}

template <class Weights>
std::array<std::int64_t, 4> values(const Weights& weights) {
  return {weights[0].value, weights[1].value, weights[2].value, weights[3].value};
}

/// Weights of a cell at 1 are those of the next at 0, one function further.
void expect_seam(const std::array<std::int64_t, 4>& at_one,
                 const std::array<std::int64_t, 4>& at_zero) {
  EXPECT_EQ(at_one[0], 0);
  EXPECT_EQ(at_zero[3], 0);
  for (int l = 0; l < 3; ++l) EXPECT_EQ(at_one[l + 1], at_zero[l]) << "function " << l;
}

template <int W>
void expect_promises() {
  SCOPED_TRACE(W);
  constexpr std::int64_t kOne = std::int64_t{1} << (W - 2);
  double largest = 0;
  double largest_slope = 0;
  for (const std::int64_t k : coordinates<W>()) {
    const auto weights = values(Powers<W>::weights({k, false}));
    const auto slopes = values(Powers<W>::slopes({k, false}));
    ASSERT_EQ(sum(weights), kOne) << k;
    ASSERT_EQ(sum(slopes), 0) << k;
    ASSERT_GE(*std::min_element(weights.begin(), weights.end()), 0) << k;
    const double x = std::ldexp(static_cast<double>(k), 2 - W);
    for (int l = 0; l < 4; ++l) {
      const double unit = static_cast<double>(kOne);
      largest = std::max(largest, std::abs(weights[l] - bounds::bspline(x)[l] * unit));
      largest_slope =
          std::max(largest_slope, std::abs(slopes[l] - bounds::bspline_slope(x)[l] / 2 * unit));
    }
  }
  std::printf("fx%d: %.2f units, derivatives %.2f\n", W, largest, largest_slope);
  EXPECT_LE(largest, 1.75);
  EXPECT_LE(largest_slope, 1.6);
  EXPECT_GE(largest, 1);
  expect_seam(values(Powers<W>::weights({kOne, false})), values(Powers<W>::weights({0, false})));
  expect_seam(values(Powers<W>::slopes({kOne, false})), values(Powers<W>::slopes({0, false})));
}

TEST(Powers, WeightsSumToOneMeetAtSeamsAndAreNotNegative) {
  expect_promises<8>();
  expect_promises<9>();
  expect_promises<12>();
  expect_promises<16>();
  expect_promises<17>();
  expect_promises<18>();
  expect_promises<24>();
  expect_promises<31>();
  expect_promises<32>();
}

TEST(Powers, AFlaggedCoordinateFlagsAllWeights) {
  for (const auto& weight : Powers<18>::weights({0, true})) EXPECT_TRUE(weight.saturated);
  for (const auto& weight : Powers<18>::slopes({0, true})) EXPECT_TRUE(weight.saturated);
  for (const auto& weight : Powers<18>::weights({0, false})) EXPECT_FALSE(weight.saturated);
}

/// A row with polynomials, and the same from powers.
struct Pair {
  const char* name;
  const char* row;
  const char* powers;
};
void PrintTo(const Pair& pair, std::ostream* out) { *out << pair.name; }

class PowersAndPolynomials : public ::testing::TestWithParam<Pair> {};

TEST_P(PowersAndPolynomials, ErrorIsNoLarger) {
  const Oracle oracle;
  std::array<double, 2> errors{};
  const std::array<const char*, 2> names{GetParam().row, GetParam().powers};
  for (int i = 0; i < 2; ++i) {
    const Configuration& row = find_configuration(names[i]);
    const WordCodec codec(row.format);
    const auto model = model::make_evaluator_model(row);
    load(*model, encode(watertight_bspline(codec), codec));
    errors[i] = largest_error(*model, codec, oracle, 1, 100000);
  }
  std::printf("polynomials %.3g, powers %.3g\n", errors[0], errors[1]);
  EXPECT_LE(errors[1], errors[0]);
}

INSTANTIATE_TEST_SUITE_P(
    , PowersAndPolynomials,
    ::testing::Values(Pair{"fx17", "affine-fx17-overlapped", "affine-fx17-overlapped-powers"},
                      Pair{"fx18", "factored-fx18-overlapped", "factored-fx18-overlapped-powers"},
                      Pair{"fx32", "affine3-fx32-overlapped", "affine3-fx32-overlapped-powers"}),
    test::by_name);

}  // namespace
}  // namespace hwffd
