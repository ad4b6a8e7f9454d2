// Functions of spans from knots: against de Boor's algorithm, at their seams in every format, and
// what is refused.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <limits>

#include "de_boor.hpp"
#include "errors.hpp"
#include "hwffd/error.hpp"
#include "hwffd/stream/formats.hpp"
#include "hwffd/stream/spans.hpp"
#include "random_vertex.hpp"

namespace hwffd {
namespace {

constexpr int kVectors = 200;

/// Random knots with some that come up to so often; clamped ends, or ends that are not.
std::vector<double> random_knots(std::mt19937_64& random, int most) {
  std::vector<double> knots;
  double at = 16 * unit(random) - 8;
  const bool clamped = random() % 2 == 0;
  const int distinct = static_cast<int>(2 + random() % 7) + (clamped ? 0 : 6);
  for (int i = 0; i < distinct; ++i) {
    const bool end = clamped && (i == 0 || i == distinct - 1);
    const int times = end ? 4 : random() % 3 == 0 ? 1 + static_cast<int>(random() % most) : 1;
    knots.insert(knots.end(), times, at);
    at += random() % 4 == 0 ? std::ldexp(unit(random) + 0.5, -4) : 1 + unit(random);
  }
  return knots;
}

std::vector<double> random_points(std::mt19937_64& random, std::size_t count) {
  std::vector<double> points(count);
  for (double& point : points) point = 2 * unit(random) - 1;
  return points;
}

bool is_empty(const std::vector<double>& knots, std::size_t cell) {
  return knots[cell + 3] == knots[cell + 4];
}

/// Sum and derivative along x of a cell, in extended precision.
DeBoor::Jet by_span(const Blending& span, const double* points, long double x) {
  DeBoor::Jet jet{0, 0};
  for (std::size_t l = 0; l < 4; ++l) {
    const auto& c = span.coefficient[l];
    const auto& d = span.derivative[l];
    jet.value += points[l] * (c[0] + x * (c[1] + x * (c[2] + x * (long double){c[3]})));
    jet.slope += points[l] * (d[0] + x * (d[1] + x * (long double){d[2]}));
  }
  return jet;
}

// Coefficients are rounded to double once: at most 6 each, so 2^-51 each, four of them, four points
// of at most 1. A derivative's are at most 18.
constexpr double kValueBound = 16 * 0x1p-51;
constexpr double kSlopeBound = 12 * 0x1p-49;

TEST(Spans, AreThoseOfDeBoor) {
  std::mt19937_64 random(1);
  double value = 0;
  double slope = 0;
  int cells = 0;
  int empty = 0;
  for (int n = 0; n < 10 * kVectors; ++n) {
    const std::vector<double> knots = random_knots(random, 4);
    if (knots.size() < 8 || !(knots[knots.size() - 4] > knots[3])) continue;
    const std::vector<double> points = random_points(random, knots.size() - 4);
    const std::vector<Blending> spans = knot_spans(knots);
    ASSERT_EQ(spans.size(), knots.size() - 7);
    const DeBoor spline(knots, points);
    for (std::size_t i = 0; i < spans.size(); ++i) {
      if (is_empty(knots, i)) {
        ++empty;
        continue;
      }
      ++cells;
      const long double length = (long double){knots[i + 4]} - knots[i + 3];
      for (const double x : {0.0, 1.0, unit(random), unit(random)}) {
        const DeBoor::Jet expected = spline.at(i + 3, knots[i + 3] + x * length);
        const DeBoor::Jet got = by_span(spans[i], &points[i], x);
        value = std::max(value, static_cast<double>(std::abs(got.value - expected.value)));
        slope = std::max(slope, static_cast<double>(std::abs(got.slope - expected.slope * length)));
      }
    }
  }
  std::printf("%d cells, %d empty: %.3g and %.3g at most\n", cells, empty, value, slope);
  EXPECT_GE(cells, 5000);
  EXPECT_GE(empty, 500);
  EXPECT_LE(value, kValueBound);
  EXPECT_LE(slope, kSlopeBound);
}

// A cell without length has the weights of its knot: a vertex there gets the point of the spline.
TEST(Spans, EmptyCellsHaveTheirKnotsPoint) {
  std::mt19937_64 random(2);
  int empty = 0;
  for (int n = 0; n < kVectors; ++n) {
    const std::vector<double> knots = random_knots(random, 3);
    if (knots.size() < 8 || !(knots[knots.size() - 4] > knots[3])) continue;
    const std::vector<double> points = random_points(random, knots.size() - 4);
    const std::vector<Blending> spans = knot_spans(knots);
    const DeBoor spline(knots, points);
    for (std::size_t i = 0; i < spans.size(); ++i) {
      if (!is_empty(knots, i)) continue;
      std::size_t near = i;
      while (near < spans.size() && is_empty(knots, near)) ++near;
      while (near == spans.size() || is_empty(knots, near)) --near;
      const auto expected = spline.at(near + 3, knots[i + 3]).value;
      EXPECT_NEAR(static_cast<double>(by_span(spans[i], &points[i], unit(random)).value),
                  static_cast<double>(expected), kValueBound);
      ++empty;
    }
  }
  EXPECT_GE(empty, 50);
}

TEST(Spans, UniformKnotsGiveTheBspline) {
  for (const Format& format : kFormats) {
    const WordCodec codec(format.name);
    const Blending expected = watertight_bspline(codec);
    for (const Blending& span : watertight_spans(uniform_knots(5), codec)) {
      EXPECT_EQ(span.coefficient, expected.coefficient) << format.name;
      EXPECT_EQ(span.derivative, expected.derivative) << format.name;
    }
  }
}

// Of a clamped axis at even distances two cells a side are not the uniform B-spline: no more need
// be sent.
TEST(Spans, ClampedEndsAreTwoCellsASide) {
  constexpr std::size_t kCells = 9;
  for (const Format& format : kFormats) {
    const WordCodec codec(format.name);
    const auto spans = watertight_spans(clamped_knots(kCells), codec);
    ASSERT_EQ(spans.size(), kCells);
    int differ = 0;
    for (std::size_t i = 0; i < kCells; ++i) {
      const bool differs = spans[i].coefficient != watertight_bspline(codec).coefficient;
      EXPECT_EQ(differs, i < 2 || i >= kCells - 2) << format.name << " " << i;
      differ += differs ? 1 : 0;
    }
    EXPECT_EQ(differ, 4);
    const std::vector<AxisWords> words = encode(spans, codec);
    std::size_t beats = 13;
    for (std::size_t first : {std::size_t{0}, kCells - 2}) {
      const bool equal_shifts = words[first].shift == words[first + 1].shift;
      beats += 3 * (equal_shifts ? 1 + 8 : 2 * (1 + 4));
    }
    EXPECT_EQ(all_spans_packets({words, words, words}).size(), beats) << format.name;
  }
}

TEST(Spans, ClampedEndsAreTheEndPoints) {
  for (const Format& format : kFormats) {
    const WordCodec codec(format.name);
    for (const int cells : {1, 2, 3, 4, 13}) {
      const auto words = encode(watertight_spans(clamped_knots(cells), codec), codec);
      const auto begin = weights(words.front(), format.name, codec.coordinate(0.0));
      const auto end = weights(words.back(), format.name, codec.coordinate(1.0));
      for (std::size_t l = 0; l < 4; ++l) {
        EXPECT_EQ(begin[l], l == 0 ? 1.0 : 0.0) << format.name << " " << cells;
        EXPECT_EQ(end[l], l == 3 ? 1.0 : 0.0) << format.name << " " << cells;
      }
    }
  }
}

/// SpanSeams between cells that have length.
struct SpanSeams {
  int compared = 0;
  int cracked = 0;
  int sum_is_one = 0;
};

void count_seams(const std::vector<double>& knots, const std::vector<Blending>& spans,
                 const std::string& format, bool fused, SpanSeams& seams) {
  const WordCodec codec(format);
  const std::vector<AxisWords> words = encode(spans, codec);
  for (std::size_t lower = 0; lower + 1 < spans.size(); ++lower) {
    if (is_empty(knots, lower)) continue;
    std::size_t upper = lower + 1;
    while (upper < spans.size() && is_empty(knots, upper)) ++upper;
    if (upper == spans.size()) break;
    if (upper - lower > 3) continue;  // the spline itself breaks there
    ++seams.compared;
    const int stride = static_cast<int>(upper - lower);
    if (!is_watertight(words[lower], words[upper], format, stride, fused)) ++seams.cracked;
    const auto at = weights(words[upper], format, codec.coordinate(0.0), fused);
    if (at[0] + at[1] + at[2] + at[3] == 1) ++seams.sum_is_one;
  }
}

TEST(Spans, SeamsAreWatertightInEveryFormat) {
  SpanSeams all;
  for (const Format& format : kFormats) {
    for (const bool fused : {false, true}) {
      if (fused && format.words != Words::kFloat) continue;
      std::mt19937_64 random(3);
      SpanSeams seams;
      SpanSeams plain;
      for (int n = 0; n < kVectors; ++n) {
        const std::vector<double> knots = n < 10 ? clamped_knots(n + 1) : random_knots(random, 4);
        if (knots.size() < 8 || !(knots[knots.size() - 4] > knots[3])) continue;
        const WordCodec codec(format.name);
        count_seams(knots, watertight_spans(knots, codec), format.name, fused, seams);
        count_seams(knots, knot_spans(knots), format.name, fused, plain);
      }
      EXPECT_GE(seams.compared, 500) << format.name;
      EXPECT_EQ(seams.cracked, 0) << format.name;
      EXPECT_EQ(seams.sum_is_one, seams.compared) << format.name;
      EXPECT_GT(plain.cracked, plain.compared / 4) << format.name;
      std::printf("%s%s: %d of %d seams crack, %d with coefficients rounded each by itself\n",
                  format.name, fused ? " fused" : "", seams.cracked, seams.compared, plain.cracked);
      all.compared += seams.compared;
    }
  }
  EXPECT_GE(all.compared, 24 * 500);
}

// Rounded together, a coefficient is off by a few units of its cell, which are up to four of those
// of a weight, or of 2^-24: in fixed point k is at most 2, and no coefficient is above 6.
TEST(Spans, RoundedCoefficientsAreNear) {
  double largest = 0;
  for (const Format& format : kFormats) {
    const WordCodec codec(format.name);
    std::mt19937_64 random(4);
    for (int n = 0; n < kVectors; ++n) {
      const std::vector<double> knots = random_knots(random, 4);
      if (knots.size() < 8 || !(knots[knots.size() - 4] > knots[3])) continue;
      const auto exact = knot_spans(knots);
      const auto rounded = watertight_spans(knots, codec);
      const double unit =
          std::ldexp(1.0, codec.has_fixed_weights() ? -codec.weight_fraction() : -24);
      for (std::size_t i = 0; i < exact.size(); ++i) {
        for (std::size_t l = 0; l < 4; ++l) {
          for (std::size_t p = 0; p < 4; ++p) {
            const double off = exact[i].coefficient[l][p] - rounded[i].coefficient[l][p];
            largest = std::max(largest, std::abs(off) / unit);
          }
        }
      }
    }
  }
  std::printf("%.3g units at most\n", largest);
  EXPECT_LE(largest, 16);
  EXPECT_GE(largest, 4);
}

TEST(Spans, BadKnotsAreRefused) {
  constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  const struct {
    std::vector<double> knots;
    const char* message;
  } kCases[] = {
      {{}, "0 knots: a cubic axis wants 8 or more, 4 more than points"},
      {{0, 1, 2, 3, 4, 5, 6}, "7 knots: a cubic axis wants 8 or more, 4 more than points"},
      {{0, 1, 2, 3, 2, 5, 6, 7}, "knot 4 is 2 after 3: knots must not decrease"},
      {{0, 1, 2, 3, 4, 5, 6, kNan}, "knot 7 is nan: finite numbers are wanted"},
      {{-kInfinity, 1, 2, 3, 4, 5, 6, 7}, "knot 0 is -inf: finite numbers are wanted"},
      {{0, 1, 1, 1, 1, 1, 6, 7, 8, 9}, "knot 1 comes 5 times: 4 times at most"},
      {{0, 1, 2, 3, 3, 5, 6, 7}, "no cell between knots that are all 3"},
  };
  for (const auto& bad : kCases) {
    for (const bool rounded : {false, true}) {
      try {
        if (rounded) {
          watertight_spans(bad.knots, WordCodec("fx18"));
        } else {
          knot_spans(bad.knots);
        }
        ADD_FAILURE() << bad.message;
      } catch (const UsageError& error) {
        EXPECT_STREQ(error.what(), bad.message);
      }
    }
  }
  EXPECT_THROW(clamped_knots(0), UsageError);
  EXPECT_THROW(uniform_knots(-1), UsageError);
  EXPECT_THROW(spans_packets(0, 255, std::vector<AxisWords>(2)), std::invalid_argument);
  EXPECT_THROW(spans_packets(3, 0, std::vector<AxisWords>(1)), std::invalid_argument);
  EXPECT_THROW(spans_packets(0, 0, {}), std::invalid_argument);
}

}  // namespace
}  // namespace hwffd
