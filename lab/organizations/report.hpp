#pragma once

#include <string>

#include "comparison.hpp"

namespace hwffd::organizations {

/// organizations.json: one object a row of the table of configurations (lab/docs/organizations.md).
std::string json_report(const Comparison& comparison);

/// Lines for what is wrong: a bit that differs from the model, a seam that cracks, a formula that
/// does not hold at either schedule. Empty if nothing is.
std::string faults(const Comparison& comparison);

}  // namespace hwffd::organizations
