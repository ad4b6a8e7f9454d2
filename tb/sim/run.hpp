#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>

#include "hwffd/tb/axi_system.hpp"
#include "options.hpp"
#include "scene.hpp"

namespace hwffd::sim {

/// What one configuration made of one deformation.
struct RunResult {
  Configuration row;
  std::string deform;
  std::uint64_t checked = 0;
  std::uint64_t mismatches = 0;
  double clocks_per_vertex = 0;  ///< (last - first result clock) / (n - 1); 0 for one vertex
  double max_error = 0;          ///< against the oracle, in units of the lattice's scale
  double rms_error = 0;          ///< per component, same unit
  std::string failure;           ///< the bench's report where something failed
  std::optional<tb::BusUtilisation> bus;  ///< STREAM=dma only
  Points positions;  ///< n x 3, what came out of the hardware, world coordinates
};

/// Sends all vertices through the Verilated core, by its streams or from memory to memory, and
/// compares every result with the model.
/// @param waveform  FST file to write; empty: none
RunResult run(const Options& options, const Configuration& row, const Scene& scene,
              const Deformed& deformed, const std::string& waveform);

}  // namespace hwffd::sim
