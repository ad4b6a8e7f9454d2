#include <algorithm>
#include <cstddef>
#include <memory>
#include <vector>

#include "axis_weights.hpp"
#include "clones.hpp"
#include "hwffd/error.hpp"
#include "hwffd/registration/voxel_map.hpp"

namespace hwffd {
namespace {

/// result[i] = w[0]*a[i] + w[1]*a[i + stride] + ..., from the left.
HWFFD_CLONES void sum_of_four(std::size_t n, const std::array<double, 4>& w,
                              const double* __restrict a, std::size_t stride,
                              double* __restrict result) {
  const double* __restrict const b = a + stride;
  const double* __restrict const c = b + stride;
  const double* __restrict const d = c + stride;
  const double p = w[0];
  const double q = w[1];
  const double r = w[2];
  const double s = w[3];
  for (std::size_t i = 0; i < n; ++i) result[i] = p * a[i] + q * b[i] + r * c[i] + s * d[i];
}

/// sums[i + m*stride] += w[m]*a[i]
HWFFD_CLONES void add_to_four(std::size_t n, const std::array<double, 4>& w,
                              const double* __restrict a, double* __restrict sums,
                              std::size_t stride) {
  double* __restrict const second = sums + stride;
  double* __restrict const third = second + stride;
  double* __restrict const fourth = third + stride;
  const double p = w[0];
  const double q = w[1];
  const double r = w[2];
  const double s = w[3];
  for (std::size_t i = 0; i < n; ++i) {
    const double x = a[i];
    sums[i] += p * x;
    second[i] += q * x;
    third[i] += r * x;
    fourth[i] += s * x;
  }
}

class ReferenceMap : public VoxelMap {
 public:
  explicit ReferenceMap(const VoxelGrid& grid)
      : VoxelMap(grid),
        s_(grid, 0),
        t_(grid, 1),
        u_(grid, 2),
        points_along_s_(static_cast<std::size_t>(grid.dims[0])),
        points_along_t_(static_cast<std::size_t>(grid.dims[1])),
        row_(static_cast<std::size_t>(grid.counts[0])) {}

  std::string name() const override { return "reference"; }
  bool concurrent() const override { return true; }

  /// Layer by layer along u, rows of points along s, each component by itself.
  void set_points(const Points& points) override {
    const Index3& dims = grid().dims;
    points_.resize(static_cast<std::size_t>(points.size()));
    double* to = points_.data();
    for (int c = 0; c < 3; ++c) {
      for (int k = 0; k < dims[2]; ++k) {
        for (int j = 0; j < dims[1]; ++j) {
          for (int i = 0; i < dims[0]; ++i) {
            *to++ = points((static_cast<Eigen::Index>(i) * dims[1] + j) * dims[2] + k, c);
          }
        }
      }
    }
  }

  void positions(const VoxelBlock& block, double* x, double* y, double* z) const override {
    const int first = t_.cell(block.j);
    const auto rows = static_cast<std::size_t>(t_.cell(block.j_end - 1) + 4 - first);
    std::vector<double> slice(rows * points_along_s_);
    std::vector<double> spread(rows * row_);
    const std::size_t layer = points_along_s_ * points_along_t_;
    const std::array<double*, 3> results{x, y, z};
    std::size_t at = 0;
    for (int k = block.k; k < block.k_end; ++k) {
      const std::size_t start = at;
      for (std::size_t c = 0; c < 3; ++c) {
        const double* const points =
            points_.data() +
            (c * static_cast<std::size_t>(grid().dims[2]) + static_cast<std::size_t>(u_.cell(k))) *
                layer +
            static_cast<std::size_t>(first) * points_along_s_;
        sum_of_four(slice.size(), u_.weights(k), points, layer, slice.data());
        spread_along_s(rows, slice.data(), spread.data());
        at = start;
        for (int j = block.j; j < block.j_end; ++j, at += row_) {
          sum_of_four(row_, t_.weights(j),
                      spread.data() + static_cast<std::size_t>(t_.cell(j) - first) * row_, row_,
                      results[c] + at);
        }
      }
    }
  }

  std::unique_ptr<Transpose> transpose(const VoxelSlab& slab) const override;

 private:
  class SlabTranspose;

  /// Each row of points to a row of voxels.
  void spread_along_s(std::size_t rows, const double* points, double* voxels) const {
    for (std::size_t row = 0; row < rows; ++row, points += points_along_s_) {
      for (int i = 0; i < grid().counts[0]; ++i) {
        const double* const p = points + s_.cell(i);
        const std::array<double, 4>& w = s_.weights(i);
        *voxels++ = w[0] * p[0] + w[1] * p[1] + w[2] * p[2] + w[3] * p[3];
      }
    }
  }

  AxisWeights s_, t_, u_;
  std::size_t points_along_s_, points_along_t_;
  std::size_t row_;  ///< voxels along i
  std::vector<double> points_;
};

/// Gradients of a slice are added along t first, row by row; the slice is contracted along s, and
/// added to its four layers, when the next begins.
class ReferenceMap::SlabTranspose : public VoxelMap::Transpose {
 public:
  SlabTranspose(const ReferenceMap& map, const VoxelSlab& slab)
      : map_(map),
        sums_(map.grid().dims, slab),
        slice_(3 * map.points_along_t_ * map.row_),
        contracted_(map.points_along_t_ * map.points_along_s_) {}

  void add(const VoxelBlock& block, const double* gx, const double* gy, const double* gz) override {
    const std::size_t row = map_.row_;
    const std::array<const double*, 3> gradients{gx, gy, gz};
    std::size_t at = 0;
    for (int k = block.k; k < block.k_end; ++k) {
      if (k != k_) flush();
      k_ = k;
      for (int j = block.j; j < block.j_end; ++j, at += row) {
        for (std::size_t c = 0; c < 3; ++c) {
          add_to_four(
              row, map_.t_.weights(j), gradients[c] + at,
              slice_.data() +
                  (c * map_.points_along_t_ + static_cast<std::size_t>(map_.t_.cell(j))) * row,
              row);
        }
      }
    }
  }

  void finish(SlabSums& sums) override {
    flush();
    k_ = -1;
    for (int c = 0; c < 3; ++c) {
      for (int k = sums.begin(); k < sums.end(); ++k) {
        const double* const from = sums_.layer(c, k);
        double* const to = sums.layer(c, k);
        for (std::size_t i = 0; i < contracted_.size(); ++i) to[i] += from[i];
      }
    }
  }

 private:
  void flush() {
    if (k_ < 0) return;
    for (int c = 0; c < 3; ++c) {
      const double* from =
          slice_.data() + static_cast<std::size_t>(c) * map_.points_along_t_ * map_.row_;
      std::fill(contracted_.begin(), contracted_.end(), 0.0);
      for (std::size_t j = 0; j < map_.points_along_t_; ++j) {
        double* const to = contracted_.data() + j * map_.points_along_s_;
        for (int i = 0; i < map_.grid().counts[0]; ++i) {
          const std::array<double, 4>& w = map_.s_.weights(i);
          double* const p = to + map_.s_.cell(i);
          const double g = *from++;
          for (std::size_t l = 0; l < 4; ++l) p[l] += w[l] * g;
        }
      }
      const int cell = map_.u_.cell(k_);
      add_to_four(contracted_.size(), map_.u_.weights(k_), contracted_.data(), sums_.layer(c, cell),
                  contracted_.size());
    }
    std::fill(slice_.begin(), slice_.end(), 0.0);
  }

  const ReferenceMap& map_;
  SlabSums sums_;
  std::vector<double> slice_;       ///< components, points along t, voxels along i
  std::vector<double> contracted_;  ///< points along t, points along s
  int k_ = -1;                      ///< the slice
};

std::unique_ptr<VoxelMap::Transpose> ReferenceMap::transpose(const VoxelSlab& slab) const {
  return std::make_unique<SlabTranspose>(*this, slab);
}

}  // namespace

std::unique_ptr<VoxelMap> make_reference_map(const VoxelGrid& grid) {
  return std::make_unique<ReferenceMap>(grid);
}

}  // namespace hwffd
