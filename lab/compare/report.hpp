#pragma once

#include <string>
#include <vector>

#include "compare/core.hpp"
#include "compare/software.hpp"

namespace hwffd::compare {

/// What the program of the comparison measures itself.
struct Measured {
  std::size_t vertices = 0;  ///< that LatticeEvaluator evaluates
  std::vector<SoftwareRow> software;
  std::vector<CoreRow> cores;
};

/// compare-own.json: programs of this project, and what its cores took.
std::string json_report(const Measured& measured);

/// Lines for what is wrong: nothing measured, results that differ from the model, errors above
/// their bounds; empty if nothing is.
std::string faults(const Measured& measured);

}  // namespace hwffd::compare
