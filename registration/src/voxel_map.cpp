#include "hwffd/registration/voxel_map.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "axis_weights.hpp"
#include "hwffd/error.hpp"
#include "hwffd/lattice/lattice.hpp"

namespace hwffd {
namespace {

// Places and gradients of four times as many fit the second cache of a core.
constexpr std::size_t kVoxelsABlock = 4096;
constexpr std::size_t kMostSlabs = 64;

std::vector<VoxelBlock> blocks_of(const Index3& counts, std::size_t voxels) {
  const auto row = static_cast<std::size_t>(counts[0]);
  const std::size_t slice = row * static_cast<std::size_t>(counts[1]);
  const auto at_once = [](std::size_t some, int count) {
    return static_cast<int>(std::clamp<std::size_t>(some, 1, static_cast<std::size_t>(count)));
  };
  const int slices = at_once(voxels / slice, counts[2]);
  const int rows = slice <= 4 * voxels ? counts[1] : at_once(4 * voxels / row, counts[1]);
  std::vector<VoxelBlock> result;
  for (int k = 0; k < counts[2]; k += slices) {
    for (int j = 0; j < counts[1]; j += rows) {
      result.push_back({j, std::min(counts[1], j + rows), k, std::min(counts[2], k + slices)});
    }
  }
  return result;
}

}  // namespace

SlabSums::SlabSums(const Index3& dims, const VoxelSlab& slab)
    : dims_(dims),
      layer_(slab.layer),
      layer_end_(slab.layer_end),
      sums_(static_cast<std::size_t>(3 * (slab.layer_end - slab.layer)) *
            static_cast<std::size_t>(dims[0] * dims[1])) {}

const double* SlabSums::layer(int component, int k) const {
  return sums_.data() + static_cast<std::size_t>(component * (layer_end_ - layer_) + k - layer_) *
                            static_cast<std::size_t>(dims_[0] * dims_[1]);
}

double* SlabSums::layer(int component, int k) {
  return const_cast<double*>(static_cast<const SlabSums*>(this)->layer(component, k));
}

void SlabSums::add_to(Points& all) const {
  for (int c = 0; c < 3; ++c) {
    for (int k = layer_; k < layer_end_; ++k) {
      const double* from = layer(c, k);
      for (int j = 0; j < dims_[1]; ++j) {
        for (int i = 0; i < dims_[0]; ++i) {
          all((static_cast<Eigen::Index>(i) * dims_[1] + j) * dims_[2] + k, c) += *from++;
        }
      }
    }
  }
}

void SlabSums::add(const Points& all) {
  for (int c = 0; c < 3; ++c) {
    for (int k = layer_; k < layer_end_; ++k) {
      double* to = layer(c, k);
      for (int j = 0; j < dims_[1]; ++j) {
        for (int i = 0; i < dims_[0]; ++i) {
          *to++ += all((static_cast<Eigen::Index>(i) * dims_[1] + j) * dims_[2] + k, c);
        }
      }
    }
  }
}

VoxelMap::VoxelMap(const VoxelGrid& grid) : VoxelMap(grid, kVoxelsABlock, kMostSlabs) {}

VoxelMap::VoxelMap(const VoxelGrid& grid, std::size_t voxels_a_block, std::size_t most_slabs)
    : grid_(grid) {
  Lattice::check_dims(grid.dims);
  for (std::size_t a = 0; a < 3; ++a) {
    const double last = grid.first[a] + (grid.counts[a] - 1) * grid.step[a];
    if (grid.counts[a] < 1 || !(grid.first[a] >= 0.0) || !(grid.step[a] >= 0.0) ||
        !(last <= grid.dims[a] - 3)) {
      throw Error(
          fmt::format("voxels along axis {}: {} from {} on, {} cells apart, are not in {} cells; "
                      "give a lattice "
                      "over all of the fixed image",
                      "ijk"[a], grid.counts[a], grid.first[a], grid.step[a], grid.dims[a] - 3));
    }
  }
  blocks_ = blocks_of(grid.counts, voxels_a_block);
  const AxisWeights along_u(grid, 2);
  const std::size_t slabs = std::min(most_slabs, blocks_.size());
  for (std::size_t s = 0; s < slabs; ++s) {
    const std::size_t first = s * blocks_.size() / slabs;
    const std::size_t end = (s + 1) * blocks_.size() / slabs;
    slabs_.push_back(
        {first, end, along_u.cell(blocks_[first].k), along_u.cell(blocks_[end - 1].k_end - 1) + 4});
  }
}

std::size_t VoxelMap::voxels(const VoxelGrid& grid, const VoxelBlock& block) {
  return static_cast<std::size_t>(grid.counts[0]) *
         static_cast<std::size_t>(block.j_end - block.j) *
         static_cast<std::size_t>(block.k_end - block.k);
}

std::size_t VoxelMap::most_voxels() const {
  std::size_t most = 0;
  for (const VoxelBlock& block : blocks_) most = std::max(most, voxels(grid_, block));
  return most;
}

}  // namespace hwffd
