// The proved bounds of the word-length study against what the models do.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "hwffd/bounds/axis_error.hpp"
#include "hwffd/bounds/bound.hpp"
#include "hwffd/model/org_factored.hpp"
#include "hwffd/model/org_powers.hpp"
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
