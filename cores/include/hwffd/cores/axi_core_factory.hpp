#pragma once

#include <cstdint>
#include <memory>
#include <string>

#include "hwffd/cores/axi_core.hpp"
#include "hwffd/model/configuration.hpp"

namespace hwffd::cores {

/// Whether this build has a Verilated `hwffd_axi` of a configuration (axi_rows in
/// tb/CMakeLists.txt, as far as its tier has them).
bool has_axi_core(const Configuration& configuration);

/// That core, its registers at random values drawn from the seed. Throws std::invalid_argument
/// where `has_axi_core` is false.
/// @param trace  FST waveform to write; empty: none. Throws as Waveform::open does.
std::unique_ptr<AxiCore> make_axi_core(const Configuration& configuration, std::uint64_t seed,
                                       const std::string& trace = {});

}  // namespace hwffd::cores
