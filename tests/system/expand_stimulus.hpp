#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "hwffd/stream/grid.hpp"
#include "hwffd/stream/packed.hpp"
#include "hwffd/tb/random.hpp"

namespace hwffd::test {

/// A grid in a lattice: 1 to `most` vertices an axis, any places and directions, often with ends
/// on faces, and often at the ends of a coordinate's unit.
Grid random_grid(tb::Random& random, const std::array<int, 3>& dims, int most);

/// Packed vertices of a lattice; with `stray` some are outside.
std::vector<PackedVertex> random_packed(tb::Random& random, const std::array<int, 3>& dims,
                                        std::size_t count, bool stray = false);

}  // namespace hwffd::test
