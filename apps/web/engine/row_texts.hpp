#pragma once

#include <string>

#include "hwffd/model/configuration.hpp"

namespace hwffd::web {

/// What a page calls a row: "factored, 18-bit fixed point".
std::string title_of(const Configuration& row);

/// The clocks between its vertices as the table of organizations says them, with the terms' values:
/// "64 * start, start = 1".
std::string formula_of(const Configuration& row);

}  // namespace hwffd::web
