// The proved bounds of the word-length study against what the models do.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "hwffd/bounds/axis_error.hpp"
#include "hwffd/bounds/bound.hpp"
#include "hwffd/model/org_factored.hpp"
#include "hwffd/model/org_powers.hpp"
#include "hwffd/oracle/oracle.hpp"
#include "named.hpp"
#include "report.hpp"
#include "study.hpp"

namespace hwffd::words {
namespace {

/// docs/numerics.md section 7: how many times its measured error a bound may be.
struct Case {
  const char* name;
  double factor;
};
void PrintTo(const Case& tried, std::ostream* out) { *out << tried.name; }

class WordBound : public ::testing::TestWithParam<Case> {};

TEST_P(WordBound, HoldsAndSaysSomething) {
  Rows rows = all_rows();
  rows.erase(std::remove_if(rows.begin(), rows.end(),
                            [](const auto& row) { return row->format() != GetParam().name; }),
             rows.end());
  ASSERT_EQ(rows.size(), 1U);
  const Result result = study(rows, 100000, 1, [](double) {}).front();
  std::printf("%d vertices, largest error %.3g, bound %.3g, %.1f times\n", 100000, result.max_error,
              result.bound, result.bound / result.max_error);
  EXPECT_EQ(result.vertices, 100000);
  EXPECT_LE(result.max_error, result.bound);
  EXPECT_LE(result.bound, GetParam().factor * result.max_error);
  EXPECT_LT(result.rms_error, result.max_error);
}

INSTANTIATE_TEST_SUITE_P(, WordBound,
                         ::testing::Values(Case{"fx12", 8}, Case{"fx16", 8}, Case{"fx18", 8},
                                           Case{"fx24", 8}, Case{"fx32", 8.5},
                                           Case{"fp32-sequential", 16}, Case{"fp32-tree", 16}),
                         test::by_name);

/// What is propagated must cover what looking at every coordinate finds, and not by far.
void expect_covered(const bounds::AxisError& all, const bounds::AxisError& propagated) {
  for (int i = 0; i < bounds::kPieces; ++i) {
    EXPECT_LE(all[i].error, propagated[i].error) << "piece " << i;
    EXPECT_GE(3 * all[i].error, propagated[i].error) << "piece " << i;
    for (int l = 0; l < 4; ++l) EXPECT_LE(all[i].weight[l], propagated[i].weight[l] + 1e-15);
  }
}

TEST(WordAxis, PropagatedErrorCoversTheExhaustiveOne) {
  expect_covered(bounds::exhaustive_axis_error<16>(), bounds::propagated_axis_error(16));
}

TEST(WordAxis, PropagatedErrorOfPowersCoversTheExhaustiveOne) {
  expect_covered(bounds::exhaustive_powers_error<16>(), bounds::propagated_powers_error(16));
  expect_covered(bounds::exhaustive_powers_error<17>(), bounds::propagated_powers_error(17));
}

// The functions that the proof stands on are those of the oracle, and each other's derivatives.
TEST(WordAxis, BlendingFunctionsAndSlopes) {
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

/// The largest error of `factored` in `fxW` over samples, whatever its evaluator.
template <int W, template <class> class Organization>
double factored_error(int vertices) {
  const std::string format = "fx" + std::to_string(W);
  const WordCodec codec(format);
  const auto bank = bounds::bspline_bank<Fixed<W>>(format.c_str());
  const Configuration configuration{};
  const Organization<Fixed<W>> factored(configuration);
  double largest = 0;
  for (const Sample& sample : Samples().draw(1, vertices)) {
    model::LocalVertex<Fixed<W>> vertex;
    model::Support<Fixed<W>> support;
    for (int a = 0; a < 3; ++a) vertex.local[a] = Fixed<W>::coordinate(sample.fixed.local[a]);
    for (int i = 0; i < 192; ++i) {
      support[i / 3][i % 3] = Fixed<W>::point(sample.fixed.points[i]);
    }
    const auto sum = factored.evaluate(vertex, support, bank);
    for (int c = 0; c < 3; ++c) {
      const double result = codec.decode_point(Fixed<W>::out(sum[c]).word);
      largest = std::max(largest, std::abs(result - sample.exact[c]));
    }
  }
  return largest;
}

template <int W, template <class> class Organization = model::OrgFactored>
void expect_factored_bound(const bounds::AxisError& axis, double factor) {
  const double largest = factored_error<W, Organization>(50000);
  const double bound = bounds::fixed_factored_bound(W, axis);
  std::printf("fx%d: largest %.3g, bound %.3g\n", W, largest, bound);
  EXPECT_LE(largest, bound);
  EXPECT_LE(bound, factor * largest);
}

// At 32 bits the errors of an axis are propagated, which doubles the bound.
TEST(WordBoundFactored, HoldsAndSaysSomething) {
  expect_factored_bound<12>(bounds::exhaustive_axis_error<12>(), 8);
  expect_factored_bound<18>(bounds::exhaustive_axis_error<18>(), 8);
  expect_factored_bound<32>(bounds::propagated_axis_error(32), 12);
}

TEST(WordBoundFactored, HoldsAndSaysSomethingOfPowers) {
  expect_factored_bound<12, model::OrgPowers>(bounds::exhaustive_powers_error<12>(), 8);
  expect_factored_bound<17, model::OrgPowers>(bounds::exhaustive_powers_error<17>(), 8);
  expect_factored_bound<18, model::OrgPowers>(bounds::exhaustive_powers_error<18>(), 8);
  expect_factored_bound<32, model::OrgPowers>(bounds::propagated_powers_error(32), 12);
}

// Signs of the points that go with the signs of the weights' errors, all 64: no bound may be less.
TEST(WordBoundWorst, AlignedErrorsOfFx18StayWithinIt) {
  const auto bank = bounds::bspline_bank<Fixed<18>>("fx18");
  const Samples samples;
  double largest = 0;
  for (const Sample& sample : samples.draw(7, 20000)) {
    model::LocalVertex<Fixed<18>> vertex;
    std::array<std::array<double, 4>, 3> exact;
    for (int a = 0; a < 3; ++a) {
      vertex.local[a] = Fixed<18>::coordinate(sample.fixed.local[a]);
      exact[a] = bounds::bspline(std::ldexp(sample.fixed.local[a], -31));
    }
    const auto factors = model::factors_of<Fixed<18>>(vertex, {}, bank);
    double sum = 0;
    for (int i = 0; i < 64; ++i) {
      sum += std::abs(std::ldexp(static_cast<double>(factors[i].weight.value), -16) -
                      exact[0][i >> 4] * exact[1][(i >> 2) & 3] * exact[2][i & 3]);
    }
    largest = std::max(largest, sum);
  }
  const double bound = bounds::fixed_product_bound(18, bounds::exhaustive_axis_error<18>());
  std::printf("fx18, aligned: largest %.3g, bound %.3g\n", largest, bound);
  EXPECT_LE(largest, bound);
  EXPECT_GE(3 * largest, bound);
}

// The bound worked out by hand: where two weights of an axis are 1/2 and two are 0, 4 products of
// two weights and 8 of three are rounded.
TEST(WordBoundWorst, HandValue) {
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

// The same vertices whatever else is measured: the study is repeatable.
TEST(WordStudy, IsRepeatable) {
  Rows rows = all_rows();
  const std::size_t all = rows.size();
  EXPECT_EQ(all, 25U);
  rows.erase(rows.begin() + 1, rows.end());
  const Result a = study(rows, 5000, 3, [](double) {}).front();
  const Result b = study(rows, 5000, 3, [](double) {}).front();
  EXPECT_EQ(a.max_error, b.max_error);
  EXPECT_EQ(a.rms_error, b.rms_error);
  EXPECT_NE(a.rms_error, study(rows, 5000, 4, [](double) {}).front().rms_error);
}

TEST(WordReport, HasTheWordLength) {
  const std::string json = json_report({{"product", "fx28", 28, true, 1e-7, 1e-8, 1e-6, 10}});
  EXPECT_NE(json.find("\"word_length\": 28"), std::string::npos) << json;
}

}  // namespace
}  // namespace hwffd::words
