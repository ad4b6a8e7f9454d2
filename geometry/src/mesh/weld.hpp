#pragma once

#include <cstdint>
#include <vector>

#include "hwffd/points.hpp"

namespace hwffd {

/// Positions, each once, in the order in which they are first seen.
struct Welded {
  Points positions;
  std::vector<std::uint32_t> vertices;  ///< row of what was welded -> row of positions
};

/// Equal rows become one; -0 and +0 are equal.
Welded weld(Points points);

}  // namespace hwffd
