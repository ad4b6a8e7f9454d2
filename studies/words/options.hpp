#pragma once

#include <cstdint>
#include <filesystem>

namespace hwffd::words {

/// What `hwffd-words` was asked to do, checked.
struct Options {
  std::int64_t vertices = 1000000;         ///< of every row, half of them in smooth cells
  std::uint64_t seed = 1;                  ///< of the vertices
  std::filesystem::path output = "build";  ///< folder of reports/words.json and .svg
};

/// Reads the command line. Throws UsageError; `--help` prints and ends the program with 0.
Options parse_options(int argc, char** argv);

}  // namespace hwffd::words
