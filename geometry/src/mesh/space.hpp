#pragma once

namespace hwffd {

/// What the coordinates of a mesh mean.
struct Space {
  double unit = 1;  ///< in metres
  unsigned up = 1;  ///< the axis that points up: 0, 1, 2 for x, y, z; most formats do not say it
};

}  // namespace hwffd
