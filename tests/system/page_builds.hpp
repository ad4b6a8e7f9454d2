// The cores with pages of tests/system/CMakeLists.txt.
#pragma once

#include <vector>

#include "page_run.hpp"

namespace hwffd::test {

/// Those of them that are wanted, all unless said.
std::vector<PageBuild> page_builds(bool (*wanted)(const PageBuild&) = [](const PageBuild&) {
  return true;
});

}  // namespace hwffd::test
