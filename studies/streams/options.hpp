#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace hwffd::streams {

struct Options {
  std::vector<std::string> models{"cat.3ds", "horse.3ds", "bunny.obj"};
  std::vector<int> lattices{4, 6, 8, 12, 16};  ///< points an axis
  std::filesystem::path output = "build";
  bool models_given = false;  ///< by the user: then they must be there
};

/// @throws UsageError, whose text names the option and what it accepts
Options parse_options(int argc, char** argv);

}  // namespace hwffd::streams
