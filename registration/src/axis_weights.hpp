#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <vector>

#include "hwffd/registration/voxel_map.hpp"

namespace hwffd {

/// Cells and B-spline weights of the voxels along one axis.
class AxisWeights {
 public:
  AxisWeights(const VoxelGrid& grid, std::size_t axis) {
    const int cells = grid.dims[axis] - 3;
    for (int n = 0; n < grid.counts[axis]; ++n) {
      const double at = grid.first[axis] + n * grid.step[axis];
      const int cell = std::min(static_cast<int>(at), cells - 1);
      cells_.push_back(cell);
      weights_.push_back(bspline(at - cell));
    }
  }

  int cell(int voxel) const { return cells_[static_cast<std::size_t>(voxel)]; }
  const std::array<double, 4>& weights(int voxel) const {
    return weights_[static_cast<std::size_t>(voxel)];
  }

  static std::array<double, 4> bspline(double x) {
    const double y = 1 - x;
    const double square = x * x;
    const double cube = square * x;
    return {y * y * y / 6, (3 * cube - 6 * square + 4) / 6, (3 * (square - cube) + 3 * x + 1) / 6,
            cube / 6};
  }

 private:
  std::vector<int> cells_;
  std::vector<std::array<double, 4>> weights_;
};

}  // namespace hwffd
