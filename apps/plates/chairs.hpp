#pragma once

#include "hwffd/mesh/mesh.hpp"

namespace hwffd::plates {

/// An office chair as in plates 5 to 8: five arms with castors, a stem, seat, back and armrests.
/// Metres, y up, the floor at 0, the sitter looks along z. Stem and castors are below
/// kOfficeStemTop, everything else above.
Mesh office_chair();
inline constexpr double kOfficeStemTop = 0.43;

/// A wooden chair with four legs as in plates 9 and 10. Metres, y up, the floor at 0, the sitter
/// looks along z.
Mesh wooden_chair();

}  // namespace hwffd::plates
