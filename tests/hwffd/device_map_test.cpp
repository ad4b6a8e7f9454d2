// The map of a registration on a device: its places and sums are those of the device's grids.
#include "hwffd/device/device_map.hpp"

#include <gtest/gtest.h>

#include "errors.hpp"
#include "hwffd/registration/registration.hpp"
#include "phantom.hpp"

namespace hwffd {
namespace {

const DeviceChoice kModel{"model", "affine", "fx17"};

/// Several slices a block, and rows of one.
const VoxelGrid kGrids[] = {
    {{48, 40, 80}, {5, 7, 6}, {0.125, 0.25, 0}, {1.5 / 48, 0.09, 0.0375}},
    {{600, 450, 1}, {6, 4, 4}, {0, 0, 0.5}, {3.0 / 600, 1.0 / 450, 0}},
};

Grid whole_of(const VoxelGrid& grid) {
  std::array<double, 3> last{};
  for (std::size_t a = 0; a < 3; ++a) {
    last[a] = grid.first[a] + (grid.counts[a] - 1) * grid.step[a];
  }
  return grid_between(grid.first, last, grid.counts);
}

/// In indices of a moving image.
Points indices_of(const Index3& dims) {
  return 20 *
         (Points::Random(static_cast<Eigen::Index>(dims[0]) * dims[1] * dims[2], 3).array() + 1);
}

TEST(DeviceMap, PlacesOfAllBlocksAreThoseOfTheWholeGrid) {
  for (const VoxelGrid& grid : kGrids) {
    const auto map = make_device_map(kModel)(grid);
    EXPECT_EQ(map->name(), "model affine-fx17-overlapped");
    EXPECT_FALSE(map->concurrent());
    EXPECT_GT(map->blocks().size(), 1U);
    const Lattice lattice(grid.dims, indices_of(grid.dims));
    const Points whole = make_device(kModel)->evaluate_grid(lattice, whole_of(grid));
    map->set_points(lattice.points());
    std::vector<double> x(map->most_voxels()), y(x), z(x);
    Eigen::Index row = 0;
    for (const VoxelBlock& block : map->blocks()) {
      map->positions(block, x.data(), y.data(), z.data());
      for (std::size_t v = 0; v < VoxelMap::voxels(grid, block); ++v, ++row) {
        ASSERT_EQ(Eigen::RowVector3d(x[v], y[v], z[v]), whole.row(row)) << "voxel " << row;
      }
    }
    EXPECT_EQ(row, whole.rows());
  }
}

/// The gradients of voxels, summed by a map at the control points.
Points pulled_back(const VoxelMap& map, const Points& gradient) {
  Points pulled = Points::Zero(map.grid().dims[0] * map.grid().dims[1] * map.grid().dims[2], 3);
  for (const VoxelSlab& slab : map.slabs()) {
    const auto transpose = map.transpose(slab);
    Eigen::Index row = 0;
    for (std::size_t b = 0; b < slab.block; ++b) {
      row += static_cast<Eigen::Index>(VoxelMap::voxels(map.grid(), map.blocks()[b]));
    }
    for (std::size_t b = slab.block; b < slab.block_end; ++b) {
      const auto count = static_cast<Eigen::Index>(VoxelMap::voxels(map.grid(), map.blocks()[b]));
      const Eigen::MatrixX3d part = gradient.middleRows(row, count);  // component by component
      transpose->add(map.blocks()[b], part.col(0).data(), part.col(1).data(), part.col(2).data());
      row += count;
    }
    SlabSums sums(map.grid().dims, slab);
    transpose->finish(sums);
    sums.add_to(pulled);
  }
  return pulled;
}

TEST(DeviceMap, GradientsGoToTheControlPointsByRows) {
  for (const VoxelGrid& grid : kGrids) {
    const auto map = make_device_map(kModel)(grid);
    const Points gradient = Points::Random(
        static_cast<Eigen::Index>(grid.counts[0]) * grid.counts[1] * grid.counts[2], 3);
    const Points pulled = pulled_back(*map, gradient);
    const Points exact = pulled_back(*make_reference_map(grid), gradient);
    const double size = exact.cwiseAbs().maxCoeff();
    EXPECT_LT((pulled - exact).cwiseAbs().maxCoeff(), 1e-3 * size);
    EXPECT_GT((pulled - exact).cwiseAbs().maxCoeff(), 0);
    // Of one block alone they are the bits of its grid.
    const VoxelBlock& first = map->blocks().front();
    Points alone = gradient;
    const auto count = static_cast<Eigen::Index>(VoxelMap::voxels(grid, first));
    alone.bottomRows(alone.rows() - count).setZero();
    Grid part = whole_of(grid);
    part.count[1] = static_cast<std::uint16_t>(first.j_end);
    part.count[2] = static_cast<std::uint16_t>(first.k_end);
    EXPECT_EQ(pulled_back(*map, alone),
              make_pull_back_device("model", true)
                  ->pull_back_grid(grid.dims, part, gradient.topRows(count)));
    EXPECT_TRUE(pulled_back(*map, Points::Zero(gradient.rows(), 3)).isZero(0));
  }
}

TEST(DeviceMap, ImagesAreAlignedOnTheModelAsOnTheReference) {
  const Phantom phantom({32, 28, 24}, 1.5);
  const Volume fixed = phantom.fixed();
  const Volume moving = phantom.moving();
  const auto aligned = [&](const DeviceChoice& choice) {
    RegistrationOptions options;
    options.spacing = {8, 8, 8};
    options.smooth = false;  // there is no noise
    options.map = make_device_map(choice);
    return register_volumes(fixed, moving, options);
  };
  const RegistrationResult exact = aligned({});
  const RegistrationResult got = aligned(kModel);
  EXPECT_GT(phantom.error(got.rest, 2), 0.5);
  EXPECT_LT(phantom.error(got.deformed, 2), 0.1);
  EXPECT_LT(phantom.error(exact.deformed, 2), 0.1);
  EXPECT_LT(got.metric_end, 0.01 * got.metric_start);
  EXPECT_TRUE(got.warnings.empty());
  EXPECT_NE(got.deformed.points(), exact.deformed.points()) << "in double";
}

TEST(DeviceMap, IsInDoubleOnTheReferenceAndRefusesAsDevicesDo) {
  EXPECT_EQ(make_device_map({})(kGrids[0])->name(), "reference");
  EXPECT_USAGE_ERROR_PART(make_device_map({"abacus"}), "device 'abacus' is unknown; one of model");
  EXPECT_USAGE_ERROR_PART(make_device_map({"model", "cg9", "fx18"}), "no organization 'cg9' here");
}

}  // namespace
}  // namespace hwffd
