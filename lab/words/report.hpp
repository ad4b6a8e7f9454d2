#pragma once

#include <string>
#include <vector>

#include "study.hpp"

namespace hwffd::words {

/// build/reports/words.json.
std::string json_report(const std::vector<Result>& results);

/// A line for each row whose error exceeds the bound that is proved of it, or is no number; empty
/// if none does.
std::string faults(const std::vector<Result>& results);

}  // namespace hwffd::words
