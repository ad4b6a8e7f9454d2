// Rows of vertices along s: what an organization keeps from cell to cell changes no bit, and the
// clocks of a row are those of its vertices or of the planes that it wants, whichever are more.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <numeric>

#include "expand_run.hpp"
#include "hwffd/model/schedule.hpp"
#include "named.hpp"
#include "share.hpp"

namespace hwffd::test {
namespace {

constexpr std::uint64_t kPlaneClocks = 4;
constexpr int kPlanes = 4;  // that a cell has along s

/// Those whose queues hold enough vertices for the clocks of their formula.
bool walks_rows(const PageBuild& build) {
  return walks(find_configuration(build.row)) && build.name.find("small") == std::string::npos;
}

class Walk : public ::testing::TestWithParam<PageBuild> {};

/// Planes that vertices want, one after the other: all of them where anything but s is new.
std::uint64_t planes_of(const std::vector<VertexBeat>& vertices) {
  std::uint64_t planes = kPlanes;
  for (std::size_t v = 1; v < vertices.size(); ++v) {
    const VertexBeat& last = vertices[v - 1];
    const VertexBeat& next = vertices[v];
    bool same = true;
    for (int axis = 1; axis < 3; ++axis) {
      same = same && last.cell[axis] == next.cell[axis] && last.local[axis] == next.local[axis];
    }
    const int further = std::abs(next.cell[0] - last.cell[0]);
    planes += static_cast<std::uint64_t>(same ? std::min(further, kPlanes) : kPlanes);
  }
  return planes;
}

/// A grid of equal rows, of `count` vertices each, whose fastest axis goes anywhere.
Grid grid_of_rows(tb::Random& random, const std::array<int, 3>& dims, int count, int rows) {
  std::array<double, 3> from{}, to{};
  for (int axis = 0; axis < 3; ++axis) {
    const double cells = dims[axis] - 3;
    from[axis] = cells * random.unit();
    to[axis] =
        axis == 0 && random.chance(0.3) ? cells * random.pick({0.0, 1.0}) : cells * random.unit();
  }
  return grid_between(from, to, {count, rows, 1});
}

// Rows of any length, over any number of cells, forwards and backwards: those behind the first few
// follow each other at exactly these clocks.
TEST_P(Walk, ClocksOfRowsEqualTheFormula) {
  tb::Random random(tb::seed_from_environment(1));
  std::size_t by_vertices = 0, by_planes = 0;
  for (std::size_t trial = 0; trial < share_of(60); ++trial) {
    ExpandRun run(GetParam(), trial);
    const LatticeWords lattice = run.random_lattice(random, std::array<int, 3>{16, 16, 5});
    const int count = static_cast<int>(random.between(1, random.chance(0.5) ? 20 : 120));
    const Grid grid = grid_of_rows(random, lattice.dims, count, 24);
    const auto vertices = grid_vertices(grid, lattice.dims, run.codec());
    const auto row = static_cast<std::size_t>(count);
    const std::uint64_t planes = planes_of({vertices.begin(), vertices.begin() + count});
    const std::uint64_t clocks = std::max<std::uint64_t>(row, kPlaneClocks * planes);
    (clocks == row ? by_vertices : by_planes) += 1;
    run.send_bspline();
    run.send_lattice(lattice);
    run.send_grid(grid);
    ASSERT_TRUE(run.run());
    const auto& at = run.bench().result_clocks();
    ASSERT_EQ(at.size(), 24 * row);
    for (std::size_t r = 12; r < 24; ++r) {
      ASSERT_EQ(at[r * row] - at[(r - 1) * row], clocks)
          << "trial " << trial << ", row " << r << " of " << count << " vertices, " << planes
          << " planes";
    }
  }
  EXPECT_GT(by_vertices, 0U);
  EXPECT_GT(by_planes, 0U);
}

// Vertices in any order: from none to five cells further, either way, each of what a row shares
// changed alone; all of them as fast as their planes and no slower, under stalls of either side.
TEST_P(Walk, BitsOfAnyOrder) {
  for (std::uint64_t seed = tb::seed_from_environment(1), last = seed + 3; seed <= last; ++seed) {
    ExpandRun run(GetParam(), seed, seed % 2 == 0 ? "always" : "bursts",
                  seed % 3 == 0 ? "always" : "bernoulli");
    tb::Random random(seed);
    run.send_bspline();
    for (int round = 0; round < 3; ++round) {
      const LatticeWords lattice = run.random_lattice(random, std::array<int, 3>{16, 6, 6});
      std::vector<VertexBeat> vertices(share_of(800));
      for (std::size_t v = 0; v < vertices.size(); ++v) {
        VertexBeat& vertex = vertices[v];
        if (v > 0) vertex = vertices[v - 1];
        vertex.tag = static_cast<std::uint16_t>(v);
        const int by = random.chance(0.5) ? 0 : static_cast<int>(random.between(0, 10)) - 5;
        vertex.cell[0] = std::clamp(vertex.cell[0] + by, 0, lattice.dims[0] - 4);
        vertex.local[0] = run.codec().coordinate(random.unit());
        if (!random.chance(0.1)) continue;
        const auto axis = random.between(1, 2);
        if (random.chance(0.5))
          vertex.local[axis] = run.codec().coordinate(random.unit());
        else
          vertex.cell[axis] = static_cast<int>(random.below(3));
      }
      run.send_lattice(lattice);
      run.send_vertices(vertices);
      if (random.chance(0.5)) run.send_bspline();
    }
    ASSERT_TRUE(run.run());
  }
}

// As many clocks as a long list of vertices asks for, all in all, but for the pipeline's length.
TEST_P(Walk, ClocksOfALongRandomWalk) {
  constexpr std::uint64_t kLength = 200;
  tb::Random random(tb::seed_from_environment(2));
  ExpandRun run(GetParam(), 1);
  const LatticeWords lattice = run.random_lattice(random, std::array<int, 3>{16, 5, 5});
  std::vector<VertexBeat> vertices(share_of(20'000));
  for (std::size_t v = 1; v < vertices.size(); ++v) {
    vertices[v] = vertices[v - 1];
    vertices[v].tag = static_cast<std::uint16_t>(v);
    vertices[v].local[0] = run.codec().coordinate(random.unit());
    if (random.chance(0.5)) {
      const int by = random.chance(0.5) ? 1 : -1;
      vertices[v].cell[0] = std::clamp(vertices[v].cell[0] + by, 0, lattice.dims[0] - 4);
    }
  }
  run.send_bspline();
  run.send_lattice(lattice);
  run.send_vertices(vertices);
  ASSERT_TRUE(run.run());
  const auto& at = run.bench().result_clocks();
  const std::uint64_t planes = kPlaneClocks * planes_of(vertices);
  EXPECT_GE(at.back() - at.front() + kLength, planes);
  EXPECT_LE(at.back() - at.front(), std::max<std::uint64_t>(planes, vertices.size()) + kLength);
}

INSTANTIATE_TEST_SUITE_P(, Walk, ::testing::ValuesIn(page_builds(walks_rows)), by_name);

}  // namespace
}  // namespace hwffd::test
