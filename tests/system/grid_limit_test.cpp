// Grids in a core that makes so many vertices of one at most: a longer one is refused whole.
#include <gtest/gtest.h>

#include "expand_run.hpp"
#include "named.hpp"
#include "share.hpp"

namespace hwffd::test {
namespace {

constexpr std::size_t kAffordable = 300;  // vertices of a grid that is not refused

class GridLimit : public ::testing::TestWithParam<PageBuild> {
 protected:
  std::size_t most() const { return std::size_t{1} << GetParam().core.grid_limit; }
};

/// A grid of so many vertices, all of them at one place.
Grid grid_of(const std::array<std::uint64_t, 3>& counts) {
  Grid grid;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    grid.start[axis] = std::uint64_t{1} << (kGridFraction - 1 - axis);
    grid.count[axis] = static_cast<std::uint16_t>(counts[axis]);
  }
  return grid;
}

// Counts whose product is at the limit, near to it and far beyond, with any factors; the grids
// between those that are refused have the bits of the model.
TEST_P(GridLimit, LongerGridsAreRefusedWhole) {
  tb::Random random(tb::seed_from_environment(1));
  constexpr std::uint64_t kMost = 65'535;
  std::size_t longer = 0, others = 0;
  ExpandRun run(GetParam(), 1, "bernoulli", "bursts");
  run.send_bspline();
  run.send_lattice(run.random_lattice(random, 6));
  const auto send = [&](const std::array<std::uint64_t, 3>& counts) {
    const Grid grid = grid_of(counts);
    const std::size_t count = vertex_count(grid);
    if (count <= most() && count > kAffordable) return;
    (count > most() ? longer : others) += 1;
    run.send_grid(grid);
  };
  for (std::size_t trial = 0; trial < share_of(400); ++trial) {
    std::array<std::uint64_t, 3> counts;
    for (std::uint64_t& count : counts)
      count = random.between(1, random.pick({1, 2, 8, 70, 600, 65'535}));
    send(counts);
    // As near to the limit as these two allow.
    const std::size_t axis = random.below(3);
    const std::uint64_t others_count = counts[(axis + 1) % 3] * counts[(axis + 2) % 3];
    for (const std::uint64_t more : {0, 1}) {
      counts[axis] = most() / others_count + more;
      if (counts[axis] >= 1 && counts[axis] <= kMost) send(counts);
    }
  }
  send({kMost, kMost, kMost});
  ASSERT_TRUE(run.run());
  EXPECT_EQ(run.pulses(event::kGridCount), longer);
  EXPECT_GT(longer, 0U);
  EXPECT_GT(others, 0U);
}

INSTANTIATE_TEST_SUITE_P(, GridLimit, ::testing::ValuesIn(page_builds()), by_name);

}  // namespace
}  // namespace hwffd::test
