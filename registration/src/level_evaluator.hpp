#pragma once

#include <cstdint>
#include <memory>
#include <mutex>
#include <vector>

#include "hwffd/registration/registration.hpp"
#include "hwffd/registration/sampling.hpp"

namespace hwffd {

/// The metric of two volumes, whose fixed voxels lie in a lattice as a grid says.
class LevelEvaluator {
 public:
  LevelEvaluator(const Volume& fixed, const Volume& moving, const VoxelGrid& grid, MetricKind kind,
                 int bins, const VoxelMapFactory& map);
  ~LevelEvaluator();

  MetricEvaluation run(const Points& points, bool with_gradient);
  const VoxelMap& map() const { return *map_; }

 private:
  struct Buffers;
  /// Buffers that nobody uses, for as long as it lives.
  class Loan;

  /// Calls work(slab) for all slabs, on all threads if the map can have it.
  void for_slabs(const std::function<void(std::size_t slab)>& work) const;
  /// Values of the moving image in the buffers, and whether voxels count.
  void sample(const VoxelBlock& block, bool with_gradient, Buffers& buffers,
              MetricSamples& samples) const;
  /// The sum over slabs, in their order.
  std::vector<double> total() const;

  const Volume& fixed_;
  AffineMap to_index_;  ///< of the moving image
  LinearSampler sampler_;
  std::unique_ptr<Metric> metric_;
  std::unique_ptr<VoxelMap> map_;
  std::vector<std::vector<double>> sums_;  ///< of the metric, a slab each
  std::mutex lending_;
  std::vector<std::unique_ptr<Buffers>> free_;
};

/// Of the voxels of a fixed volume, halved so often along each axis, in cells that fill the volume
/// of so many voxels an axis.
VoxelGrid voxel_grid(const Index3& counts, const std::array<int, 3>& halvings,
                     const Index3& halved_counts, const Index3& dims);

}  // namespace hwffd
