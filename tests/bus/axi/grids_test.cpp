// Grids behind a bus: a register stops the one that is under way, LIMITS says how long they may be.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include "expand_stimulus.hpp"
#include "grid_stop.hpp"
#include "marks_core.hpp"

namespace hwffd::test {
namespace {

constexpr std::uint64_t kInterval = 64;  // clocks of a vertex of basic-fx18-overlapped

class AxiGrids : public testing::TestWithParam<std::string> {
 protected:
  AxiRun run_ = marks_run(GetParam());
};
INSTANTIATE_TEST_SUITE_P(, AxiGrids, testing::Values("always", "mixed", "bernoulli"),
                         [](const auto& name) { return name.param; });

/// At any moment from the start on, before the grid and behind it, too.
TEST_P(AxiGrids, AStopEndsThemAtAnyMoment) {
  constexpr int kRounds = 16;
  const Grid grid = grid_between({0, 0, 0}, {1, 1, 1}, {5, 4, 3});
  int stops = 0;
  std::size_t vertices = 0;
  for (int round = 0; round < kRounds; ++round) {
    GridStop stop;
    const std::uint64_t clock = run_.random().below(kInterval * (vertex_count(grid) + 30));
    ASSERT_TRUE(stop_grid_at(run_, GridStore::kPage, grid, clock, stop)) << clock;
    stops += stop.stopped ? 1 : 0;
    vertices += stop.vertices;
  }
  EXPECT_GT(stops, 0);
  EXPECT_LT(stops, kRounds);
  fmt::print("{} of {} grids stopped, {} vertices compared\n", stops, kRounds, vertices);
  EXPECT_TRUE(run_.ends_well());
}

/// The longest grid that the core takes ends with what was inside it: the vertices that wait, those
/// that are evaluated, and a few between the grid and them.
TEST_P(AxiGrids, TheLongestEndsWithWhatIsInside) {
  const Grid grid = grid_between({0, 0, 0}, {1, 1, 1}, {16, 8, 8});
  ASSERT_EQ(vertex_count(grid), std::size_t{1} << marks_core().grid_limit);
  constexpr std::size_t kWaiting = 16, kBetween = 4;
  const std::size_t inside = run_.driver().probe().in_flight + kWaiting + kBetween;
  GridStop stop;
  ASSERT_TRUE(stop_grid_at(run_, GridStore::kPage, grid, 100 * kInterval, stop));
  EXPECT_TRUE(stop.stopped);
  EXPECT_GT(stop.before, 50U);
  EXPECT_LE(stop.vertices, stop.before + inside);
  EXPECT_LE(stop.clocks, (inside + kBehindGrid + 5) * kInterval);
  fmt::print("{} results before the stop, {} vertices, {} clocks from stop to end\n", stop.before,
             stop.vertices, stop.clocks);
  EXPECT_TRUE(run_.ends_well());
}

/// In an idle core, in the very write of a start, before a grid and between vertices.
TEST_P(AxiGrids, AStopWithoutAGridDoesNothing) {
  const Grid grid = grid_between({0, 0, 0}, {1, 1, 1}, {3, 2, 2});
  const auto scene = [&](std::size_t vertices) {
    run_.send_bspline();
    const LatticeWords lattice = random_lattice(run_.codec(), run_.random(), 5);
    run_.send(page_packet(1, lattice));
    run_.send(page_vertices_packet(
        1, random_vertices(run_.codec(), run_.random(), lattice.dims, vertices)));
  };
  run_.driver().stop_grid();
  scene(30);
  run_.start();
  int stops = 0;
  for (; (run_.system().read32(HWFFD_STATUS_OFFSET) & HWFFD_STATUS_DONE_MASK) == 0; ++stops) {
    run_.driver().stop_grid();
    run_.system().run(20);
  }
  EXPECT_GT(stops, 50);
  ASSERT_TRUE(run_.finish());
  run_.driver().stop_grid();
  run_.send(grid_packet(grid, 1));
  ASSERT_TRUE(run_.go());

  scene(1);
  run_.send(grid_packet(grid, 1));
  run_.start(run_.expected().size(),
             [&] { run_.system().write32(HWFFD_CONTROL_OFFSET, HWFFD_CONTROL_STOP_GRID_MASK); });
  ASSERT_TRUE(run_.finish());

  run_.system().write32(HWFFD_CONTROL_OFFSET,
                        HWFFD_CONTROL_SOFT_RESET_MASK | HWFFD_CONTROL_STOP_GRID_MASK);
  ASSERT_TRUE(run_.soft_reset());
  scene(2);
  run_.send(grid_packet(grid, 1));
  ASSERT_TRUE(run_.go());
  EXPECT_EQ(run_.checked(), 30U + 1 + 2 + 3 * vertex_count(grid));
  EXPECT_EQ(run_.driver().take_errors().status & 1U << kGridCount, 0U);
  EXPECT_EQ(run_.system().read32(HWFFD_CONTROL_OFFSET), 0U);
  EXPECT_TRUE(run_.ends_well());
}

/// 41 x 25 vertices are one more than 2^10: the driver refuses them, and so does the core.
TEST_P(AxiGrids, LongerOnesThanTheLimitAreRefused) {
  EXPECT_EQ(run_.driver().probe().grid_limit, 10U);
  const std::vector<Beat> most = grid_packet(grid_between({0, 0, 0}, {1, 1, 1}, {16, 16, 4}), 1);
  const std::vector<Beat> more = grid_packet(grid_between({0, 0, 0}, {1, 1, 0}, {41, 25, 1}), 1);
  EXPECT_NO_THROW(run_.driver().check(most.front().words));
  EXPECT_THROW(run_.driver().check(more.front().words), DriverError);
  LatticeWords lattice = random_lattice(run_.codec(), run_.random(), 5);
  run_.send_bspline();
  run_.send(page_packet(1, lattice));
  run_.send(more);
  run_.send(most);
  ASSERT_TRUE(run_.go());
  EXPECT_EQ(run_.checked(), 1024U);
  EXPECT_EQ(run_.model().events()[stream_event(kGridCount)], 1U);
  FirstError first;
  first.code = kGridCount;
  first.packet = 2;
  first.beat = 1;
  EXPECT_TRUE(run_.only_error(first));
  EXPECT_TRUE(run_.clean());
}

}  // namespace
}  // namespace hwffd::test
