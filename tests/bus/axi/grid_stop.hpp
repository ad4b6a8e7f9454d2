#pragma once

#include <gtest/gtest.h>

#include <cstddef>
#include <cstdint>

#include "axi_run.hpp"
#include "hwffd/stream/grid.hpp"

namespace hwffd::test {

/// Where the lattice of a grid is: in a page, or resident in a core without pages.
enum class GridStore { kResident, kPage };

/// A grid that CONTROL.stop_grid stopped, or did not.
struct GridStop {
  std::size_t vertices = 0;  ///< that the grid made
  std::size_t before = 0;    ///< of them in memory when the stop was written
  std::uint64_t clocks = 0;  ///< from there to the end of the run
  bool stopped = false;      ///< it has fewer vertices than it asked for
};

/// Vertices that come behind the grid.
inline constexpr std::size_t kBehindGrid = 7;

/// Runs functions, a lattice, a grid of it and vertices of it, and stops the grid so many clocks
/// after the start. The results must be those of the vertices that the grid made, sent one by one,
/// and of what is behind it; the one event that of a stopped grid, at the vertex that was its last;
/// and the core idle, with all its vertices counted.
::testing::AssertionResult stop_grid_at(AxiRun& run, GridStore store, const Grid& grid,
                                        std::uint64_t clock, GridStop& stop);

}  // namespace hwffd::test
