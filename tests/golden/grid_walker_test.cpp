// A walker over a grid has the words and flags of each of its vertices by itself: of every row that
// contracts one axis after the other, over random grids.
#include <gtest/gtest.h>

#include <array>
#include <cstdint>
#include <cstdio>
#include <random>
#include <vector>

#include "hwffd/model/schedule.hpp"
#include "random_lattice.hpp"

namespace hwffd {
namespace {

using model::EvaluatorModel;
using model::ResidentPoints;
using model::ResultWords;

constexpr int kGrids = 40;  // of each row

struct Counts {
  std::uint64_t vertices = 0;
  std::uint64_t saturated = 0;
  std::uint64_t nan = 0;
  std::uint64_t last_faces = 0;
  std::uint64_t longest_step = 0;  // in cells
  int forwards = 0;
  int backwards = 0;
  int still = 0;
};

/// Points of a lattice, of which one in 150 is any words at all, or the largest word of fixed
/// point, which saturates as it is rounded to fewer bits.
ResidentPoints random_points(const WordCodec& codec, std::mt19937_64& random) {
  ResidentPoints points;
  for (int& points_of_axis : points.dims) points_of_axis = 4 + static_cast<int>(random() % 9);
  LatticeWords words = random_words(codec, points.dims, random);
  points.exponent = words.exponent;
  for (const auto& word : words.points) {
    ResidentPoints::Point point{word[0], word[1], word[2], 0};
    if (random() % 150 == 0) {
      const bool largest = random() % 4 == 0;
      for (std::uint32_t& wild : point) {
        wild = largest ? 0x7FFFFFFF : static_cast<std::uint32_t>(random());
      }
    }
    points.points.push_back(point);
  }
  return points;
}

/// Functions as good as any: the B-spline, or any words, whose weights saturate now and then.
void load_functions(EvaluatorModel& model, const WordCodec& codec, bool any,
                    std::mt19937_64& random) {
  if (!any) return load(model, encode(watertight_bspline(codec), codec), 1);
  for (int axis = 0; axis < 3; ++axis) {
    for (int function = 0; function < 4; ++function) {
      std::array<std::uint32_t, 4> words{};
      for (std::uint32_t& word : words) word = codec.coefficient(4 * unit(random) - 2, 0);
      const int degree = static_cast<int>(random() % 4);
      const int shift = static_cast<int>(random() % 2);
      model.load(1, axis, function, degree, shift, words);
      model.load_derivative(1, axis, function, 3 - degree, shift, words);
    }
  }
}

/// A grid that stays in its lattice: it goes from one place to another along each axis, either way,
/// with places of the last face among them, or stands still.
Grid random_grid(const std::array<int, 3>& dims, std::mt19937_64& random, Counts& counts) {
  std::array<double, 3> first{};
  std::array<double, 3> last{};
  std::array<int, 3> count{};
  for (int axis = 0; axis < 3; ++axis) {
    const int cells = dims[axis] - 3;
    const auto place = [&] {
      const double whole = static_cast<double>(random() % (cells + 1U));
      return random() % 3 == 0 ? whole : cells * unit(random);
    };
    first[axis] = place();
    last[axis] = random() % 6 == 0 ? first[axis] : place();
    count[axis] = 1 + static_cast<int>(random() % (random() % 4 == 0 ? 3 : axis == 0 ? 40 : 7));
  }
  Grid grid = grid_between(first, last, count);
  for (int axis = 0; axis < 3; ++axis) {
    if (random() % 2 == 0) grid.start[axis] -= grid.start[axis] % (std::uint64_t{1} << 16);
    const std::int64_t step = grid.step[axis];
    counts.forwards += step > 0 ? 1 : 0;
    counts.backwards += step < 0 ? 1 : 0;
    counts.still += step == 0 ? 1 : 0;
    const auto length = static_cast<std::uint64_t>(step < 0 ? -step : step) >> kGridFraction;
    counts.longest_step = std::max(counts.longest_step, length);
  }
  return grid;
}

/// Holds the results of rows `first` to `end - 1` to those of their vertices.
void compare(const EvaluatorModel& model, const ResidentPoints& points, const Grid& grid,
             const std::vector<VertexBeat>& vertices, int derivative, std::size_t first,
             std::size_t end, const std::vector<ResultWords>& results, Counts& counts) {
  ASSERT_EQ(results.size(), (end - first) * grid.count[0]);
  for (std::size_t v = 0; v < results.size(); ++v) {
    const VertexBeat& vertex = vertices[first * grid.count[0] + v];
    model::VertexWords words = model::with_support(points, {vertex.local, vertex.cell});
    words.derivative = derivative;
    const ResultWords wanted = model.evaluate(1, words);
    ASSERT_EQ(results[v].words, wanted.words) << "vertex " << v;
    ASSERT_EQ(results[v].saturated, wanted.saturated) << "vertex " << v;
    ASSERT_EQ(results[v].nan, wanted.nan) << "vertex " << v;
    ++counts.vertices;
    counts.saturated += wanted.saturated ? 1 : 0;
    counts.nan += wanted.nan ? 1 : 0;
    counts.last_faces += vertex.local[0] == model.one_word() ? 1 : 0;
  }
}

class Walker : public ::testing::TestWithParam<const char*> {};

TEST_P(Walker, GivesTheBitsOfEachVertexByItself) {
  const Configuration& row = find_configuration(GetParam());
  const WordCodec codec(row.format);
  std::mt19937_64 random(7);
  Counts counts;
  std::uint64_t expected = 0;
  for (int n = 0; n < kGrids; ++n) {
    const auto model = model::make_evaluator_model(row);
    load_functions(*model, codec, n % 4 == 3, random);
    const ResidentPoints points = random_points(codec, random);
    const Grid grid = random_grid(points.dims, random, counts);
    ASSERT_TRUE(grid_fits(grid, points.dims));
    const std::vector<VertexBeat> vertices = grid_vertices(grid, points.dims, codec);
    const int derivative = n % 2 == 0 ? -1 : static_cast<int>(random() % 3);
    const auto walker = model->walker(1, points, axis_places(grid, points.dims, codec), derivative);
    ASSERT_NE(walker, nullptr);
    // In two parts, as two threads would.
    const std::size_t rows = std::size_t{grid.count[1]} * grid.count[2];
    const std::size_t middle = random() % (rows + 1);
    for (const auto& [first, end] : {std::pair{std::size_t{0}, middle}, std::pair{middle, rows}}) {
      std::vector<ResultWords> results;
      walker->evaluate(first, end, results);
      ASSERT_NO_FATAL_FAILURE(
          compare(*model, points, grid, vertices, derivative, first, end, results, counts))
          << "grid " << n;
    }
    expected += vertex_count(grid);
  }
  std::printf("%llu vertices, %llu saturated, %llu NaN, %llu on a last face\n",
              static_cast<unsigned long long>(counts.vertices),
              static_cast<unsigned long long>(counts.saturated),
              static_cast<unsigned long long>(counts.nan),
              static_cast<unsigned long long>(counts.last_faces));
  EXPECT_EQ(counts.vertices, expected);
  EXPECT_GT(counts.vertices, 5000U);
  EXPECT_GT(counts.last_faces, 10U);
  EXPECT_GT(counts.forwards, 10);
  EXPECT_GT(counts.backwards, 10);
  EXPECT_GT(counts.still, 10);
  EXPECT_GT(counts.longest_step, 2U);
  if (codec.is_float()) {
    EXPECT_GT(counts.nan, codec.is_block() ? 0U : 20U);
  } else if (wired_in(row) && codec.weight_fraction() == 30) {
    EXPECT_EQ(counts.saturated, 0U);  // between the points, and these are words as they are
  } else {
    EXPECT_GT(counts.saturated, 100U);
    EXPECT_LT(counts.saturated, counts.vertices / 2);
  }
}

/// One row of each model that contracts, whatever is folded.
INSTANTIATE_TEST_SUITE_P(, Walker,
                         ::testing::Values("walk-fx17-overlapped", "walk-fx17-overlapped-powers",
                                           "affine-fx32-overlapped",
                                           "affine3-fx32-overlapped-powers",
                                           "factored-fx18-overlapped",
                                           "factored-fx18-overlapped-powers",
                                           "factored-fx32-overlapped", "factored-fp32-overlapped",
                                           "factored-bfp32-overlapped"),
                         [](const auto& info) {
                           std::string name = info.param;
                           std::replace(name.begin(), name.end(), '-', '_');
                           return name;
                         });

TEST(Walkers, RowsThatContractHaveOneAndNoOthers) {
  std::size_t walked = 0;
  for (const Configuration& row : configurations()) {
    const WordCodec codec(row.format);
    std::mt19937_64 random(1);
    const ResidentPoints points = random_points(codec, random);
    const Grid grid = grid_between({0, 0, 0}, {1, 1, 1}, {2, 2, 2});
    const auto model = model::make_evaluator_model(row);
    const bool there = model->walker(0, points, axis_places(grid, points.dims, codec)) != nullptr;
    EXPECT_EQ(there, contracts(row)) << row.name;
    walked += there ? 1 : 0;
  }
  EXPECT_GT(walked, 20U);
  EXPECT_LT(walked, configurations().size());
}

// Lanes of 64 bits hold sums of 32-bit points with weights such as those of B-splines: vertices of
// a grid with others are taken one by one.
TEST(Walkers, WeightsThatLanesDoNotHoldAreToldApart) {
  using Number = Fixed<32>::Weight;
  const auto of = [](std::int64_t a, std::int64_t b) {
    return std::array<Number, 4>{{{a, false}, {b, false}, {0, false}, {0, false}}};
  };
  constexpr std::int64_t kTwo = std::int64_t{1} << 31;
  EXPECT_TRUE(model::EightByEight<32>::holds(of(kTwo, 0)));
  EXPECT_TRUE(model::EightByEight<32>::holds(of(-kTwo / 2, kTwo / 2)));
  EXPECT_FALSE(model::EightByEight<32>::holds(of(kTwo, 1)));
  EXPECT_FALSE(model::EightByEight<32>::holds(of(-kTwo, -1)));
  EXPECT_TRUE(model::EightByEight<24>::holds(of(-(1 << 23), 7 * (1 << 22))));
}

}  // namespace
}  // namespace hwffd
