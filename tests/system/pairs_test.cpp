// Grids whose results are two vertices a beat, in a core that takes two neighbours of a row in a
// clock: which of them are pairs changes no bit, and the clocks of a row are those of its pairs or
// of the planes that it wants, whichever are more.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>

#include "expand_run.hpp"
#include "hwffd/model/schedule.hpp"
#include "hwffd/stream/halves.hpp"
#include "named.hpp"
#include "share.hpp"

namespace hwffd::test {
namespace {

constexpr PageVertices kHalves = [] {
  PageVertices how;
  how.half = true;
  return how;
}();

bool takes_pairs(const PageBuild& build) {
  return pairs(find_configuration(build.row)) && (build.core.features & model::kHalvesFeature) != 0;
}

/// What a row along s of a grid asks for.
struct Row {
  static constexpr std::uint64_t kPlaneClocks = 4;
  static constexpr int kPlanes = 4;  ///< that a cell has along s

  std::uint64_t vertices = 0;
  std::uint64_t items = 0;   ///< pairs, and vertices that are none of one
  std::uint64_t planes = 0;  ///< where the row before has nothing in common with it

  std::uint64_t seconds() const { return vertices - items; }
  std::uint64_t clocks() const { return std::max(items, kPlaneClocks * planes); }
};

/// Runs of vertices with one whole part are cut into pairs; the last face is a whole part of its
/// own, but no cell.
Row row_of(const Grid& grid, int points) {
  Row row;
  row.vertices = grid.count[0];
  row.planes = Row::kPlanes;
  std::int64_t before = 0;
  bool open = false;  // the item before is one vertex that another may join
  std::uint64_t at = grid.start[0];
  for (unsigned n = 0; n < grid.count[0]; ++n, at += static_cast<std::uint64_t>(grid.step[0])) {
    const auto whole = static_cast<std::int64_t>(at >> kGridFraction);
    open = n > 0 && open && whole == before;
    if (!open) ++row.items;
    if (n > 0) {
      const auto cell = [&](std::int64_t of) { return std::min<std::int64_t>(of, points - 4); };
      row.planes += static_cast<std::uint64_t>(
          std::min<std::int64_t>(std::abs(cell(whole) - cell(before)), Row::kPlanes));
    }
    open = !open;
    before = whole;
  }
  return row;
}

/// Rows whose fastest axis goes anywhere, along many vertices or few.
Grid rows_of_pairs(tb::Random& random, const std::array<int, 3>& dims, int count, int rows,
                   int layers = 1) {
  std::array<double, 3> from{}, to{};
  for (int axis = 0; axis < 3; ++axis) {
    const double cells = dims[axis] - 3;
    const auto place = [&] {
      if (axis == 0 && random.chance(0.3)) return cells * random.pick({0.0, 1.0});
      if (axis == 0 && random.chance(0.1)) return static_cast<double>(random.below(dims[0] - 3));
      return cells * random.unit();
    };
    from[axis] = place();
    to[axis] = axis == 0 && random.chance(0.05) ? from[axis] : place();
  }
  return grid_between(from, to, {count, rows, layers}, static_cast<std::uint16_t>(random.word()));
}

class Pairs : public ::testing::TestWithParam<PageBuild> {};

// Rows of any length, over any number of cells, forwards and backwards. Two rows are a whole number
// of beats: those behind the first few follow each other at exactly twice the clocks of one.
TEST_P(Pairs, ClocksOfRowsEqualTheFormula) {
  if (GetParam().name.find("small") != std::string::npos) GTEST_SKIP() << "its queues are short";
  tb::Random random(tb::seed_from_environment(1));
  std::size_t by_items = 0, by_planes = 0, fast = 0;
  for (std::size_t trial = 0; trial < share_of(120); ++trial) {
    ExpandRun run(GetParam(), trial);
    const LatticeWords lattice = run.random_lattice(random, std::array<int, 3>{16, 16, 5});
    const int count = static_cast<int>(random.between(1, random.pick({20, 120, 250})));
    constexpr std::size_t kRows = 24;
    const Grid grid = rows_of_pairs(random, lattice.dims, count, kRows);
    const Row row = row_of(grid, lattice.dims[0]);
    (row.clocks() == row.items ? by_items : by_planes) += 1;
    fast += 2 * row.clocks() == row.vertices ? 1 : 0;
    run.send_bspline();
    run.send_lattice(lattice);
    run.send_grid(grid, kHalves);
    ASSERT_TRUE(run.run());
    EXPECT_EQ(run.bench().seconds(), kRows * row.seconds());
    const auto& at = run.bench().result_clocks();
    const auto beats = static_cast<std::size_t>(count);  // of two rows
    ASSERT_EQ(at.size(), kRows / 2 * beats);
    for (std::size_t r = kRows / 4; r < kRows / 2; ++r) {
      ASSERT_EQ(at[r * beats] - at[(r - 1) * beats], 2 * row.clocks())
          << "trial " << trial << ", rows " << 2 * r << " of " << count << " vertices, "
          << row.items << " items, " << row.planes << " planes";
    }
  }
  std::printf("rows as long as their items %zu, as their planes %zu; two vertices a clock %zu\n",
              by_items, by_planes, fast);
  EXPECT_GT(by_items, 0U);
  EXPECT_GT(by_planes, 0U);
}

// Every bit and every event, whatever stalls, of grids among vertices, lattices and functions: with
// and without halves, single vertices and pairs in any order.
TEST_P(Pairs, BitsOfAnyGrids) {
  std::uint64_t vertices = 0, seconds = 0, saturated = 0;
  for (std::uint64_t seed = tb::seed_from_environment(1), last = seed + share_of(16); seed < last;
       ++seed) {
    tb::Random random(seed);
    ExpandRun run(GetParam(), seed, random.pick({"always", "bursts", "bernoulli", "gaps"}),
                  random.pick({"always", "bernoulli", "bursts", "sparse"}));
    run.send_functions();
    std::uint64_t expected = 0;  // second vertices
    for (int round = 0; round < 4; ++round) {
      LatticeWords lattice =
          run.random_lattice(random, static_cast<int>(random.between(4, run.axis_points() / 2)));
      if (random.chance(0.5)) {  // half of its points saturate where weights overshoot
        for (auto& point : lattice.points) point[1] = random.chance(0.5) ? 0x7FFFFFFF : point[1];
      }
      run.send_lattice(lattice);
      for (int some = 0; some < 5; ++some) {
        PageVertices how = run.random_flags(random, lattice);
        if (random.chance(0.7)) {
          how.fourth = false;
          how.results = Results::kPosition;
          how.half = true;
        }
        const int count = static_cast<int>(random.between(1, random.pick({3, 12, 80})));
        const Grid grid =
            rows_of_pairs(random, lattice.dims, count, static_cast<int>(random.between(1, 5)),
                          static_cast<int>(random.between(1, 3)));
        run.send_grid(grid, how);
        vertices += vertex_count(grid);
        if (how.half && how.results == Results::kPosition) {
          expected += row_of(grid, lattice.dims[0]).seconds() * grid.count[1] * grid.count[2];
        }
        if (random.chance(0.3)) {
          run.send_vertices(
              random_vertices(run.codec(), random, lattice.dims, random.between(1, 9), true), how);
        }
      }
      if (random.chance(0.3)) run.send_functions();
    }
    ASSERT_TRUE(run.run());
    EXPECT_EQ(run.bench().seconds(), expected);
    seconds += expected;
    saturated += run.pulses(event::kSaturated);
  }
  std::printf("%zu vertices of grids, %zu of them second ones; %zu saturated\n",
              std::size_t{vertices}, std::size_t{seconds}, std::size_t{saturated});
  EXPECT_GT(seconds, 0U);
  EXPECT_GT(saturated, 0U);
}

// A grid is two packets, one with results of a beat each: rounded, they are those of the other.
TEST_P(Pairs, AreTheRoundedResults) {
  tb::Random random(3);
  ExpandRun run(GetParam(), 3, "always", "bernoulli");
  run.send_functions();
  const LatticeWords lattice = run.random_lattice(random, std::array<int, 3>{9, 5, 5});
  run.send_lattice(lattice);
  const Grid grid = grid_between({0, 0.5, 0.5}, {6, 1.5, 1.5}, {49, 3, 1});
  run.send_grid(grid);
  run.send_grid(grid, kHalves);
  ASSERT_TRUE(run.run());
  const std::size_t count = vertex_count(grid);
  const std::vector<Beat>& results = run.bench().results();
  ASSERT_EQ(results.size(), count + (count + 1) / 2);
  const auto halves =
      halves_of({results.begin() + static_cast<std::ptrdiff_t>(count), results.end()});
  ASSERT_EQ(halves.size(), count);
  for (std::size_t v = 0; v < count; ++v) {
    for (int c = 0; c < 3; ++c) {
      EXPECT_EQ(halves[v].words[c], half_word(results[v].words[c]).value) << "vertex " << v;
    }
  }
  EXPECT_EQ(run.bench().seconds(), 3 * 24U);
}

// A sum of 1 - 2^-31, which is a word and none of 20 bits: points and functions go one unit of
// theirs beyond 1 - 2^-16 along s. Rounding saturates of either vertex of a pair, and each is an
// event.
TEST_P(Pairs, RoundingSaturates) {
  if (std::string(find_configuration(GetParam().row).evaluator) == "powers") {
    GTEST_SKIP() << "functions are wired in";
  }
  tb::Random random(9);
  ExpandRun run(GetParam(), 9, "gaps", "gaps");
  LatticeWords lattice = run.random_lattice(random, std::array<int, 3>{4, 4, 4});
  for (std::size_t p = 0; p < lattice.points.size(); ++p) {
    lattice.points[p] = {p < 16 ? 0x80000000U - (1U << 15) : 1U << 30, 0, 0};
  }
  const double unit = std::ldexp(1.0, -run.codec().weight_fraction());
  const Blending one = family("constant", run.codec());
  const Blending beyond = user_blending({{{1 + unit, 0, 0, 0}, {-unit, 0, 0, 0}, {}, {}}});
  run.send(coefficients_packet({beyond, one, one}, run.codec()));
  run.send_lattice(lattice);
  const Grid grid = grid_between({0, 0.5, 0.5}, {0.75, 0.5, 0.5}, {5, 1, 1});
  run.send_grid(grid);
  run.send_grid(grid, kHalves);
  ASSERT_TRUE(run.run());
  const std::vector<Beat>& results = run.bench().results();
  ASSERT_EQ(results.size(), 5U + 3U);
  EXPECT_EQ(results[0].words[0], 0x7FFFFFFFU);
  EXPECT_EQ(results[0].words[3] & kStatusSaturated, 0U);
  for (const HalfResult& half : halves_of({results.begin() + 5, results.end()})) {
    EXPECT_EQ(half.words[0], 0x7FFFF);
    EXPECT_TRUE(half.saturated);
  }
  EXPECT_EQ(run.pulses(event::kSaturated), 5U);
  EXPECT_EQ(run.bench().seconds(), 2U);
}

// Before functions are loaded vertices are evaluated one by one: each has its event, at its beat.
TEST_P(Pairs, WithoutFunctionsThereAreNone) {
  if (std::string(find_configuration(GetParam().row).evaluator) == "powers") {
    GTEST_SKIP() << "functions are wired in";
  }
  tb::Random random(5);
  ExpandRun run(GetParam(), 5);
  const LatticeWords lattice = run.random_lattice(random, std::array<int, 3>{6, 5, 4});
  run.send_lattice(lattice);
  run.send_grid(grid_between({0, 0, 0}, {2, 1, 1}, {11, 2, 1}), kHalves);
  ASSERT_TRUE(run.run());
  EXPECT_EQ(run.pulses(event::kNoCoefficients), 22U);
  EXPECT_EQ(run.bench().event_place(stream_event(event::kNoCoefficients)).beat, 22U);
  EXPECT_EQ(run.bench().seconds(), 0U);
  run.send_bspline();
  run.send_grid(grid_between({0, 0, 0}, {2, 1, 1}, {11, 2, 1}), kHalves);
  ASSERT_TRUE(run.run());
  EXPECT_GT(run.bench().seconds(), 0U);
}

// A grid that is too long is told at its last vertex, which is the second of a pair or not.
TEST_P(Pairs, APacketThatIsTooLongIsToldAtItsLastVertex) {
  for (int count = 1; count < 8; ++count) {
    tb::Random random(static_cast<std::uint64_t>(count));
    ExpandRun run(GetParam(), 1, "bernoulli", "bursts");
    const LatticeWords lattice = run.random_lattice(random, std::array<int, 3>{5, 5, 4});
    run.send_functions();
    run.send_lattice(lattice);
    const Grid grid = grid_between({0, 0, 0}, {0.875, 1, 0.5}, {count, 3, 1});
    std::vector<Beat> packet = grid_packet(grid, run.page(), kHalves);
    packet.back().last = false;
    packet.resize(packet.size() + 1 + random.below(3));
    packet.back().last = true;
    run.send(packet);
    run.send_grid(grid, kHalves);
    ASSERT_TRUE(run.run());
    EXPECT_EQ(run.pulses(event::kPacketLong), 1U);
    const cores::EventPlace place = run.bench().event_place(stream_event(event::kPacketLong));
    EXPECT_EQ(place.packet, 2U);
    EXPECT_EQ(place.beat, 3U * static_cast<unsigned>(count));
  }
}

TEST_P(Pairs, AResetEndsThem) {
  ExpandRun run(GetParam(), 1);
  for (std::uint64_t round = 0; round < 24; ++round) {
    tb::Random random(round);
    const LatticeWords lattice = run.random_lattice(random, 6);
    run.send_functions();
    run.send_lattice(lattice);
    run.send_grid(grid_between({0, 0, 0}, {1, 1, 1}, {15, 4, 3}), kHalves);
    run.bench().run_for(lattice.points.size() + 30 + random.below(250));
    run.reset();
  }
  tb::Random random(1);
  const LatticeWords lattice = run.random_lattice(random, 6);
  run.send_functions();
  run.send_lattice(lattice);
  run.send_grid(grid_between({0, 0, 0}, {1, 1, 1}, {3, 3, 3}), kHalves);
  ASSERT_TRUE(run.run());
  EXPECT_EQ(run.bench().results().size(), 14U);
}

GTEST_ALLOW_UNINSTANTIATED_PARAMETERIZED_TEST(Pairs);
INSTANTIATE_TEST_SUITE_P(, Pairs, ::testing::ValuesIn(page_builds(takes_pairs)), by_name);

}  // namespace
}  // namespace hwffd::test
