#pragma once

#include "facts.hpp"

namespace hwffd::certified {

/// Fixed point and block floating point.
void find_fixed_facts(const Effort& effort, Facts& facts);
/// binary32, fused or not.
void find_float_facts(const Effort& effort, Facts& facts);

}  // namespace hwffd::certified
