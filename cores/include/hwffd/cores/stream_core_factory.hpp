#pragma once

#include <cstdint>
#include <memory>
#include <string>

#include "hwffd/cores/stream_core.hpp"
#include "hwffd/model/configuration.hpp"

namespace hwffd::cores {

/// Whether this build (its tier) has the Verilated model of a configuration.
bool has_stream_core(const Configuration& configuration);

/// Whether this build's models can write waveforms (HWFFD_TRACE).
bool stream_cores_can_trace();

/// The Verilated model of a configuration, its registers at random values drawn from the seed.
/// Throws std::invalid_argument where `has_stream_core` is false.
/// @param trace  FST waveform to write; empty: none. Throws as Waveform::open does.
std::unique_ptr<StreamCore> make_stream_core(const Configuration& configuration, std::uint64_t seed,
                                             const std::string& trace = {});

}  // namespace hwffd::cores
