#pragma once

#include <string>

#include "comparison.hpp"

namespace hwffd::organizations {

/// SVG: clocks a vertex against operators, both axes logarithmic, at both schedules. Of one format,
/// because the others have the same operators and clocks: fx18, or the first there is; binary32
/// with fused operators is a series of its own.
std::string tradeoff_chart(const Comparison& comparison);

}  // namespace hwffd::organizations
