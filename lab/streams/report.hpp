#pragma once

#include <string>
#include <vector>

#include "pages.hpp"
#include "study.hpp"

namespace hwffd::streams {

/// lab/docs/README.md has the fields.
std::string json_report(const std::vector<Row>& rows, const std::vector<PagesRow>& pages = {});
/// A line for each row whose count differs from its prediction or whose results differ from the
/// model; empty if all is well.
std::string faults(const std::vector<Row>& rows, const std::vector<PagesRow>& pages = {});

}  // namespace hwffd::streams
