#pragma once

#include "hwffd/device/device.hpp"

namespace hwffd::gl {

/// Eq. (1) on a device, also for blending functions that do not sum to 1 (Hermite curves). A device
/// in fixed point takes the lattice's centre away and adds it to the sum, which is right only of
/// weights that sum to 1, and holds no sum beyond the lattice's size; so here the points are
/// centred, the functions scaled by a power of two, and the result mended.
/// @param vertices     local coordinates beyond [0, 1] are clamped, on every device
/// @param derivatives  whether jacobians are wanted, too (Device::tangents); else there are none
/// @throws what Device::evaluate throws
Device::Tangents weighted_sums(Device& device, const Lattice& lattice,
                               const std::vector<Embedded>& vertices,
                               const Device::Blending& blending, bool derivatives);

}  // namespace hwffd::gl
