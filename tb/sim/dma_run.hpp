#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "hwffd/model/configuration.hpp"
#include "hwffd/stream/beat.hpp"
#include "hwffd/tb/axi_system.hpp"
#include "hwffd/tb/test_identity.hpp"

namespace hwffd::sim {

/// What came of a run of `hwffd_axi`.
struct DmaRun {
  std::vector<Beat> results;  ///< from memory; tlast, which is not there, is that of the model
  std::uint64_t checked = 0;
  std::uint64_t mismatches = 0;
  double clocks_per_result = 0;  ///< from the first to the last beat on W; 0 for one result
  tb::BusUtilisation bus;
  std::string failure;  ///< why it is no good run
};

/// Puts packets into the memory of a Verilated `hwffd_axi` and a descriptor for each into its ring,
/// lets hwffd::Driver start it, and compares the results in memory with the model's.
/// @param waveform  FST file to write; empty: none
/// @param progress  is called with the share of the results that are in memory
DmaRun run_dma(const Configuration& row, const std::vector<Beat>& packets,
               const tb::TestIdentity& test, const std::string& waveform,
               const std::function<void(double)>& progress);

}  // namespace hwffd::sim
