// The transpose of `affine`: what a vertex adds, and that sums do not depend on who adds when.
// docs/numerics.md section 11.
#include "hwffd/model/scatter.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <numeric>
#include <random>
#include <string>
#include <vector>

#include "hwffd/model/org_affine.hpp"
#include "hwffd/model/organizations.hpp"
#include "hwffd/oracle/oracle.hpp"
#include "hwffd/stream/blending.hpp"
#include "scatter_vertices.hpp"
#include "share.hpp"
#include "uniform.hpp"

namespace hwffd {
namespace {

using model::GradientWords;
using model::ScatterModel;
using model::ScatterPage;
using model::VertexParts;
using test::share_of;
using namespace scatter;

/// The largest magnitudes that section 11 takes for granted of weights, all four banks.
template <int W>
void check_weights(const std::string& name, bool powers) {
  using F = Fixed<W>;
  const WordCodec codec(format_of(W));
  const auto bank = bank_of<F>(words_of(name, codec));
  constexpr std::int64_t kOne = std::int64_t{1} << F::kWeightFraction;
  const auto stride = static_cast<std::int64_t>(4 / share_of(4));
  std::int64_t largest = 0;
  std::int64_t largest_cumulative = 0;
  for (const int derivative : {kPosition, 0}) {
    for (int cell = 0; cell < 4; ++cell) {
      for (std::int64_t s = 0; s <= kOne; s += stride) {
        const model::LocalVertex<F> vertex{
            {{{s, false}, {0, false}, {0, false}}}, {cell, 0, 0}, derivative};
        std::int64_t below = 0;
        const auto cumulative = model::cumulative_of<F>(vertex, bank, powers);
        for (const auto& sum : cumulative[0]) {
          ASSERT_FALSE(sum.saturated) << name << " at " << s;
          largest = std::max(largest, std::abs(sum.value - below));
          largest_cumulative = std::max(largest_cumulative, std::abs(sum.value));
          below = sum.value;
        }
        const std::int64_t whole = derivative == kPosition ? kOne : 0;
        largest = std::max(largest, std::abs(whole - below));
      }
    }
  }
  EXPECT_LE(largest, kOne + kOne / 64) << name << ", " << W << " bits";
  EXPECT_LE(largest_cumulative, kOne + kOne / 2) << name << ", " << W << " bits";
  EXPECT_GE(largest, kOne / 2) << name << ", " << W << " bits";
}

template <int W>
void check_families() {
  for (const std::string& name : families()) check_weights<W>(name, false);
  check_weights<W>("bspline", true);
}

TEST(ScatterWeights, AreSmallEnoughThatNothingSaturates) {
  check_families<12>();
  check_families<13>();
  check_families<14>();
  check_families<15>();
  check_families<16>();
  check_families<17>();
  check_families<18>();
}

// Conservation: to the bit, whatever the gradient, and nothing saturates.
TEST(Scatter, WhatAVertexAddsSumsToItsGradient) {
  std::mt19937_64 engine(1);
  const std::uint64_t vertices = share_of(20'000);
  const auto check = [&](const ScatterModel& scatter, const std::string& name) {
    for (std::uint64_t v = 0; v < vertices; ++v) {
      GradientWords vertex = random_gradient(engine);
      vertex.derivative = static_cast<int>(v % 4) - 1;
      const VertexParts added = scatter.parts(vertex);
      ASSERT_EQ(added.saturated, vertex.gradient[0] == 0x7FFFFFFF ||
                                     vertex.gradient[1] == 0x7FFFFFFF ||
                                     vertex.gradient[2] == 0x7FFFFFFF)
          << name << ", vertex " << v;
      for (int c = 0; c < 3; ++c) {
        std::int64_t sum = 0;
        for (const auto& part : added.parts) sum += part[c];
        const std::int64_t gradient = Fx::point(vertex.gradient[c]).value;
        ASSERT_EQ(sum, vertex.derivative == kPosition ? gradient : 0) << name << ", vertex " << v;
      }
    }
  };
  for (const std::string& name : families()) check(*scatter_of(name), name);
  check(*scatter_of("bspline", "affine-fx17-overlapped-powers"), "powers");
}

// A gradient of -1 along one component: minus the products of three weights, within what three
// expansions round, and nothing of the other components.
TEST(Scatter, UnitImpulsesGiveTheWeights) {
  std::mt19937_64 engine(2);
  for (const std::string& name : families()) {
    const auto scatter = scatter_of(name);
    const auto bank = bank_of<Fx>(words_of(name, WordCodec("fx17")));
    for (std::uint64_t v = 0; v < share_of(8'000); ++v) {
      GradientWords vertex = random_gradient(engine);
      const int component = static_cast<int>(v % 3);
      vertex.gradient = {};
      vertex.gradient[component] = 0x80000000;
      vertex.derivative = static_cast<int>(v / 3 % 4) - 1;
      model::LocalVertex<Fx> local{{}, vertex.cell, vertex.derivative};
      for (int axis = 0; axis < 3; ++axis) local.local[axis] = Fx::coordinate(vertex.local[axis]);
      auto weight = model::weights_of<Fx>(local, bank);
      const VertexParts added = scatter->parts(vertex);
      for (int axis = 0; axis < 3; ++axis) {
        const std::int64_t whole = axis == vertex.derivative ? 0 : 1 << Fx::kWeightFraction;
        auto& w = weight[axis];
        w[3].value = whole - w[0].value - w[1].value - w[2].value;
      }
      for (int p = 0; p < 64; ++p) {
        double exact = -1;
        const std::array<int, 3> at = {p / 16, p / 4 % 4, p % 4};
        for (int axis = 0; axis < 3; ++axis) {
          const int of_bank = (at[axis] + vertex.cell[axis]) % 4;
          exact *= std::ldexp(static_cast<double>(weight[axis][of_bank].value), 2 - kWidth);
        }
        for (int c = 0; c < 3; ++c) {
          const auto part = static_cast<double>(added.parts[p][c]);
          const double wanted = c == component ? std::ldexp(exact, kWidth - 1) : 0;
          ASSERT_LE(std::abs(part - wanted), c == component ? 3.1 : 0.0)
              << name << ", vertex " << v << ", point " << p;
        }
      }
    }
  }
}

// Against double: the sum of the errors of 64 points, in units of a part. The limits are set over
// what was measured.
TEST(Scatter, IsNearTheOracle) {
  std::mt19937_64 engine(3);
  for (const auto& [name, limit] : {std::pair<std::string, double>{"bspline", 35},
                                    {"bernstein", 100},
                                    {"catmull-rom", 70},
                                    {"linear", 10}}) {
    const auto scatter = scatter_of(name);
    const AxisWords words = words_of(name, WordCodec("fx17"));
    const Oracle oracle(Oracle::family(name));
    double largest = 0;
    for (std::uint64_t v = 0; v < share_of(20'000); ++v) {
      GradientWords vertex = random_gradient(engine);
      vertex.derivative = static_cast<int>(v % 4) - 1;
      const VertexParts added = scatter->parts(vertex);
      const double scale =
          vertex.derivative == kPosition ? 1 : std::ldexp(1, -words.derivative.exponent);
      const Support exact =
          scale * oracle.pull_back(gradient_of(vertex), local_of(vertex), vertex.derivative);
      for (int c = 0; c < 3; ++c) {
        double error = 0;
        for (int p = 0; p < 64; ++p) {
          error += std::abs(static_cast<double>(added.parts[p][c]) -
                            std::ldexp(exact(p, c), kWidth - 1));
        }
        largest = std::max(largest, error);
      }
    }
    std::printf("%s: %.3g units, limit %.3g\n", name.c_str(), largest, limit);
    EXPECT_LE(largest, limit) << name;
    EXPECT_GE(2 * largest, limit) << name << ": the limit says nothing";
  }
}

TEST(ScatterOracle, PullBackIsTheTransposeOfEvaluationAndOfDerivatives) {
  std::mt19937_64 engine(4);
  const Oracle oracle(Oracle::catmull_rom(), Oracle::uniform_bspline(), Oracle::hermite());
  for (int v = 0; v < 1000; ++v) {
    const Eigen::Vector3d local(unit(engine), unit(engine), unit(engine));
    const Eigen::Vector3d gradient(unit(engine), unit(engine) - 1, unit(engine));
    Support points;
    for (int p = 0; p < 192; ++p) points(p / 3, p % 3) = 2 * unit(engine) - 1;
    const Oracle::Jet jet = oracle.jet(points, local);
    for (int derivative = kPosition; derivative < 3; ++derivative) {
      const Eigen::Vector3d forward =
          derivative == kPosition ? jet.value : Eigen::Vector3d(jet.jacobian.col(derivative));
      const Support back = oracle.pull_back(gradient, local, derivative);
      EXPECT_NEAR(forward.dot(gradient), points.cwiseProduct(back).sum(), 1e-12);
    }
  }
}

/// Both sides of <A p, g> = <p, A^T g> for one component: 64 points by bank and a gradient.
struct Adjoint {
  explicit Adjoint(std::mt19937_64& engine, const std::string& name)
      : bank(bank_of<Fx>(words_of(name, WordCodec("fx17")))) {
    const GradientWords vertex = random_gradient(engine);
    local.cell = vertex.cell;
    local.derivative = static_cast<int>(engine() % 4) - 1;
    for (int axis = 0; axis < 3; ++axis) local.local[axis] = Fx::coordinate(vertex.local[axis]);
    gradient = Fx::point(vertex.gradient[0]).value;
    // Small enough that nothing saturates in affine.
    for (auto& point : support) {
      point = {};
      const auto bits = static_cast<std::int32_t>(engine() >> 32);
      point[0] = Fx::point(static_cast<std::uint32_t>(bits / 2));
    }
    weight = model::weights_of<Fx>(local, bank);
    for (int axis = 0; axis < 3; ++axis) {
      auto& w = weight[axis];
      const std::int64_t whole = axis == local.derivative ? 0 : 1 << Fx::kWeightFraction;
      w[3].value = whole - w[0].value - w[1].value - w[2].value;
      for (const auto& one : w) length[axis] += std::ldexp(std::abs(one.value), 2 - kWidth);
    }
    points = model::by_bank<Fx>(support, local.cell);
  }

  /// The sum of points times parts.
  template <class Parts>
  Int128 back() const {
    typename Parts::Part whole{};
    if constexpr (std::is_same_v<Parts, model::ExactParts<Fx>>) {
      whole = gradient;
    } else {
      whole.value = gradient;
    }
    const auto parts = model::scattered<Parts>(model::cumulative_of<Fx>(local, bank, false), whole,
                                               local.derivative);
    Int128 sum = 0;
    for (int p = 0; p < 64; ++p) {
      if constexpr (std::is_same_v<Parts, model::ExactParts<Fx>>) {
        sum += points[p][0].value * parts[p];
      } else {
        EXPECT_FALSE(parts[p].saturated);
        sum += Int128{points[p][0].value} * parts[p].value;
      }
    }
    return sum;
  }

  /// Eq. (1) without narrowing, u first, then t, then s.
  Int128 exact_position() const {
    std::array<Int128, 64> sums{};
    for (int p = 0; p < 64; ++p) sums[p] = points[p][0].value;
    for (int axis = 2; axis >= 0; --axis) {
      for (int i = 0; i < 1 << (2 * axis); ++i) {
        Int128 sum = 0;
        for (int b = 0; b < 4; ++b) sum += weight[axis][b].value * sums[4 * i + b];
        sums[i] = sum;
      }
    }
    return sums[0];
  }

  model::CoefficientBank<Fx> bank;
  model::LocalVertex<Fx> local;
  model::Support<Fx> support{};
  model::Support<Fx> points{};
  model::AxisWeights<Fx> weight{};
  std::array<double, 3> length{};  // of the sum of magnitudes of an axis's weights
  std::int64_t gradient = 0;
};

TEST(ScatterAdjoint, IsExactWithoutNarrowing) {
  std::mt19937_64 engine(5);
  for (const std::string& name : families()) {
    for (std::uint64_t v = 0; v < share_of(8'000); ++v) {
      const Adjoint both(engine, name);
      ASSERT_TRUE(both.exact_position() * both.gradient == both.back<model::ExactParts<Fx>>())
          << name << ", vertex " << v;
    }
  }
}

TEST(ScatterAdjoint, IsWithinItsBoundWithNarrowing) {
  std::mt19937_64 engine(6);
  double nearest = 0;
  for (const std::string& name : families()) {
    const model::OrgAffine<Fx> affine(find_configuration("affine-fx17-overlapped"));
    for (std::uint64_t v = 0; v < share_of(8'000); ++v) {
      const Adjoint both(engine, name);
      const auto position = affine.evaluate(both.local, both.support, both.bank)[0];
      ASSERT_FALSE(position.saturated);
      double largest = 0;
      for (const auto& point : both.points) {
        largest = std::max(largest, std::ldexp(std::abs(point[0].value), 1 - kWidth));
      }
      const double g = std::ldexp(std::abs(both.gradient), 1 - kWidth);
      const auto& length = both.length;
      const double bound =
          std::ldexp(1, 1 - kWidth) * (g * length[0] * (1 + length[1]) / 2 +
                                       3 * largest * (length[1] * length[2] + 4 * length[2] + 16));
      // In units of the product of a point and a part: a sum has W - 1 digits fewer.
      const auto forward = static_cast<double>(Int128{position.value} * both.gradient);
      const auto back = static_cast<double>(both.back<model::RoundedParts<Fx>>());
      const double difference = std::abs(std::ldexp(forward, -(2 * kWidth - 3) - (kWidth - 1)) -
                                         std::ldexp(back, -2 * (kWidth - 1)));
      ASSERT_LE(difference, bound) << name << ", vertex " << v;
      nearest = std::max(nearest, difference / bound);
    }
  }
  std::printf("at most %.3g of the bound\n", nearest);
  EXPECT_GT(nearest, 0.02) << "the bound says nothing";
}

// The vertex of a face adds the same to the same points from either cell, and nothing to the layer
// that only one of them has.
TEST(Scatter, SeamsAreWatertight) {
  std::mt19937_64 engine(7);
  struct Kind {
    const char* family;
    const char* row;
  };
  for (const Kind& kind :
       {Kind{"bspline", "affine-fx17-overlapped"}, Kind{"bspline", "affine-fx17-overlapped-powers"},
        Kind{"catmull-rom", "affine-fx17-overlapped"}, Kind{"linear", "affine-fx17-overlapped"}}) {
    const auto scatter = scatter_of(kind.family, kind.row);
    for (std::uint64_t v = 0; v < share_of(8'000); ++v) {
      GradientWords below = random_gradient(engine);
      const auto axis = static_cast<std::size_t>(v % 3);
      below.local[axis] = 0x80000000;
      GradientWords above = below;
      above.local[axis] = 0;
      ++above.cell[axis];
      const VertexParts lower = scatter->parts(below);
      const VertexParts upper = scatter->parts(above);
      const int step = 16 >> (2 * axis);
      const std::array<std::int64_t, 3> none{};
      for (int p = 0; p < 64; ++p) {
        const int layer = p / step % 4;
        ASSERT_EQ(lower.parts[p], layer == 0 ? none : upper.parts[p - step]) << kind.row;
        if (layer == 3) {
          ASSERT_EQ(upper.parts[p], none) << kind.row;
        }
      }
    }
  }
}

constexpr std::array<int, 3> kDims = {6, 5, 7};
constexpr std::array<int, 3> kCells = {3, 2, 4};
constexpr std::size_t kPoints = 6 * 5 * 7;

struct Added {
  std::array<int, 3> cell;
  VertexParts parts;
};

std::vector<Added> some_vertices(std::size_t count, std::uint64_t seed) {
  std::mt19937_64 engine(seed);
  const auto scatter = scatter_of("bspline");
  std::vector<Added> vertices;
  for (std::size_t v = 0; v < count; ++v) {
    const GradientWords vertex = random_gradient(engine, kCells);
    vertices.push_back({vertex.cell, scatter->parts(vertex)});
  }
  return vertices;
}

void expect_equal_sums(const ScatterPage& a, const ScatterPage& b) {
  for (std::size_t point = 0; point < kPoints; ++point) {
    for (int c = 0; c < 3; ++c) ASSERT_EQ(a.word(point, c), b.word(point, c)) << "point " << point;
  }
  ASSERT_EQ(a.vertices(), b.vertices());
  ASSERT_EQ(a.saturated(), b.saturated());
}

// Sums that wrap among them: each page begins with one that is nearly full.
TEST(Scatter, AnyOrderAndPartitionGivesTheSameBits) {
  const std::uint64_t permutations = share_of(100'000);
  std::mt19937_64 engine(8);
  const std::vector<Added> vertices = some_vertices(16, 9);
  ScatterPage full(kWidth, kDims);
  for (const Added& vertex : vertices) full.add(vertex.cell, vertex.parts);
  for (int doubling = 0; doubling < 16; ++doubling) full.join(full);
  ScatterPage expected = full;
  for (const Added& vertex : vertices) expected.add(vertex.cell, vertex.parts);
  std::vector<std::size_t> order(vertices.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  for (std::uint64_t permutation = 0; permutation < permutations; ++permutation) {
    for (std::size_t i = order.size() - 1; i > 0; --i) {
      std::swap(order[i], order[engine() % (i + 1)]);
    }
    std::vector<ScatterPage> lanes(1 + engine() % 4, ScatterPage(kWidth, kDims));
    lanes.back() = full;
    for (const std::size_t v : order) {
      lanes[engine() % lanes.size()].add(vertices[v].cell, vertices[v].parts);
    }
    for (std::size_t lane = 1; lane < lanes.size(); ++lane) lanes[0].join(lanes[lane]);
    expect_equal_sums(lanes[0], expected);
    if (HasFatalFailure()) return;
  }
  std::printf("%llu permutations\n", static_cast<unsigned long long>(permutations));
}

// The theorem's extremes: the smallest and the largest part, at each point N times.
TEST(ScatterPage, NoSumOverflowsUpToItsNumberOfVertices) {
  for (int width = model::kScatterLeastWidth; width <= model::kScatterMostWidth; ++width) {
    for (const bool smallest : {false, true}) {
      const std::int64_t part =
          smallest ? -(std::int64_t{1} << width) : (std::int64_t{1} << width) - 1;
      VertexParts parts;
      for (auto& point : parts.parts) point = {part, part, part};
      ScatterPage page(width, {4, 4, 4});
      page.add({0, 0, 0}, parts);
      std::int64_t count = 1;
      for (; count < model::scatter_most_vertices(width); count *= 2) page.join(page);
      ASSERT_EQ(page.vertices(), static_cast<std::uint64_t>(count));
      EXPECT_EQ(page.sum(63, 2), count * part);
      EXPECT_FALSE(page.overflowed());
      ScatterPage more = page;
      more.add({0, 0, 0}, parts);
      EXPECT_TRUE(more.overflowed()) << "told, whether or not a sum did";
      // Of the smallest one more is one too many.
      if (smallest) {
        EXPECT_NE(more.sum(63, 2), (count + 1) * part);
      }
      page.join(page);
      EXPECT_TRUE(page.overflowed());
      EXPECT_NE(page.sum(0, 0), 2 * count * part);
    }
  }
}

// So many that a collect without a shift is exact.
TEST(ScatterPage, SumsOfAPartOfTheVerticesLeaveExactly) {
  VertexParts parts;
  for (auto& point : parts.parts) point = {-(1 << kWidth), (1 << kWidth) - 1, -1};
  ScatterPage page(kWidth, {4, 4, 4});
  page.add({0, 0, 0}, parts);
  std::int64_t count = 1;
  for (; count < model::scatter_exact_vertices(kWidth); count *= 2) page.join(page);
  const auto collected = page.collect(0);
  ASSERT_EQ(collected.size(), 64U);
  for (const model::ResultWords& point : collected) {
    EXPECT_FALSE(point.saturated);
    EXPECT_EQ(static_cast<std::int32_t>(point.words[0]), -count * (1 << kWidth));
    EXPECT_EQ(static_cast<std::int32_t>(point.words[1]), count * ((1 << kWidth) - 1));
    EXPECT_EQ(static_cast<std::int32_t>(point.words[2]), -count);
  }
}

TEST(ScatterPage, CollectRoundsHalfUpSaturatesAndLeavesZeros) {
  const auto collected = [](std::int64_t sum, int shift) {
    ScatterPage page(kWidth, {4, 4, 4});
    VertexParts parts;
    parts.parts[21][1] = sum;
    page.add({0, 0, 0}, parts);
    const model::ResultWords result = page.collect(shift)[21];
    EXPECT_EQ(page.sum(21, 1), 0);
    EXPECT_EQ(page.vertices(), 0U);
    EXPECT_EQ(result.words[0], 0U);
    return std::pair<std::int64_t, bool>(static_cast<std::int32_t>(result.words[1]),
                                         result.saturated);
  };
  using Pair = std::pair<std::int64_t, bool>;
  constexpr std::int64_t kTop = (std::int64_t{1} << 34) - 1;
  EXPECT_EQ(collected(5, 0), Pair(5, false));
  EXPECT_EQ(collected(5, 1), Pair(3, false));
  EXPECT_EQ(collected(-5, 1), Pair(-2, false));
  EXPECT_EQ(collected(-6, 2), Pair(-1, false));
  EXPECT_EQ(collected(11, 3), Pair(1, false));
  EXPECT_EQ(collected(12, 3), Pair(2, false));
  EXPECT_EQ(collected(INT32_MAX, 0), Pair(INT32_MAX, false));
  EXPECT_EQ(collected(INT32_MAX + std::int64_t{1}, 0), Pair(INT32_MAX, true));
  EXPECT_EQ(collected(INT32_MIN, 0), Pair(INT32_MIN, false));
  EXPECT_EQ(collected(INT32_MIN - std::int64_t{1}, 0), Pair(INT32_MIN, true));
  EXPECT_EQ(collected(-kTop - 1, 3), Pair(INT32_MIN, false));
  EXPECT_EQ(collected(kTop - 4, 3), Pair(INT32_MAX, false));
  EXPECT_EQ(collected(kTop - 3, 3), Pair(INT32_MAX, true));
  EXPECT_EQ(collected(kTop, 3), Pair(INT32_MAX, true));
}

// A vertex that saturates marks all points of its page, until they are collected.
TEST(ScatterPage, SaturationIsOfThePage) {
  const auto scatter = scatter_of("bspline");
  GradientWords vertex;
  vertex.gradient[1] = 0x7FFFFFFF;
  const VertexParts parts = scatter->parts(vertex);
  EXPECT_TRUE(parts.saturated);
  ScatterPage page(kWidth, kDims);
  page.add({0, 0, 0}, parts);
  for (const auto& point : page.collect(0)) EXPECT_TRUE(point.saturated);
  for (const auto& point : page.collect(0)) EXPECT_FALSE(point.saturated);
}

// Begins, sweeps that are through or not, vertices and collects in any order: sums are those of
// the vertices since, however often the epoch of one bit came round.
TEST(ScatterPage, EpochsMayWrap) {
  std::mt19937_64 engine(10);
  const std::vector<Added> vertices = some_vertices(32, 11);
  ScatterPage page(kWidth, kDims);
  ScatterPage fresh(kWidth, kDims);
  std::size_t begins = 0;
  for (std::uint64_t step = 0; step < share_of(20'000); ++step) {
    const unsigned what = engine() % 16;
    if (what < 2) {
      page.begin();
      fresh = ScatterPage(kWidth, kDims);
      ++begins;
    } else if (what < 4) {
      page.sweep(engine() % 700);
    } else if (what == 4) {
      const auto collected = page.collect(0);
      const auto expected = fresh.collect(0);
      for (std::size_t p = 0; p < kPoints; ++p) ASSERT_EQ(collected[p].words, expected[p].words);
    } else {
      const Added& vertex = vertices[engine() % vertices.size()];
      page.add(vertex.cell, vertex.parts);
      fresh.add(vertex.cell, vertex.parts);
    }
    for (std::size_t p = 0; p < kPoints; ++p) {
      for (int c = 0; c < 3; ++c) ASSERT_EQ(page.sum(p, c), fresh.sum(p, c)) << "step " << step;
    }
  }
  EXPECT_GT(begins, share_of(1'000));
}

// What the sweep is for: a word that two begins leave alone would count again.
TEST(ScatterPage, ABeginWaitsForTheSweepOfTheOneBefore) {
  const std::vector<Added> vertices = some_vertices(1, 12);
  const auto& cell = vertices[0].cell;
  const int number = ((cell[0] + 1) * kDims[1] + cell[1] + 1) * kDims[2] + cell[2] + 1;
  const auto point = static_cast<std::size_t>(number);
  VertexParts parts;
  parts.parts[21] = {7, 8, 9};
  ScatterPage page(kWidth, kDims);
  page.add(cell, parts);
  page.begin();
  EXPECT_EQ(page.sum(point, 1), 0);
  EXPECT_EQ(page.word(point, 1), 8U) << "stale, in the epoch before";
  page.begin();
  EXPECT_EQ(page.sum(point, 1), 0);
  EXPECT_EQ(page.word(point, 1), std::uint64_t{1} << 35) << "swept to zero in the epoch between";
}

TEST(Scatter, IsOfAffineInFixedPointOf12To18Bits) {
  int rows = 0;
  for (const Configuration& row : configurations()) {
    const bool expected = completes(organization_of(row).form) && row.format != std::string("fx32");
    EXPECT_EQ(model::has_scatter(row), expected) << row.name;
    if (!expected) {
      EXPECT_THROW(model::make_scatter_model(row), std::invalid_argument) << row.name;
      continue;
    }
    EXPECT_EQ(model::make_scatter_model(row)->width(), kWidth) << row.name;
    ++rows;
  }
  EXPECT_GT(rows, 5);
}

// Mode 0, and no saturation.
TEST(Scatter, WordsOutsideAreClamped) {
  std::mt19937_64 engine(13);
  const auto scatter = scatter_of("bspline");
  GradientWords inside = random_gradient(engine);
  inside.local = {0, 0x80000000, 0x12345678};
  inside.gradient = {0x10000000, 0xE0000000, 0x12345678};
  GradientWords outside = inside;
  outside.local = {0xC0000000, 0xA0000000, 0x12345678};
  const VertexParts a = scatter->parts(inside);
  const VertexParts b = scatter->parts(outside);
  EXPECT_EQ(a.parts, b.parts);
  EXPECT_FALSE(b.saturated);
}

}  // namespace
}  // namespace hwffd
