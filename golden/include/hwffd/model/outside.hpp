#pragma once

#include <array>
#include <cstdint>

#include "hwffd/numerics/out_word.hpp"

namespace hwffd::model {

/// What of a vertex is outside its lattice.
struct Outside {
  bool nan = false;         ///< a coordinate is no number
  bool coordinate = false;  ///< one is outside [0, 1]
  bool cell = false;        ///< a cell is beyond the last
  bool any() const { return coordinate || cell; }
};

/// Looks at the words of a vertex, and brings it into the lattice: a cell beyond the last becomes
/// the last. With `clamp` coordinates become the nearest inside, so in that cell 1.
/// @param dims   points an axis; none where any cell will do
/// @param one    the word of the coordinate 1
/// @param range  gives the CoordinateRange of a word
template <class Range>
Outside bring_inside(std::array<std::uint32_t, 3>& local, std::array<int, 3>& cell,
                     const std::array<int, 3>* dims, bool clamp, std::uint32_t one,
                     const Range& range) {
  Outside outside;
  for (int axis = 0; axis < 3; ++axis) {
    const CoordinateRange of_word = range(local[axis]);
    outside.nan |= of_word.nan;
    outside.coordinate |= of_word.outside;
    if (clamp) local[axis] = of_word.clamped;
    if (dims == nullptr || cell[axis] <= (*dims)[axis] - 4) continue;
    outside.cell = true;
    cell[axis] = (*dims)[axis] - 4;
    if (clamp) local[axis] = one;
  }
  return outside;
}

}  // namespace hwffd::model
