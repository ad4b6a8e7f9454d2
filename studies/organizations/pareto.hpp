#pragma once

#include <string>

#include "throughput.hpp"

namespace hwffd::organizations {

/// SVG: vertices per second against size, a panel a target, both axes logarithmic; vertices per
/// clock on targets whose clock no row knows. The rows that no other beats are joined and named,
/// the others are grey.
std::string pareto_chart(const std::vector<Throughput>& rows);

}  // namespace hwffd::organizations
