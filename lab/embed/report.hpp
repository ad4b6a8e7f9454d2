#pragma once

#include <string>
#include <vector>

#include "study.hpp"

namespace hwffd::embed {

/// build/reports/embed.json.
/// @param fold_us  fold_check_us_per_cell()
std::string json_report(const std::vector<Row>& rows, double fold_us);

/// A line for each row with points that are neither found nor excluded, outside a lattice that
/// holds them all, or do not come back; empty if all is well.
std::string faults(const std::vector<Row>& rows);

}  // namespace hwffd::embed
