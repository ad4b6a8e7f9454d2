#pragma once

#include <cstdint>

namespace hwffd {

/// A sum as the stream returns it: the word and what is to be said of it.
struct OutWord {
  std::uint32_t word = 0;
  bool saturated = false;
  bool nan = false;
};

/// What a coordinate's stream word is worth (ffd_num_range).
struct CoordinateRange {
  bool nan = false;           ///< no finite number
  bool outside = false;       ///< a number, not in [0, 1]
  std::uint32_t clamped = 0;  ///< the nearest word in [0, 1]; of what is no number, anything
};

}  // namespace hwffd
