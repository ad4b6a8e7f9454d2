#pragma once

#include <string>

#include "comparison.hpp"

namespace hwffd::organizations {

/// One line an organization, format and evaluator: the paper's schedule, then the overlapped one.
std::string table(const Comparison& comparison);

/// organizations.json: one object a row of the table of configurations (docs/verification.md).
/// With the areas, `targets` of a row has what it is on each.
std::string json_report(const Comparison& comparison, const std::vector<Throughput>& areas = {});

/// Lines for what is wrong: a bit that differs from the model, a seam that cracks, a formula that
/// does not hold at either schedule. Empty if nothing is.
std::string faults(const Comparison& comparison);

}  // namespace hwffd::organizations
