#pragma once

#include <string>
#include <vector>

#include "study.hpp"

namespace hwffd::tangents {

/// The rows as text, aligned.
std::string table(const std::vector<RowResult>& rows);

/// tangents.json: over all rows, then each.
std::string json_report(const std::vector<RowResult>& rows);

}  // namespace hwffd::tangents
