#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "hwffd/lattice/deformation.hpp"
#include "hwffd/model/configuration.hpp"

namespace hwffd::sim {

/// The stream that goes through the memory of `hwffd_axi`, in the arrangement "resident".
inline constexpr const char* kDmaStream = "dma";

/// What `hwffd-sim` was asked to do, checked.
struct Options {
  std::string model;                       ///< mesh file or bare name; empty: the default cat
  std::vector<std::string> deformations;   ///< texts that Deformation::parse takes
  Index3 lattice{4, 4, 4};                 ///< control points an axis
  std::vector<Configuration> rows;         ///< configurations to run
  std::string stream = "interleaved";      ///< how the vertices reach the core
  std::uint64_t seed = 1;                  ///< registers' start values, idle data
  bool trace = false;                      ///< write waveforms
  std::filesystem::path output = "build";  ///< folder of meshes, reports and traces
};

/// Reads the command line. Throws UsageError; `--help` prints and ends the program with 0.
Options parse_options(int argc, char** argv);

}  // namespace hwffd::sim
