#pragma once

#include <string>
#include <vector>

#include "study.hpp"

namespace hwffd::embed {

/// build/reports/embed.json.
std::string json_report(const std::vector<Row>& rows);

/// A line for each row with points that are neither found nor excluded, outside a lattice that
/// holds them all, or do not come back; empty if all is well.
std::string faults(const std::vector<Row>& rows);

}  // namespace hwffd::embed
