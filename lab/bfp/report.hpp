#pragma once

#include <string>
#include <vector>

#include "agreement.hpp"
#include "study.hpp"

namespace hwffd::bfp {

/// A line for each error above the bound that is proved of it, and for each form whose rows differ;
/// empty if all is well.
std::string faults(const std::vector<Result>& results, const std::vector<Agreement>& agreements);

/// bfp.json: max_error_ulp (of all rows, of the lattice's largest point), vertices (of each
/// distribution), organizations_identical, and all that the tables say.
std::string json_report(const std::vector<Result>& results,
                        const std::vector<Agreement>& agreements);

}  // namespace hwffd::bfp
