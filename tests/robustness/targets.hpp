#pragma once

#include <vector>

#include "fuzz.hpp"

namespace hwffd {

/// Every reader of text from outside that a program of tests covers: targets.cpp under sanitizers,
/// mesh_targets.cpp without. A new one is a line there.
const std::vector<Target>& targets();

}  // namespace hwffd
