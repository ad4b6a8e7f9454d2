#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

namespace hwffd::embed {

/// What `hwffd-embed` was asked to do, checked.
struct Options {
  std::vector<std::string> models{"cat.3ds", "horse.3ds", "bunny.obj"};  ///< meshes
  std::int64_t points = 10000;             ///< by construction, in each lattice
  std::uint64_t seed = 1;                  ///< of these points
  std::filesystem::path output = "build";  ///< folder of reports/embed.json
  bool models_given = false;               ///< by the user: then they must be there
};

/// Reads the command line. Throws UsageError; `--help` prints and ends the program with 0.
Options parse_options(int argc, char** argv);

}  // namespace hwffd::embed
