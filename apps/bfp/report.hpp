#pragma once

#include <string>
#include <vector>

#include "agreement.hpp"
#include "study.hpp"

namespace hwffd::bfp {

/// Whether every row gave the model's bits, and those of the other rows of its form.
bool identical(const std::vector<Agreement>& agreements);

/// Both tables, as text.
std::string table(const std::vector<Result>& results, const std::vector<Agreement>& agreements);

/// bfp.json: max_error_ulp (of all rows, of the lattice's largest point), vertices (of each
/// distribution), organizations_identical, and all that the tables say.
std::string json_report(const std::vector<Result>& results,
                        const std::vector<Agreement>& agreements);

}  // namespace hwffd::bfp
