#pragma once

#include <array>
#include <cstddef>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "hwffd/points.hpp"

namespace hwffd {

/// Voxels of a fixed image in a lattice of uniform cubic B-splines: along an axis voxel n is
/// first + n * step cells from the first face of the cells.
struct VoxelGrid {
  Index3 counts{1, 1, 1};         ///< voxels along i, j, k
  Index3 dims{4, 4, 4};           ///< control points along s, t, u, which run along i, j, k
  std::array<double, 3> first{};  ///< in cells
  std::array<double, 3> step{};   ///< in cells
};

/// A box of voxels, all of them along i: rows [j, j_end) of slices [k, k_end).
struct VoxelBlock {
  int j, j_end, k, k_end;
};

/// Consecutive blocks, whose sums are added to each other in their order, and whose control points
/// along u are layers [layer, layer_end).
struct VoxelSlab {
  std::size_t block, block_end;  ///< of VoxelMap::blocks()
  int layer, layer_end;
};

/// Gradients with respect to the control points of some layers along u: component c of point
/// (i, j, k) at ((c*layers + k - layer)*dims[1] + j)*dims[0] + i.
class SlabSums {
 public:
  SlabSums(const Index3& dims, const VoxelSlab& slab);

  double* layer(int component, int k);
  const double* layer(int component, int k) const;
  int begin() const { return layer_; }
  int end() const { return layer_end_; }
  /// Adds them to gradients of all points, m x 3, in the order of Lattice::index().
  void add_to(Points& all) const;
  /// Adds the layers that they hold of gradients of all points; those of others are 0.
  void add(const Points& all);

 private:
  Index3 dims_;
  int layer_, layer_end_;
  std::vector<double> sums_;
};

/// What takes the voxels of a fixed image to places in the moving one, and its transpose: eq. (1)
/// over a whole grid, block by block. Since B-splines sum to one, control points are given in the
/// indices of the moving image, and so are the places.
///
/// Blocks and slabs depend on the grid alone, never on threads. A slab is the work of one thread;
/// sums of slabs are added in their order. So no bit depends on the number of threads.
class VoxelMap {
 public:
  explicit VoxelMap(const VoxelGrid& grid);
  virtual ~VoxelMap() = default;
  VoxelMap(const VoxelMap&) = delete;
  VoxelMap& operator=(const VoxelMap&) = delete;

  const VoxelGrid& grid() const { return grid_; }
  const std::vector<VoxelBlock>& blocks() const { return blocks_; }
  const std::vector<VoxelSlab>& slabs() const { return slabs_; }
  /// Voxels of the largest block.
  std::size_t most_voxels() const;
  static std::size_t voxels(const VoxelGrid& grid, const VoxelBlock& block);

  /// The name of what evaluates, as in "reference".
  virtual std::string name() const = 0;
  /// Whether several threads may have positions() and pull_back() of different slabs at once.
  virtual bool concurrent() const = 0;
  /// The control points from now on, m x 3, in the order of Lattice::index(), in indices of the
  /// moving image.
  virtual void set_points(const Points& points) = 0;
  /// Places of a block's voxels, i fastest, then j, then k.
  virtual void positions(const VoxelBlock& block, double* x, double* y, double* z) const = 0;

  /// What one thread needs for the transpose of the blocks of a slab.
  class Transpose {
   public:
    virtual ~Transpose() = default;
    /// The gradients of a block's voxels with respect to their places, in the order of positions().
    /// Blocks come in their order.
    virtual void add(const VoxelBlock& block, const double* gx, const double* gy,
                     const double* gz) = 0;
    /// After the last block: adds what was added with respect to the control points.
    virtual void finish(SlabSums& sums) = 0;
  };
  virtual std::unique_ptr<Transpose> transpose(const VoxelSlab& slab) const = 0;

 protected:
  /// Blocks of as many slices as have that many voxels, but at least one; of slices of more than
  /// four times as many, rows with that. And as many slabs as are told, or one for each block if
  /// these are fewer.
  VoxelMap(const VoxelGrid& grid, std::size_t voxels_a_block, std::size_t most_slabs);

 private:
  VoxelGrid grid_;
  std::vector<VoxelBlock> blocks_;
  std::vector<VoxelSlab> slabs_;
};

/// Makes the map of a grid.
using VoxelMapFactory = std::function<std::unique_ptr<VoxelMap>(const VoxelGrid& grid)>;

/// In double. Control points of a slice are contracted along u and spread along s, once for all of
/// its rows; then a voxel takes four multiplications a component, along t. The transpose does the
/// same backwards. Each place, and each sum, has an order of operations of its own, which no vector
/// unit changes: bits are the same on any processor with IEEE-754 and any compiler that neither
/// fuses nor reorders (-ffp-contract=off, no -ffast-math).
/// @throws Error for dims that Lattice refuses, and voxels beyond the cells
std::unique_ptr<VoxelMap> make_reference_map(const VoxelGrid& grid);

}  // namespace hwffd
