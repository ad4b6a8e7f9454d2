#include "hwffd/device/device_map.hpp"

#include <optional>
#include <utility>

#include "hwffd/error.hpp"

namespace hwffd {
namespace {

// As many as a page of a scatter core adds up exactly in 17 bits, several times over.
constexpr std::size_t kVoxelsOfABlock = 1 << 16;

using Devices = std::pair<std::shared_ptr<Device>, std::shared_ptr<Device>>;

class DeviceMap final : public VoxelMap {
 public:
  DeviceMap(const VoxelGrid& grid, Devices devices)
      : VoxelMap(grid, kVoxelsOfABlock, 1),
        evaluates_(std::move(devices.first)),
        pulls_back_(std::move(devices.second)) {
    std::array<double, 3> last{};
    for (std::size_t a = 0; a < 3; ++a)
      last[a] = grid.first[a] + (grid.counts[a] - 1) * grid.step[a];
    whole_ = grid_between(grid.first, last, grid.counts);
  }

  std::string name() const override { return evaluates_->name(); }
  bool concurrent() const override { return false; }

  void set_points(const Points& points) override { lattice_.emplace(grid().dims, points); }

  void positions(const VoxelBlock& block, double* x, double* y, double* z) const override {
    const Points places = evaluates_->evaluate_grid(*lattice_, part(block));
    for (Eigen::Index row = 0; row < places.rows(); ++row) {
      *x++ = places(row, 0);
      *y++ = places(row, 1);
      *z++ = places(row, 2);
    }
  }

  std::unique_ptr<Transpose> transpose(const VoxelSlab& /*slab*/) const override {
    return std::make_unique<DeviceTranspose>(*this);
  }

 private:
  class DeviceTranspose final : public Transpose {
   public:
    explicit DeviceTranspose(const DeviceMap& map) : map_(map) {
      const Index3& dims = map.grid().dims;
      sums_ = Points::Zero(static_cast<Eigen::Index>(dims[0]) * dims[1] * dims[2], 3);
    }

    void add(const VoxelBlock& block, const double* gx, const double* gy,
             const double* gz) override {
      Points gradient(static_cast<Eigen::Index>(voxels(map_.grid(), block)), 3);
      for (Eigen::Index row = 0; row < gradient.rows(); ++row) {
        gradient.row(row) << gx[row], gy[row], gz[row];
      }
      if (gradient.isZero(0.0)) return;
      const Index3& dims = map_.grid().dims;
      sums_ += map_.pulls_back_->pull_back_grid(dims, map_.part(block), gradient);
    }

    void finish(SlabSums& sums) override { sums.add(sums_); }

   private:
    const DeviceMap& map_;
    Points sums_;
  };

  /// A block as a grid: the places of its voxels in the whole, to the bit.
  Grid part(const VoxelBlock& block) const {
    Grid grid = whole_;
    const std::array<int, 3> first{0, block.j, block.k};
    const std::array<int, 3> end{whole_.count[0], block.j_end, block.k_end};
    for (std::size_t a = 0; a < 3; ++a) {
      grid.start[a] += static_cast<std::uint64_t>(grid.step[a] * first[a]);
      grid.count[a] = static_cast<std::uint16_t>(end[a] - first[a]);
    }
    return grid;
  }

  std::shared_ptr<Device> evaluates_, pulls_back_;
  Grid whole_;
  std::optional<Lattice> lattice_;
};

}  // namespace

VoxelMapFactory make_device_map(const DeviceChoice& choice) {
  if (choice.device == "reference") return make_reference_map;
  // One of each for all levels: a simulated core takes long to begin.
  const Devices devices{make_device(choice), make_pull_back_device(choice.device, true)};
  return [devices](const VoxelGrid& grid) { return std::make_unique<DeviceMap>(grid, devices); };
}

}  // namespace hwffd
