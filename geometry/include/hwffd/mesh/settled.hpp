#pragma once

#include "hwffd/points.hpp"

namespace hwffd {

/// Positions after a deformation, in which those that rounding alone has moved, by some units in
/// the last place of the largest coordinate, are those at rest, bit for bit.
/// @param rest  as many rows
Points settled(Points positions, const Points& rest);

}  // namespace hwffd
