// Grids: the core makes the vertices, and gives the bits of the same vertices sent one by one.
#include <gtest/gtest.h>

#include <algorithm>
#include <memory>
#include <string>

#include "bad_packets.hpp"
#include "expand_run.hpp"
#include "grid_stop.hpp"
#include "hwffd/model/schedule.hpp"
#include "hwffd/stream/halves.hpp"
#include "named.hpp"
#include "share.hpp"

namespace hwffd::test {
namespace {

constexpr std::uint64_t kCell = std::uint64_t{1} << kGridFraction;
constexpr std::uint64_t kUnit = kCell >> kGridCoordinate;

class Grids : public ::testing::TestWithParam<PageBuild> {};

std::size_t vertices_of(const Grid& grid) {
  return std::size_t{1} * grid.count[0] * grid.count[1] * grid.count[2];
}

/// A grid of one vertex an axis at a place, for changes.
Grid still(const std::array<std::uint64_t, 3>& start) {
  Grid grid;
  grid.start = start;
  grid.count = {1, 1, 1};
  return grid;
}

TEST_P(Grids, AreTheVerticesSentOneByOne) {
  for (std::uint64_t seed = tb::seed_from_environment(1), last = seed + 3; seed <= last; ++seed) {
    ExpandRun run(GetParam(), seed, seed % 2 == 0 ? "always" : "bursts",
                  seed % 3 == 0 ? "always" : "bernoulli");
    tb::Random random(seed);
    run.send_functions();
    std::vector<std::size_t> counts;
    for (int round = 0; round < 3; ++round) {
      const LatticeWords lattice = run.random_lattice(random, 8);
      run.send_lattice(lattice);
      for (int some = 0; some < 4; ++some) {
        const PageVertices how = run.random_flags(random, lattice);
        const Grid grid = random_grid(random, lattice.dims, 5);
        run.send_grid(grid, how);
        run.send_vertices(grid_vertices(grid, lattice.dims, run.codec()), how);
        counts.push_back(run.results(vertices_of(grid), how));
      }
    }
    ASSERT_TRUE(run.run());
    ASSERT_TRUE(run.twice(counts));
    for (unsigned e = 0; e < kStreamEvents; ++e) {
      EXPECT_TRUE(e == kSaturated || run.bench().events()[e] == 0) << "event " << e;
    }
  }
}

// What is expected here is made by hand, in halves of a cell: a vertex on a face between cells is
// in the upper one at 0, on the last face in the last cell at 1.
TEST_P(Grids, GoAcrossCellsToTheLastFace) {
  tb::Random random(2);
  ExpandRun run(GetParam(), 1);
  const LatticeWords lattice = run.random_lattice(random, std::array<int, 3>{5, 4, 6});
  const std::array<int, 3> cells = {2, 1, 3};
  Grid grid;
  std::vector<VertexBeat> vertices;
  for (int axis = 0; axis < 3; ++axis) {
    grid.count[axis] = static_cast<std::uint16_t>(2 * cells[axis] + 1);
    grid.step[axis] = kCell / 2;
  }
  grid.tag = 0xFFF0;
  for (int c = 0; c <= 2 * cells[2]; ++c) {
    for (int b = 0; b <= 2 * cells[1]; ++b) {
      for (int a = 0; a <= 2 * cells[0]; ++a) {
        VertexBeat vertex;
        vertex.tag = static_cast<std::uint16_t>(grid.tag + vertices.size());
        const std::array<int, 3> at = {a, b, c};
        for (int axis = 0; axis < 3; ++axis) {
          const bool face = at[axis] == 2 * cells[axis];
          vertex.cell[axis] = face ? cells[axis] - 1 : at[axis] / 2;
          vertex.local[axis] = run.codec().coordinate(face ? 1.0 : 0.5 * (at[axis] % 2));
        }
        vertices.push_back(vertex);
      }
    }
  }
  // And the same backwards along all axes.
  Grid back = grid;
  for (int axis = 0; axis < 3; ++axis) {
    back.start[axis] = kCell * static_cast<std::uint64_t>(cells[axis]);
    back.step[axis] = -grid.step[axis];
  }
  std::vector<VertexBeat> turned(vertices.rbegin(), vertices.rend());
  for (std::size_t v = 0; v < turned.size(); ++v) turned[v].tag = vertices[v].tag;
  run.send_bspline();
  run.send_lattice(lattice);
  run.send_grid(grid);
  run.send_vertices(vertices);
  run.send_grid(back);
  run.send_vertices(turned);
  ASSERT_TRUE(run.run());
  const std::size_t count = vertices.size();
  EXPECT_TRUE(run.same(0, count, count));
  EXPECT_TRUE(run.same(2 * count, 3 * count, count));
  EXPECT_EQ(run.bench().results()[count - 1].words[3] & kTagMask, (0xFFF0 + count - 1) & kTagMask);
}

// A third of a cell has no end in binary: the sum keeps all bits of its step, so that none of the
// places beside a face is cut to the wrong side, and the last vertex is where it was asked for.
TEST_P(Grids, DoNotDrift) {
  tb::Random random(3);
  ExpandRun run(GetParam(), 1);
  const LatticeWords lattice = run.random_lattice(random, std::array<int, 3>{8, 4, 4});
  constexpr int kSteps = 15;  // three a cell
  const Grid grid = grid_between({0, 0, 0}, {5, 0, 0}, {kSteps + 1, 1, 1});
  std::vector<VertexBeat> vertices(kSteps + 1);
  for (int n = 0; n <= kSteps; ++n) {
    const int cell = std::min(n / 3, 4);
    const double whole = std::nearbyint(std::ldexp((n - 3 * cell) / 3.0, kGridCoordinate));
    vertices[n].cell[0] = cell;
    vertices[n].local[0] = run.codec().coordinate(std::ldexp(whole, -kGridCoordinate));
    vertices[n].tag = static_cast<std::uint16_t>(n);
  }
  run.send_bspline();
  run.send_lattice(lattice);
  run.send_grid(grid);
  run.send_vertices(vertices);
  ASSERT_TRUE(run.run());
  EXPECT_TRUE(run.same(0, kSteps + 1, kSteps + 1));
}

// The ends of the longest axes, cells of all their bits.
TEST_P(Grids, RunAlongTheLongestAxes) {
  tb::Random random(4);
  ExpandRun run(GetParam(), 1, "always", "bernoulli");
  run.send_bspline();
  const int points = run.axis_points();
  for (int axis = 0; axis < 3; ++axis) {
    std::array<int, 3> dims = {4, 4, 4};
    dims[axis] = points;
    Grid grid = still({kCell / 3, kCell / 5, kCell / 7});
    grid.start[axis] = kCell / 2;
    grid.count[axis] = static_cast<std::uint16_t>(points - 3);
    grid.step[axis] = kCell;
    PageVertices how;
    how.large = points > kSmallAxisPoints;
    const LatticeWords lattice = run.random_lattice(random, dims);
    run.send_lattice(lattice);
    run.send_grid(grid, how);
    run.send_vertices(grid_vertices(grid, dims, run.codec()), how);
  }
  ASSERT_TRUE(run.run());
  const auto count = static_cast<std::size_t>(points - 3);
  for (std::size_t axis = 0; axis < 3; ++axis) {
    EXPECT_TRUE(run.same(2 * axis * count, (2 * axis + 1) * count, count));
  }
}

/// A bad grid, its event, and how many results it has.
struct BadGrid {
  const char* name;
  std::vector<Beat> packet;
  Code code;
  std::size_t results = 0;
};

class BadGrids : public Grids {
 protected:
  void add(const char* name, const Grid& grid, Code code = kGridCount, std::size_t results = 0) {
    bad_.push_back({name, grid_packet(grid, run_.page()), code, results});
  }
  void add_header(const char* name, int word, std::uint32_t bits) {
    std::vector<Beat> packet = grid_packet(good_, run_.page());
    packet[0].words[word] ^= bits;
    bad_.push_back({name, packet, kUnknownOpcode});
  }
  void add_beats(const char* name, std::size_t beats, Code code, std::size_t results = 0) {
    std::vector<Beat> packet = grid_packet(good_, run_.page());
    packet.back().last = false;
    packet.resize(beats);
    packet.back().last = true;
    bad_.push_back({name, packet, code, results});
  }
  void add_places() {
    for (int axis = 0; axis < 3; ++axis) {
      const std::uint64_t end = kCell * static_cast<std::uint64_t>(dims_[axis] - 3);
      const auto changed = [&](auto change) {
        Grid grid = good_;
        change(grid);
        return grid;
      };
      add("no vertex", changed([&](Grid& g) { g.count[axis] = 0; }));
      add("a start a unit behind the end", changed([&](Grid& g) { g.start[axis] = end + kUnit; }));
      add("a start with bit 63",
          changed([&](Grid& g) { g.start[axis] |= std::uint64_t{1} << 63; }));
      add("an end a unit behind the end", changed([&](Grid& g) {
            g.start[axis] = end - 3 * kCell / 8 + kUnit;
            g.step[axis] = kCell / 8;
            g.count[axis] = 4;
          }));
      add("an end a step below 0", changed([&](Grid& g) {
            g.start[axis] = 3 * kCell / 8 - 1;
            g.step[axis] = -static_cast<std::int64_t>(kCell / 8);
            g.count[axis] = 4;
          }));
      add("an end that is inside modulo 2^64", changed([&](Grid& g) {
            g.start[axis] = 0;
            g.step[axis] = std::int64_t{1} << 62;
            g.count[axis] = 5;
          }));
      add("an end that is inside modulo 2^47", changed([&](Grid& g) {
            g.start[axis] = 0;
            g.step[axis] = std::int64_t{1} << 43;
            g.count[axis] = 17;
          }));
      add("a step of half a cell, 65535 times", changed([&](Grid& g) {
            g.start[axis] = 0;
            g.step[axis] = kCell / 2;
            g.count[axis] = 65535;
          }));
    }
  }
  /// What looks bad and is not.
  void add_good() {
    for (int axis = 0; axis < 3; ++axis) {
      Grid grid = good_;
      const std::uint64_t end = kCell * static_cast<std::uint64_t>(dims_[axis] - 3);
      grid.start[axis] = end - 3 * kCell / 8 + kUnit - 1;  // cut to the last face
      grid.step[axis] = kCell / 8;
      grid.count[axis] = 4;
      add("an end less than a unit behind the end", grid, kUnknownOpcode,
          4 * vertices_of(good_) / good_.count[axis]);
      grid.start[axis] = 0;
      grid.count[axis] = 1;
      grid.step[axis] = std::int64_t{1} << 62;
      add("a step that is not taken", grid, kUnknownOpcode, vertices_of(good_) / good_.count[axis]);
    }
  }

  ExpandRun run_{GetParam(), 1, "bernoulli", "bursts"};
  tb::Random random_{5};
  const std::array<int, 3> dims_ = {5, 4, 6};
  const Grid good_ = grid_between({0.25, 0.5, 2.5}, {1.75, 0.25, 0}, {2, 2, 2}, 7);
  std::vector<BadGrid> bad_;
};

// Events and results do not come from the model; that the packets behind are exact does.
TEST_P(BadGrids, AreRefusedWhole) {
  add_places();
  for (std::size_t beats = 1; beats < 4; ++beats) add_beats("too short", beats, kPacketShort);
  for (std::size_t beats = 5; beats < 8; ++beats) add_beats("too long", beats, kPacketLong, 8);
  add_header("E", 0, kEveryFlag);
  add_header("P", 0, kPackedFlag);
  add_header("an unknown flag", 0, 1U << 23);
  add_header("a mode", 2, 1);
  add_header("a bit of word 2", 2, 1U << 16);
  if (!run_.has(model::kPagesFeature)) add_header("a page", 0, 1U << 8);
  if (!run_.has(model::kFourthFeature)) add_header("Q", 0, kFourthFlag);
  if (!run_.has(model::kLargeFeature)) add_header("L", 0, kLargeFlag);
  if (!run_.has(model::kMarksFeature)) add_header("R", 0, kCountFlag);
  if (!run_.has(model::kHalvesFeature)) add_header("H", 0, kHalfFlag);
  if (!run_.has(model::kDerivativesFeature)) add_header("derivatives", 2, 1U << 8);
  if (!run_.has(model::kDeterminantFeature)) add_header("det J alone", 2, 3U << 8);
  const std::size_t bad = bad_.size();
  add_good();
  for (std::size_t b = 0; b < bad_.size(); ++b) {
    SCOPED_TRACE(bad_[b].name);
    ExpandRun run(GetParam(), 1, "bernoulli", "bursts");
    const LatticeWords lattice = run.random_lattice(random_, dims_);
    run.send_bspline();
    run.send_lattice(lattice);
    run.send_grid(good_);
    run.send(bad_[b].packet);
    run.send_grid(good_);
    run.send_vertices(grid_vertices(good_, dims_, run.codec()));
    ASSERT_TRUE(run.run());
    for (unsigned e = 0; e < kStreamEvents; ++e) {
      const bool expected = b < bad && e == stream_event(bad_[b].code);
      EXPECT_EQ(run.bench().events()[e], expected ? 1U : 0U) << "event " << e;
    }
    const std::size_t first = 8 + bad_[b].results;
    EXPECT_EQ(run.bench().results().size(), first + 16);
    EXPECT_TRUE(run.same(0, first, 8));
    EXPECT_TRUE(run.same(first, first + 8, 8));
  }
}

// One that comes while vertices before it still wait for the evaluator.
TEST_P(BadGrids, WaitBehindVertices) {
  run_.send_bspline();
  run_.send_lattice(run_.random_lattice(random_, dims_));
  constexpr std::size_t kMany = 6 * 6 * 6;
  const Grid many = grid_between({0, 0, 0}, {2, 1, 3}, {6, 6, 6});
  add_beats("too short", 3, kPacketShort);
  for (int round = 0; round < 3; ++round) {
    run_.send_grid(many);
    run_.send(bad_[0].packet);
    run_.send_grid(many);
  }
  ASSERT_TRUE(run_.run());
  EXPECT_EQ(run_.pulses(kPacketShort), 3U);
  EXPECT_EQ(run_.bench().results().size(), 6 * kMany);
  for (std::size_t grid = 1; grid < 6; ++grid) EXPECT_TRUE(run_.same(0, grid * kMany, kMany));
}

TEST_P(BadGrids, NothingLoaded) {
  run_.send_grid(good_);
  run_.send_bspline();
  run_.send_grid(good_);
  run_.send_lattice(run_.random_lattice(random_, dims_));
  run_.send_grid(good_);
  ASSERT_TRUE(run_.run());
  EXPECT_EQ(run_.bench().results().size(), 8U);
  EXPECT_EQ(run_.pulses(kGridCount), 2U);
  // Without functions its vertices are blank, as any are.
  run_.reset();
  const LatticeWords lattice = run_.random_lattice(random_, dims_);
  run_.send_lattice(lattice);
  run_.send_grid(good_);
  ASSERT_TRUE(run_.run());
  EXPECT_EQ(run_.pulses(kNoCoefficients), 8U);
  for (const Beat& result : run_.bench().results()) {
    EXPECT_NE(result.words[3] & kStatusUnloaded, 0U);
  }
}

// Without L a cell beyond the 32nd has no name; the face that ends it has.
TEST_P(BadGrids, CellsThatHaveNoName) {
  if (run_.axis_points() <= kSmallAxisPoints) GTEST_SKIP() << "no such cells";
  const std::array<int, 3> dims = {40, 4, 4};
  Grid grid = still({kCell * 31, 0, 0});
  grid.count[0] = 2;
  grid.step[0] = kCell - kUnit;
  run_.send_bspline();
  run_.send_lattice(run_.random_lattice(random_, dims));
  run_.send_grid(grid);
  grid.step[0] = kCell;
  run_.send_grid(grid);
  run_.send_lattice(run_.random_lattice(random_, std::array<int, 3>{35, 4, 4}));
  run_.send_grid(grid);
  ASSERT_TRUE(run_.run());
  EXPECT_EQ(run_.bench().results().size(), 4U);
  EXPECT_EQ(run_.pulses(kGridCount), 1U);
}

// Clocks: at the rate of the organization (of rows along s, tests/system/walk_test.cpp); and a grid
// begins as soon as it is checked.
TEST_P(Grids, ClocksOfAGrid) {
  tb::Random random(6);
  ExpandRun run(GetParam(), 1);
  const LatticeWords lattice = run.random_lattice(random, std::array<int, 3>{8, 8, 8});
  const Grid grid = grid_between({0, 0, 0}, {2.75, 5, 5}, {12, 4, 3});
  const std::size_t count = vertices_of(grid);
  run.send_bspline();
  run.send_lattice(lattice);
  run.send_vertices(random_vertices(run.codec(), random, lattice.dims, 1));
  ASSERT_TRUE(run.run());
  run.send_grid(grid);
  ASSERT_TRUE(run.run());
  if (!walks(run.row())) {
    EXPECT_EQ(run.bench().clocks_per_result(count - 104, count), expected_interval(run.row()));
  }
  const auto latency = [&](std::size_t beat, std::size_t result) {
    return run.bench().result_clocks()[result] - run.bench().accept_clocks()[beat];
  };
  const std::size_t single = run.sent() - 5;
  const std::uint64_t more = latency(single + 4, 1) - latency(single, 0);
  EXPECT_LE(more, 22 + static_cast<std::uint64_t>(expected_interval(run.row())) - 1);
}

TEST_P(Grids, AResetEndsThem) {
  ExpandRun run(GetParam(), 1);
  for (std::uint64_t round = 0; round < 12; ++round) {
    tb::Random random(round);
    const LatticeWords lattice = run.random_lattice(random, 6);
    run.send_bspline();
    run.send_lattice(lattice);
    run.send_grid(grid_between({0, 0, 0}, {1, 1, 1}, {5, 4, 3}));
    run.bench().run_for(lattice.points.size() + 20 + random.below(150));
    run.reset();
  }
  tb::Random random(1);
  const LatticeWords lattice = run.random_lattice(random, 6);
  run.send_bspline();
  run.send_lattice(lattice);
  run.send_grid(grid_between({0, 0, 0}, {1, 1, 1}, {2, 2, 2}));
  ASSERT_TRUE(run.run());
  EXPECT_EQ(run.bench().results().size(), 8U);
}

// A stopped grid has the results of its first vertices, the last of them with tlast and event 13,
// and what follows is as if no more had been asked for. In any other clock the pin does nothing.
TEST_P(Grids, AStopEndsThem) {
  std::size_t stops = 0, wholes = 0;
  for (std::uint64_t round = 0; round < share_of(40); ++round) {
    SCOPED_TRACE(round);
    tb::Random random(round);
    ExpandRun run(GetParam(), round);
    const LatticeWords lattice = run.random_lattice(random, 5);
    const std::vector<Grid> grids = {grid_between({0, 0, 0}, {1, 1, 1}, {5, 4, 3}),
                                     grid_between({0, 0, 0}, {1, 1, 1}, {2, 2, 2})};
    std::vector<Beat> sent =
        coefficients_packet(watertight_bspline(run.codec()), run.codec(), Functions::kBlending);
    append(sent, run.packet_of(lattice));
    std::vector<Beat> wanted = sent;
    const auto interval = static_cast<std::uint64_t>(expected_interval(run.row()));
    const std::uint64_t at = sent.size() + random.below(100 + 2 * vertices_of(grids[0]) * interval);
    PageVertices how;
    how.half = run.has(model::kHalvesFeature) && round % 2 == 1;
    for (const Grid& grid : grids) append(sent, grid_packet(grid, run.page(), how));
    const std::unique_ptr<cores::StreamCore> core = GetParam().make(round);
    const Stopped out = stopped_at(*core, random, sent, at);

    std::size_t stopped = 0;
    auto begin = out.results.begin();
    for (const Grid& grid : grids) {
      const auto last =
          std::find_if(begin, out.results.end(), [](const Beat& beat) { return beat.last; });
      ASSERT_NE(last, out.results.end());
      std::vector<VertexBeat> vertices = grid_vertices(grid, lattice.dims, run.codec());
      const std::vector<Beat> results(begin, last + 1);
      const auto made = how.half ? halves_of(results).size() : results.size();
      ASSERT_LE(made, vertices.size());
      (made < vertices.size() ? stopped : wholes) += 1;
      vertices.resize(made);
      append(wanted, run.packet_of(vertices, how));
      begin = last + 1;
    }
    EXPECT_EQ(out.refusals, stopped);
    EXPECT_TRUE(out.results == run.model_of(wanted));
    stops += stopped;
  }
  EXPECT_GT(stops, 0U);
  EXPECT_GT(wholes, 0U);
}

INSTANTIATE_TEST_SUITE_P(, Grids, ::testing::ValuesIn(page_builds()), by_name);
INSTANTIATE_TEST_SUITE_P(, BadGrids, ::testing::ValuesIn(page_builds()), by_name);

}  // namespace
}  // namespace hwffd::test
