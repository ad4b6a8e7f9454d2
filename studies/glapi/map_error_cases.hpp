#pragma once

#include "error_cases.hpp"

namespace hwffd::glapi {

/// All mistakes that glMap3 knows, alone, in pairs and by three, so that the order of the checks
/// shows, each beside the same in glMap2.
std::vector<ErrorCase> map_error_cases();

}  // namespace hwffd::glapi
