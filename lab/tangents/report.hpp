#pragma once

#include <string>
#include <vector>

#include "study.hpp"

namespace hwffd::tangents {

/// tangents.json: over all rows, then each.
std::string json_report(const std::vector<RowResult>& rows);

/// Lines for what is wrong with a row: results that differ from the model, errors above their
/// bounds, wrong flags, seams that crack, or too little tried; empty if nothing is.
std::string faults(const RowResult& row);

}  // namespace hwffd::tangents
