#pragma once

#include <filesystem>
#include <map>
#include <string>

namespace hwffd::organizations {

/// Arithmetic operators of one kind each.
struct Operators {
  int mul = 0;
  int add = 0;
  int fma = 0;

  /// Operations a clock: a fused one counts two.
  int total() const { return mul + add + 2 * fma; }
};

/// What tools/synth/operators.py counts in the elaborated design of a row.
struct OperatorCount {
  Operators built;
  Operators drawn;     ///< of the form as the paper draws it
  int evaluators = 0;  ///< polynomial evaluators, as built
};

/// Row name -> count. Throws Error where the file is not what operators.py writes.
std::map<std::string, OperatorCount> read_operators(const std::filesystem::path& file);

}  // namespace hwffd::organizations
