#pragma once

#include <algorithm>
#include <limits>

#include "hwffd/lattice/lattice.hpp"

namespace hwffd {

/// By how much sums of a few points of a lattice of some size may be off because it lies far from
/// the origin, where coordinates are rounded; 0 where it does not.
inline double far_rounding(const Points& points, double size) {
  constexpr double kUnits = 16 * std::numeric_limits<double>::epsilon();
  return kUnits * std::max(0.0, points.cwiseAbs().maxCoeff() - size);
}

}  // namespace hwffd
