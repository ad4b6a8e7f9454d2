#include "hwffd/registration/voxel_map.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "errors.hpp"
#include "hwffd/lattice/lattice.hpp"
#include "hwffd/oracle/oracle.hpp"
#include "random_numbers.hpp"

namespace hwffd {
namespace {

VoxelGrid grid_over(const Index3& counts, const Index3& dims) {
  VoxelGrid grid;
  grid.counts = counts;
  grid.dims = dims;
  for (std::size_t a = 0; a < 3; ++a) {
    grid.step[a] = static_cast<double>(dims[a] - 3) / counts[a];
    grid.first[a] = grid.step[a] / 2;
  }
  return grid;
}

Points random_points(const Index3& dims, std::uint64_t seed) {
  RandomNumbers random(seed);
  Points points(dims[0] * dims[1] * dims[2], 3);
  for (Eigen::Index i = 0; i < points.size(); ++i) points.data()[i] = random(-10, 30);
  return points;
}

struct Positions {
  explicit Positions(std::size_t n) : x(n), y(n), z(n) {}
  std::vector<double> x, y, z;
};

/// With rows of one slice in several blocks, several slices in one, and voxels at both ends.
const std::vector<VoxelGrid>& grids() {
  static const std::vector<VoxelGrid> all = [] {
    std::vector<VoxelGrid> result{
        grid_over({20, 15, 12}, {5, 6, 4}), grid_over({7, 300, 9}, {4, 9, 5}),
        grid_over({200, 100, 3}, {10, 5, 4}), grid_over({9, 1, 40}, {5, 4, 9}),
        grid_over({1, 1, 1}, {4, 4, 4})};
    VoxelGrid ends = grid_over({5, 5, 5}, {5, 5, 5});
    ends.first = {0, 0, 0};
    ends.step = {0.5, 0.5, 0.5};
    result.push_back(ends);
    return result;
  }();
  return all;
}

TEST(VoxelMap, BlocksAndSlabsHaveEachVoxelOnce) {
  for (const VoxelGrid& grid : grids()) {
    const auto map = make_reference_map(grid);
    std::map<std::pair<int, int>, int> rows;
    for (const VoxelBlock& block : map->blocks()) {
      EXPECT_TRUE(block.k_end - block.k == 1 || (block.j == 0 && block.j_end == grid.counts[1]));
      for (int k = block.k; k < block.k_end; ++k) {
        for (int j = block.j; j < block.j_end; ++j) ++rows[{k, j}];
      }
      EXPECT_LE(VoxelMap::voxels(grid, block), map->most_voxels());
    }
    EXPECT_EQ(rows.size(), static_cast<std::size_t>(grid.counts[1] * grid.counts[2]));
    for (const auto& row : rows) EXPECT_EQ(row.second, 1);
    std::size_t next = 0;
    for (const VoxelSlab& slab : map->slabs()) {
      EXPECT_EQ(slab.block, next);
      EXPECT_LT(slab.block, slab.block_end);
      next = slab.block_end;
    }
    EXPECT_EQ(next, map->blocks().size());
    EXPECT_LE(map->slabs().size(), 64U);
  }
}

TEST(VoxelMap, PositionsAreThoseOfTheOracle) {
  std::size_t compared = 0;
  for (const VoxelGrid& grid : grids()) {
    const Lattice lattice(grid.dims, random_points(grid.dims, 1));
    const auto map = make_reference_map(grid);
    EXPECT_EQ(map->name(), "reference");
    map->set_points(lattice.points());
    Positions got(map->most_voxels());
    for (const VoxelBlock& block : map->blocks()) {
      map->positions(block, got.x.data(), got.y.data(), got.z.data());
      std::size_t at = 0;
      for (int k = block.k; k < block.k_end; ++k) {
        for (int j = block.j; j < block.j_end; ++j) {
          for (int i = 0; i < grid.counts[0]; ++i, ++at) {
            const Index3 voxel{i, j, k};
            Index3 cell{};
            Eigen::Vector3d local;
            for (std::size_t a = 0; a < 3; ++a) {
              const double x = grid.first[a] + voxel[a] * grid.step[a];
              cell[a] = std::min(static_cast<int>(x), grid.dims[a] - 4);
              local[static_cast<int>(a)] = x - cell[a];
            }
            if ((i + j + k) % 7 != 0) continue;
            const Eigen::Vector3d wanted =
                Oracle().evaluate(lattice.support(cell), local[0], local[1], local[2]);
            ASSERT_LT((Eigen::Vector3d(got.x[at], got.y[at], got.z[at]) - wanted).norm(), 1e-12);
            ++compared;
          }
        }
      }
    }
  }
  EXPECT_GT(compared, 10000U);
}

/// <g, A p> = <A^T g, p>
TEST(VoxelMap, TransposeIsTheTranspose) {
  for (const VoxelGrid& grid : grids()) {
    const Points points = random_points(grid.dims, 2);
    const auto map = make_reference_map(grid);
    map->set_points(points);
    RandomNumbers random(3);
    Points pulled = Points::Zero(points.rows(), 3);
    double forward = 0.0;
    double size = 0.0;
    for (const VoxelSlab& slab : map->slabs()) {
      const auto transpose = map->transpose(slab);
      Positions q(map->most_voxels());
      Positions g(map->most_voxels());
      for (std::size_t b = slab.block; b < slab.block_end; ++b) {
        const VoxelBlock& block = map->blocks()[b];
        map->positions(block, q.x.data(), q.y.data(), q.z.data());
        const std::size_t n = VoxelMap::voxels(grid, block);
        for (std::size_t i = 0; i < n; ++i) {
          g.x[i] = random(-1, 1);
          g.y[i] = random(-1, 1);
          g.z[i] = random(-1, 1);
          const double term = g.x[i] * q.x[i] + g.y[i] * q.y[i] + g.z[i] * q.z[i];
          forward += term;
          size += std::abs(term);
        }
        transpose->add(block, g.x.data(), g.y.data(), g.z.data());
      }
      SlabSums sums(grid.dims, slab);
      transpose->finish(sums);
      sums.add_to(pulled);
    }
    EXPECT_NEAR(pulled.cwiseProduct(points).sum(), forward, 1e-13 * size);
    EXPECT_GT(std::abs(forward), 1e-6 * size);
  }
}

/// One voxel's gradient goes to the 64 points of its cell, and no other.
TEST(VoxelMap, TransposeOfOneVoxel) {
  const VoxelGrid grid = grid_over({20, 15, 12}, {5, 6, 4});
  const auto map = make_reference_map(grid);
  Points pulled = Points::Zero(5 * 6 * 4, 3);
  for (const VoxelSlab& slab : map->slabs()) {
    const auto transpose = map->transpose(slab);
    for (std::size_t b = slab.block; b < slab.block_end; ++b) {
      const VoxelBlock& block = map->blocks()[b];
      Positions g(map->most_voxels());
      if (block.k <= 7 && 7 < block.k_end) {
        const int voxel = (7 - block.k) * 300 + 13 * 20 + 4;
        g.y[static_cast<std::size_t>(voxel)] = 2.0;
      }
      transpose->add(block, g.x.data(), g.y.data(), g.z.data());
    }
    SlabSums sums(grid.dims, slab);
    transpose->finish(sums);
    sums.add_to(pulled);
  }
  const Eigen::Vector3d local(0.45, 0.7, 7.5 / 12);  // of cell (0, 2, 0)
  const Support wanted = Oracle().pull_back({0, 2, 0}, local);
  for (const Index3& at : places(grid.dims)) {
    const Eigen::Index row = (at[0] * 6 + at[1]) * 4 + at[2];
    Eigen::RowVector3d expected = Eigen::RowVector3d::Zero();
    if (at[0] < 4 && at[1] >= 2) expected = wanted.row((at[0] * 4 + at[1] - 2) * 4 + at[2]);
    EXPECT_LT((pulled.row(row) - expected).norm(), 1e-15);
  }
}

TEST(VoxelMap, SlabSumsHoldLayers) {
  const Index3 dims{4, 5, 6};
  SlabSums sums(dims, VoxelSlab{0, 1, 2, 5});
  Points all(120, 3);
  for (Eigen::Index i = 0; i < all.size(); ++i) all.data()[i] = static_cast<double>(i);
  sums.add(all);
  sums.add(all);
  EXPECT_EQ(sums.layer(1, 3)[2 * 4 + 1], 2 * all((1 * 5 + 2) * 6 + 3, 1));
  Points back = Points::Zero(120, 3);
  sums.add_to(back);
  for (const Index3& at : places(dims)) {
    const Eigen::Index row = (at[0] * 5 + at[1]) * 6 + at[2];
    const bool held = at[2] >= 2 && at[2] < 5;
    EXPECT_EQ(back.row(row), (held ? 2 : 0) * all.row(row));
  }
}

TEST(VoxelMap, RefusesVoxelsBeyondTheCells) {
  VoxelGrid grid = grid_over({8, 8, 8}, {5, 5, 5});
  grid.first[1] = -0.25;
  EXPECT_ERROR(make_reference_map(grid),
               "voxels along axis j: 8 from -0.25 on, 0.25 cells apart, are not in 2 cells; give a "
               "lattice over all of the fixed image");
  grid = grid_over({8, 8, 8}, {5, 5, 5});
  grid.step[2] = 0.3;
  EXPECT_ERROR(make_reference_map(grid),
               "voxels along axis k: 8 from 0.125 on, 0.3 cells apart, are not in 2 cells; give a "
               "lattice over all of the fixed image");
}

}  // namespace
}  // namespace hwffd
