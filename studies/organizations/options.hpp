#pragma once

#include <filesystem>

#include "measure.hpp"

namespace hwffd::organizations {

struct Options {
  Effort effort;
  std::filesystem::path operators = "build/generated/operators.json";
  std::filesystem::path areas = "build/reports/synth.json";
  std::filesystem::path output = "build";  ///< reports go to its folder reports/
};

/// Throws UsageError; prints help and exits for --help.
Options parse_options(int argc, char** argv);

}  // namespace hwffd::organizations
