#pragma once

#include "hwffd/lattice/lattice.hpp"

namespace hwffd {

/// The lattice between two: every point on the straight line from its place in a to its place
/// in b. At 0 it is a, at 1 it is b, bit for bit; below 0 and above 1 the lines go on.
/// @throws Error if the dimensions differ or a point would not be finite
Lattice between(const Lattice& a, const Lattice& b, double fraction);

}  // namespace hwffd
