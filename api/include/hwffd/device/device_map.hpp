#pragma once

#include "hwffd/device/device.hpp"
#include "hwffd/registration/voxel_map.hpp"

namespace hwffd {

/// The map of a grid of voxels by devices: by `reference` make_reference_map(), else each block of
/// voxels as one grid (Device::evaluate_grid), and its gradients by rows by make_pull_back_device()
/// of the same kind. Places have the 24 bits in a cell that grids have, and results the bits of
/// `model` and `rtl`, which are the same.
/// @throws UsageError as make_device() and make_pull_back_device()
VoxelMapFactory make_device_map(const DeviceChoice& choice);

}  // namespace hwffd
