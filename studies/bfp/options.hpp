#pragma once

#include <cstdint>
#include <filesystem>

namespace hwffd::bfp {

/// What `hwffd-bfp` was asked to do, checked.
struct Options {
  std::int64_t vertices = 10000000;        ///< of every distribution of control points
  std::size_t rtl_vertices = 2000;         ///< of every row that runs in RTL
  std::uint64_t seed = 1;                  ///< of lattices, vertices and registers
  std::filesystem::path output = "build";  ///< folder of reports/bfp.json
};

/// Reads the command line. Throws UsageError; `--help` prints and ends the program with 0.
Options parse_options(int argc, char** argv);

}  // namespace hwffd::bfp
