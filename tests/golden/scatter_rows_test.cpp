// Gradients by rows: the sums of layers, and what each of them adds. docs/numerics.md section 11,
// Rows.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <map>
#include <memory>
#include <random>
#include <string>
#include <utility>
#include <vector>

#include "hwffd/model/org_affine.hpp"
#include "hwffd/oracle/oracle.hpp"
#include "scatter_vertices.hpp"
#include "share.hpp"

namespace hwffd {
namespace {

using model::GradientWords;
using model::LayerSpread;
using model::ScatterModel;
using model::ScatterPage;
using model::ScatterRow;
using model::VertexLayers;
using scatter::Fx;
using scatter::kPosition;
using scatter::kWidth;
using scatter::random_row;
using scatter::scatter_of;
using scatter::words_of;
using test::share_of;

using Row = std::vector<GradientWords>;
using Sum = std::array<std::int64_t, 3>;

constexpr std::array<int, 3> kRowDims = {9, 4, 8};
constexpr std::array<int, 3> kRowCells = {6, 1, 5};
constexpr std::size_t kRowPoints = 9 * 4 * 8;
constexpr std::int64_t kSumTop = (std::int64_t{1} << 34) - 1;

/// The sums of layers of a row, without a page.
std::map<int, Sum> layers_of(const ScatterModel& scatter, const Row& row) {
  std::map<int, Sum> sums;
  for (const GradientWords& vertex : row) {
    const VertexLayers layers = scatter.layers(vertex);
    for (int l = 0; l < 4; ++l) {
      for (int c = 0; c < 3; ++c) sums[vertex.cell[0] + l][c] += layers.added[l][c];
    }
  }
  return sums;
}

bool add_row(const ScatterModel& scatter, const Row& row, ScatterPage& page) {
  ScatterRow sums(scatter);
  for (const GradientWords& vertex : row) page.count(sums.add(vertex));
  const std::vector<bool> saturated = sums.end(page);
  return std::find(saturated.begin(), saturated.end(), true) != saturated.end();
}

void expect_equal_pages(const ScatterPage& a, const ScatterPage& b) {
  for (std::size_t point = 0; point < kRowPoints; ++point) {
    for (int c = 0; c < 3; ++c) ASSERT_EQ(a.word(point, c), b.word(point, c)) << "point " << point;
  }
  ASSERT_EQ(a.vertices(), b.vertices());
  ASSERT_EQ(a.saturated(), b.saturated());
}

// Rows in any order, their vertices in any order, over any pages: of these one is as full as can
// be, so that sums wrap.
TEST(ScatterRows, AnyOrderAndPartitionGivesTheSameBits) {
  const std::uint64_t permutations = share_of(100'000);
  std::mt19937_64 engine(1);
  const auto scatter = scatter_of("bspline");
  std::vector<Row> rows;
  for (const std::size_t count : {1, 2, 3, 7}) rows.push_back(random_row(engine, count, kRowCells));
  ScatterPage full(kWidth, kRowDims);
  LayerSpread filling;
  for (Sum& point : filling.added) point = {kSumTop, -kSumTop - 1, kSumTop};
  for (int layer = 0; layer < kRowDims[0]; ++layer) {
    for (const int k : {0, 4}) full.add_layer({layer, 0, k}, filling);
  }
  ScatterPage expected = full;
  for (const Row& row : rows) add_row(*scatter, row, expected);
  const auto shuffle = [&](auto& list) {
    for (std::size_t i = list.size() - 1; i > 0; --i) {
      std::swap(list[i], list[engine() % (i + 1)]);
    }
  };
  std::uint64_t wrapped = 0;
  for (std::size_t point = 0; point < kRowPoints; ++point) {
    for (int c = 0; c < 3; ++c) {
      if (std::abs(expected.sum(point, c) - full.sum(point, c)) > kSumTop) ++wrapped;
    }
  }
  for (std::uint64_t permutation = 0; permutation < permutations; ++permutation) {
    shuffle(rows);
    std::vector<ScatterPage> lanes(1 + engine() % 4, ScatterPage(kWidth, kRowDims));
    lanes.back() = full;
    for (Row& row : rows) {
      shuffle(row);
      add_row(*scatter, row, lanes[engine() % lanes.size()]);
    }
    for (std::size_t lane = 1; lane < lanes.size(); ++lane) lanes[0].join(lanes[lane]);
    expect_equal_pages(lanes[0], expected);
    if (HasFatalFailure()) return;
  }
  std::printf("%llu permutations, %llu sums that wrap\n",
              static_cast<unsigned long long>(permutations),
              static_cast<unsigned long long>(wrapped));
  EXPECT_GT(wrapped, kRowPoints / 4);
}

// To the bit: what the layers of a row add sums to its gradients, and of a derivative to 0.
TEST(ScatterRows, WhatARowAddsSumsToItsGradients) {
  std::mt19937_64 engine(2);
  std::uint64_t checked = 0;
  const auto check = [&](const ScatterModel& scatter, const std::string& name) {
    for (std::uint64_t r = 0; r < share_of(4'000); ++r) {
      const int derivative = static_cast<int>(r % 4) - 1;
      const Row row = random_row(engine, 1 + engine() % 40, {16, 16, 16}, derivative);
      Sum gradient{}, added{};
      for (const GradientWords& vertex : row) {
        ASSERT_EQ(scatter.layers(vertex).saturated, scatter::saturates(vertex)) << name;
        for (int c = 0; c < 3; ++c) gradient[c] += Fx::point(vertex.gradient[c]).value;
      }
      for (const auto& [layer, sum] : layers_of(scatter, row)) {
        const LayerSpread spread = scatter.spread(row[0], sum);
        ASSERT_FALSE(spread.saturated) << name << ", row " << r;
        Sum of_layer{};
        for (const Sum& point : spread.added) {
          for (int c = 0; c < 3; ++c) of_layer[c] += point[c];
        }
        const Sum zero{};
        ASSERT_EQ(of_layer, derivative > 0 ? zero : sum) << name << ", row " << r;
        for (int c = 0; c < 3; ++c) added[c] += of_layer[c];
      }
      const Sum zero{};
      ASSERT_EQ(added, derivative == kPosition ? gradient : zero) << name << ", row " << r;
      ++checked;
    }
  };
  for (const std::string& name : scatter::families()) check(*scatter_of(name), name);
  check(*scatter_of("bspline", "affine-fx17-overlapped-powers"), "powers");
  EXPECT_EQ(checked, (scatter::families().size() + 1) * share_of(4'000));
}

// Weights of the places that the rows of a grid share are those of each vertex.
TEST(ScatterRows, PlacesOfAGridHaveTheWeightsOfItsVertices) {
  std::mt19937_64 engine(8);
  const auto check = [&](const ScatterModel& scatter) {
    for (int derivative = kPosition; derivative < 3; ++derivative) {
      const Row row = random_row(engine, share_of(2'000), {16, 16, 16}, derivative);
      std::vector<AxisPlace> places;
      for (const GradientWords& vertex : row) places.push_back({vertex.cell[0], vertex.local[0]});
      const auto along_s = scatter.row_places(places, derivative);
      for (std::size_t v = 0; v < row.size(); ++v) {
        const VertexLayers expected = scatter.layers(row[v]);
        const VertexLayers layers = along_s->layers(v, row[v].gradient);
        ASSERT_EQ(layers.added, expected.added) << "vertex " << v;
        ASSERT_EQ(layers.saturated, expected.saturated) << "vertex " << v;
      }
    }
  };
  for (const std::string& name : scatter::families()) check(*scatter_of(name));
  check(*scatter_of("bspline", "affine-fx17-overlapped-powers"));
}

TEST(ScatterRows, ARowOfOneVertexIsTheVertex) {
  std::mt19937_64 engine(3);
  std::uint64_t saturated = 0;
  for (const int width : {12, 17, 18}) {
    for (const std::string& name : scatter::families()) {
      const auto model = scatter_of(name, "affine-fx17-overlapped", width);
      for (std::uint64_t v = 0; v < share_of(2'000); ++v) {
        const Row row = random_row(engine, 1, kRowCells, static_cast<int>(v % 4) - 1);
        ScatterPage by_vertices(width, kRowDims), by_rows(width, kRowDims);
        by_vertices.add(row[0].cell, model->parts(row[0]));
        EXPECT_FALSE(add_row(*model, row, by_rows));
        expect_equal_pages(by_rows, by_vertices);
        if (HasFatalFailure()) return;
        saturated += by_rows.saturated() ? 1 : 0;
      }
    }
  }
  EXPECT_GT(saturated, 0U) << "no gradient that saturates";
}

// The formulas, written down once more, of sums of any size and of functions that may saturate.
TEST(ScatterRows, ALayerIsExpandedAlongTThenU) {
  using Wide = Int128;
  std::mt19937_64 engine(4);
  const WordCodec codec("fx17");
  std::uint64_t layers_saturated = 0, layers_fit = 0;
  for (std::uint64_t round = 0; round < share_of(400); ++round) {
    const auto model = model::make_scatter_model(find_configuration("affine-fx17-overlapped"));
    AxisWords words = scatter::words_of(scatter::families()[round % 5], codec);
    // Now and then a constant that no family has.
    if (round % 3 == 0) words.word[round % 4][0] = static_cast<std::uint32_t>(engine());
    for (int axis = 0; axis < 3; ++axis) model->load(axis, words);
    const auto bank = scatter::bank_of<Fx>(words);
    for (int v = 0; v < 20; ++v) {
      const GradientWords row = random_row(engine, 1, {16, 16, 16}, v % 4 - 1)[0];
      model::LocalVertex<Fx> local{{}, row.cell, row.derivative};
      for (int axis = 0; axis < 3; ++axis) local.local[axis] = Fx::coordinate(row.local[axis]);
      const auto cumulative = model::cumulative_of<Fx>(local, bank, false);
      bool saturated = false;
      const auto fit = [&](Wide value) {
        const Wide fitting = std::clamp<Wide>(value, -Wide{kSumTop} - 1, kSumTop);
        saturated |= fitting != value;
        return static_cast<std::int64_t>(fitting);
      };
      const auto expanded = [&](int axis, std::int64_t sum) {
        std::array<std::int64_t, 4> c{}, banks{};
        for (int b = 0; b < 3; ++b) {
          const model::CumulativeWeights<Fx>& weight = cumulative[axis];
          saturated |= weight[b].saturated;
          c[b] = fit((Wide{weight[b].value} * sum + (1 << (kWidth - 3))) >> (kWidth - 2));
        }
        c[3] = row.derivative == axis ? 0 : sum;
        for (int b = 0; b < 4; ++b) banks[b] = fit(Wide{c[b]} - (b == 0 ? 0 : c[b - 1]));
        return banks;
      };
      Sum sum;
      for (std::int64_t& component : sum) {
        component = static_cast<std::int64_t>(engine()) >> (29 + engine() % 20);
        if (engine() % 16 == 0) component = engine() % 2 == 0 ? kSumTop : -kSumTop - 1;
      }
      const LayerSpread spread = model->spread(row, sum);
      for (int c = 0; c < 3; ++c) {
        const auto along_t = expanded(1, sum[c]);
        for (int bt = 0; bt < 4; ++bt) {
          const auto along_u = expanded(2, along_t[bt]);
          for (int bu = 0; bu < 4; ++bu) {
            const int m = ((bt - row.cell[1]) % 4 + 4) % 4, n = ((bu - row.cell[2]) % 4 + 4) % 4;
            ASSERT_EQ(spread.added[4 * m + n][c], along_u[bu]) << "round " << round;
          }
        }
      }
      ASSERT_EQ(spread.saturated, saturated) << "round " << round;
      ++(saturated ? layers_saturated : layers_fit);
    }
  }
  EXPECT_GT(layers_saturated, share_of(500));
  EXPECT_GT(layers_fit, share_of(500));
}

// The theorem's extremes: N vertices of one place, whose sums are N times what each of them adds;
// every weight that a family has along s, and the extremes of it along t and u.
TEST(ScatterRows, NoSumOverflowsUpToItsNumberOfVertices) {
  constexpr std::int64_t kTheorem = std::int64_t{106} << 33;  // in hundredths
  double largest_sum = 0, largest_part = 0;
  for (int width = model::kScatterLeastWidth; width <= model::kScatterMostWidth; ++width) {
    const std::int64_t most = model::scatter_most_vertices(width);
    for (const std::string& name : scatter::families()) {
      const auto model = scatter_of(name, "affine-fx17-overlapped", width);
      for (int derivative = kPosition; derivative < 3; ++derivative) {
        // The place of the largest part along s, of the coordinates that are looked at.
        Sum extreme{};
        GradientWords vertex;
        vertex.derivative = derivative;
        for (int step = 0; step <= 64; ++step) {
          vertex.local[0] = static_cast<std::uint32_t>(step) << 25;
          for (const std::uint32_t gradient : {0x80000000U, 0x7FFF0000U}) {
            vertex.gradient = {gradient, gradient, gradient};
            for (const Sum& added : model->layers(vertex).added) {
              if (std::abs(added[0]) > std::abs(extreme[0])) extreme = added;
            }
          }
        }
        for (std::int64_t& sum : extreme) sum *= most;
        ASSERT_LE(100 * std::abs(extreme[0]), std::int64_t{102} << 33) << name << width;
        largest_sum = std::max(largest_sum, std::ldexp(std::abs(extreme[0]), -33));
        for (int t = 0; t <= 16; ++t) {
          for (int u = 0; u <= 16; ++u) {
            vertex.local[1] = static_cast<std::uint32_t>(t) << 27;
            vertex.local[2] = static_cast<std::uint32_t>(u) << 27;
            vertex.cell = {0, t % 4, u % 4};
            const LayerSpread spread = model->spread(vertex, extreme);
            ASSERT_FALSE(spread.saturated) << name << ", " << width << " bits";
            for (const Sum& added : spread.added) {
              ASSERT_LE(100 * std::abs(added[0]), kTheorem) << name << ", " << width << " bits";
              largest_part = std::max(largest_part, std::ldexp(std::abs(added[0]), -33));
            }
          }
        }
      }
    }
  }
  std::printf("at most %.4g and %.4g times 2^33\n", largest_sum, largest_part);
  EXPECT_GE(largest_part, 1) << "no extremes";
}

// N of them in one row and a vertex more of another: nothing has wrapped.
TEST(ScatterRows, ARowOfAllVerticesThatFitLeavesExactly) {
  const auto model = scatter_of("linear");
  GradientWords vertex;  // on a corner of its cell, all of whose gradient goes to a point
  vertex.gradient = {0x80000000, 0x40000000, 0x00008000};
  ScatterPage page(kWidth, {4, 4, 4});
  ScatterRow row(*model);
  const std::int64_t most = model::scatter_most_vertices(kWidth);
  for (std::int64_t v = 0; v < most; ++v) page.count(row.add(vertex));
  for (const bool saturated : row.end(page)) EXPECT_FALSE(saturated);
  EXPECT_FALSE(page.overflowed());
  std::size_t points = 0;
  for (std::size_t point = 0; point < 64; ++point) {
    if (page.sum(point, 0) == 0) continue;
    ++points;
    EXPECT_EQ(page.sum(point, 0), -(most << (kWidth - 1)));
    EXPECT_EQ(page.sum(point, 1), most << (kWidth - 2));
    EXPECT_EQ(page.sum(point, 2), most);
  }
  EXPECT_EQ(points, 1U);
  page.count(row.add(vertex));
  row.end(page);
  EXPECT_TRUE(page.overflowed());
}

// With more vertices the sum of a layer is one modulo 2^35, and nothing saturates.
TEST(ScatterRows, SumsOfLayersWrap) {
  constexpr std::int64_t kVertices = 300'000;
  const auto model = scatter_of("linear");
  GradientWords vertex;
  vertex.gradient[2] = 0x80000000;
  ScatterPage page(kWidth, {4, 4, 4});
  ScatterRow row(*model);
  for (std::int64_t v = 0; v < kVertices; ++v) page.count(row.add(vertex));
  for (const bool saturated : row.end(page)) EXPECT_FALSE(saturated);
  std::int64_t sum = 0;
  for (std::size_t point = 0; point < 64; ++point) sum += page.sum(point, 2);
  EXPECT_EQ(sum, (std::int64_t{1} << 35) - (kVertices << (kWidth - 1)));
}

// Functions of no family may leave that bound with half as many vertices as a page counts. They sum
// to one, and no layer saturates; but the sum of two layers wraps, and nothing tells.
TEST(ScatterRows, SumsOfOtherFunctionsMayWrapAndNothingTells) {
  const WordCodec codec("fx17");
  const auto model = scatter_of("bspline");
  AxisWords words = words_of("constant", codec);
  constexpr std::uint32_t kMost = 0x7F5C0000;  // 1.99
  words.word[0] = {kMost, 0, 0, 0};
  words.word[1] = words.word[2] = {0, 0, 0, 0};
  words.word[3] = {(1U << 30) - kMost, 0, 0, 0};
  for (int axis = 0; axis < 3; ++axis) model->load(axis, words);
  GradientWords vertex;
  vertex.gradient = {0x7FFF0000, 0, 0};
  const VertexLayers layers = model->layers(vertex);
  EXPECT_FALSE(layers.saturated);
  ScatterPage page(kWidth, {4, 4, 4});
  ScatterRow row(*model);
  const std::int64_t vertices = model::scatter_most_vertices(kWidth) / 4;
  std::int64_t exact = 0;
  for (int rows = 0; rows < 2; ++rows) {
    for (std::int64_t v = 0; v < vertices; ++v) page.count(row.add(vertex));
    for (const bool saturated : row.end(page)) EXPECT_FALSE(saturated);
    if (rows == 0) exact = 2 * page.sum(0, 0);
  }
  EXPECT_GT(exact, kSumTop);
  EXPECT_EQ(page.sum(0, 0), exact - (std::int64_t{1} << 35));
  EXPECT_FALSE(page.overflowed());
  EXPECT_FALSE(page.saturated());
}

/// The sum of the errors of a component over all points of a row, in units of a part, against
/// eq. (1) in double.
double error_of_row(const ScatterModel& scatter, const Oracle& oracle, const Row& row,
                    double scale) {
  std::map<std::pair<int, int>, Eigen::Vector3d> exact;  // of layer and point
  for (const GradientWords& vertex : row) {
    const Support support = scale * oracle.pull_back(scatter::gradient_of(vertex),
                                                     scatter::local_of(vertex), vertex.derivative);
    for (int p = 0; p < 64; ++p) {
      auto& sum = exact.try_emplace({vertex.cell[0] + p / 16, p % 16}, 0, 0, 0).first->second;
      for (int c = 0; c < 3; ++c) sum[c] += std::ldexp(support(p, c), kWidth - 1);
    }
  }
  std::array<double, 3> error{};
  for (const auto& [layer, sum] : layers_of(scatter, row)) {
    const LayerSpread spread = scatter.spread(row[0], sum);
    for (int p = 0; p < 16; ++p) {
      const Eigen::Vector3d& wanted = exact.at({layer, p});
      for (int c = 0; c < 3; ++c) {
        error[c] += std::abs(static_cast<double>(spread.added[p][c]) - wanted[c]);
      }
    }
  }
  return *std::max_element(error.begin(), error.end());
}

// The limits are set over what was measured: of rows of 64 vertices in up to four cells, for each
// of their vertices.
TEST(ScatterRows, IsNearTheOracle) {
  constexpr std::size_t kVertices = 64;
  std::mt19937_64 engine(5);
  for (const auto& [name, limit] : {std::pair<std::string, double>{"bspline", 1.5},
                                    {"bernstein", 5},
                                    {"catmull-rom", 4},
                                    {"linear", 0.6}}) {
    const auto model = scatter_of(name);
    const AxisWords words = scatter::words_of(name, WordCodec("fx17"));
    const Oracle oracle(Oracle::family(name));
    double largest = 0, of_vertices = 0;
    for (std::uint64_t r = 0; r < share_of(2'000); ++r) {
      const int derivative = static_cast<int>(r % 4) - 1;
      const Row row = random_row(engine, kVertices, {4, 16, 16}, derivative);
      const double scale = derivative == kPosition ? 1 : std::ldexp(1, -words.derivative.exponent);
      largest = std::max(largest, error_of_row(*model, oracle, row, scale) / kVertices);
      double sum = 0;
      for (std::size_t v = 0; v < kVertices; ++v) {
        sum += error_of_row(*model, oracle, {row[v]}, scale);
      }
      of_vertices = std::max(of_vertices, sum / kVertices);
    }
    std::printf("%s: %.3g units a vertex, limit %.3g; by vertices %.3g\n", name.c_str(), largest,
                limit, of_vertices);
    EXPECT_LE(largest, limit) << name;
    EXPECT_GE(2 * largest, limit) << name << ": the limit says nothing";
  }
}

/// Both sides of the adjoint identity for one component and a row: the positions of its vertices
/// times their gradients, and the points of its layers times what these get.
struct RowAdjoint {
  RowAdjoint(std::mt19937_64& engine, const std::string& name)
      : bank(scatter::bank_of<Fx>(scatter::words_of(name, WordCodec("fx17")))) {
    const int derivative = static_cast<int>(engine() % 4) - 1;
    row = random_row(engine, 1 + engine() % 30, {1 + static_cast<int>(engine() % 8), 16, 16},
                     derivative);
    for (GradientWords& vertex : row) {
      if (scatter::saturates(vertex)) vertex.gradient = {0x7FFF0000, 0x7FFF0000, 0x7FFF0000};
      for (int l = 0; l < 4; ++l) points.try_emplace(vertex.cell[0] + l);
    }
    // Small enough that nothing saturates in affine.
    for (auto& [layer, of_layer] : points) {
      for (auto& point : of_layer) {
        const auto bits = static_cast<std::int32_t>(engine() >> 32);
        point = Fx::point(static_cast<std::uint32_t>(bits / 2));
        largest = std::max(largest, std::ldexp(std::abs(point.value), 1 - kWidth));
      }
    }
  }

  model::LocalVertex<Fx> local(const GradientWords& vertex) const {
    model::LocalVertex<Fx> result{{}, vertex.cell, vertex.derivative};
    for (int axis = 0; axis < 3; ++axis) {
      result.local[axis] = Fx::coordinate(vertex.local[axis]);
    }
    return result;
  }

  model::Support<Fx> support(const GradientWords& vertex) const {
    model::Support<Fx> result{};
    for (int p = 0; p < 64; ++p) result[p][0] = points.at(vertex.cell[0] + p / 16)[p % 16];
    return result;
  }

  /// Magnitudes of the four weights of an axis, summed.
  double length(const GradientWords& vertex, int axis) const {
    double sum = 0;
    const auto weights = model::OrgAffine<Fx>::weights(local(vertex), bank);
    for (const auto& weight : weights[axis]) {
      sum += std::ldexp(std::abs(weight.value), 2 - kWidth);
    }
    return sum;
  }

  /// The sum of points times what they get, in local order along t and u.
  template <class Parts>
  Int128 back_of(const std::map<int, typename Parts::Part>& sums) const {
    const auto cumulative = model::cumulative_of<Fx>(local(row[0]), bank, false);
    Int128 sum = 0;
    for (const auto& [layer, of_layer] : sums) {
      const auto banks = model::scattered_from<Parts, 1>(cumulative, of_layer, row[0].derivative);
      for (int b = 0; b < 16; ++b) {
        const int m = model::local_of_bank(b >> 2, row[0].cell[1]);
        const int n = model::local_of_bank(b, row[0].cell[2]);
        const Int128 point = points.at(layer)[4 * m + n].value;
        if constexpr (std::is_same_v<Parts, model::ExactParts<Fx>>) {
          sum += point * banks[b];
        } else {
          EXPECT_FALSE(banks[b].saturated);
          sum += point * banks[b].value;
        }
      }
    }
    return sum;
  }

  /// Without any rounding.
  Int128 exact_back() const {
    std::map<int, Int128> sums;
    for (const GradientWords& vertex : row) {
      const auto cumulative = model::cumulative_of<Fx>(local(vertex), bank, false);
      const auto banks = model::expanded<model::ExactParts<Fx>>(cumulative[0], gradient(vertex),
                                                                vertex.derivative != 0);
      for (int b = 0; b < 4; ++b) {
        sums[vertex.cell[0] + model::local_of_bank(b, vertex.cell[0])] += banks[b];
      }
    }
    return back_of<model::ExactParts<Fx>>(sums);
  }

  Int128 back(const ScatterModel& scatter) const {
    std::map<int, Fx::Part> sums;
    for (const auto& [layer, sum] : layers_of(scatter, row)) sums[layer] = {sum[0], false};
    return back_of<model::WideParts<Fx>>(sums);
  }

  /// Eq. (1) of all vertices times their gradients, without narrowing.
  Int128 exact_forward() const {
    Int128 forward = 0;
    for (const GradientWords& vertex : row) {
      const auto weight = model::OrgAffine<Fx>::weights(local(vertex), bank);
      const auto by_bank = model::by_bank<Fx>(support(vertex), vertex.cell);
      Int128 position = 0;
      for (int p = 0; p < 64; ++p) {
        position += Int128{weight[0][p / 16].value} * weight[1][p / 4 % 4].value *
                    weight[2][p % 4].value * by_bank[p][0].value;
      }
      forward += position * gradient(vertex);
    }
    return forward;
  }

  static std::int64_t gradient(const GradientWords& vertex) {
    return Fx::point(vertex.gradient[0]).value;
  }

  model::CoefficientBank<Fx> bank;
  Row row;
  std::map<int, std::array<Fx::Point, 16>> points;  // of each layer
  double largest = 0;                               // magnitude of a point
};

TEST(ScatterRowsAdjoint, IsExactWithoutNarrowing) {
  std::mt19937_64 engine(6);
  for (const std::string& name : scatter::families()) {
    for (std::uint64_t r = 0; r < share_of(800); ++r) {
      const RowAdjoint both(engine, name);
      ASSERT_TRUE(both.exact_forward() == both.exact_back()) << name << ", row " << r;
    }
  }
}

TEST(ScatterRowsAdjoint, IsWithinItsBoundWithNarrowing) {
  std::mt19937_64 engine(7);
  double nearest = 0, nearest_of_vertices = 0;
  for (const std::string& name : scatter::families()) {
    const model::OrgAffine<Fx> affine(find_configuration("affine-fx17-overlapped"));
    const auto scatter = scatter_of(name);
    for (std::uint64_t r = 0; r < share_of(4'000); ++r) {
      const RowAdjoint both(engine, name);
      const double lt = both.length(both.row[0], 1), lu = both.length(both.row[0], 2);
      const auto vertices = static_cast<double>(both.row.size());
      const auto layers = static_cast<double>(both.points.size());
      Int128 forward = 0;
      double of_affine = 0;
      for (const GradientWords& vertex : both.row) {
        const auto position =
            affine.evaluate(both.local(vertex), both.support(vertex), both.bank)[0];
        ASSERT_FALSE(position.saturated);
        forward += Int128{position.value} * RowAdjoint::gradient(vertex);
        of_affine += std::ldexp(std::abs(RowAdjoint::gradient(vertex)), 1 - kWidth) *
                     both.length(vertex, 0) * (1 + lt) / 2;
      }
      const double unit = std::ldexp(1, 1 - kWidth);
      const double of_rows = vertices * lt * lu + layers * (lu + 4);
      const double of_vertices = vertices * (lt * lu + 4 * lu + 16);
      const double bound = unit * (of_affine + 3 * both.largest * of_rows);
      // In units of the product of a point and a part: a sum has W - 1 digits fewer.
      const double difference =
          std::abs(std::ldexp(static_cast<double>(forward), -(2 * kWidth - 3) - (kWidth - 1)) -
                   std::ldexp(static_cast<double>(both.back(*scatter)), -2 * (kWidth - 1)));
      ASSERT_LE(difference, bound) << name << ", row " << r;
      ASSERT_LE(of_rows, of_vertices);
      nearest = std::max(nearest, difference / bound);
      nearest_of_vertices = std::max(nearest_of_vertices, of_vertices / of_rows);
    }
  }
  std::printf("at most %.3g of the bound; that of vertices is up to %.3g times as large\n", nearest,
              nearest_of_vertices);
  EXPECT_GT(nearest, 0.02) << "the bound says nothing";
}

}  // namespace
}  // namespace hwffd
