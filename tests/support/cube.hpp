#pragma once

#include "hwffd/points.hpp"

namespace hwffd {

/// Two opposite corners of the cube from -1 to 1: what a lattice around it holds.
inline Points cube() { return (Points(2, 3) << -1, -1, -1, 1, 1, 1).finished(); }

}  // namespace hwffd
