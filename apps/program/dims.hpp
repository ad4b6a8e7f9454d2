#pragma once

#include <string>

#include "hwffd/lattice/lattice.hpp"

namespace hwffd {

/// Reads control points an axis, "4x4x4" or "8x5x6".
/// @param what  what the user wrote, for the message: "LATTICE=4x4", "--dims 4x4"
/// @throws UsageError for anything else, and for counts below `least` or above `most`
Index3 parse_dims(const std::string& text, const std::string& what, int least, int most);

}  // namespace hwffd
