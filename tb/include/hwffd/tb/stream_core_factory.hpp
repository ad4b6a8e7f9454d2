#pragma once

#include <cstdint>
#include <memory>

#include "hwffd/model/configuration.hpp"
#include "hwffd/tb/stream_core.hpp"

namespace hwffd::tb {

/// Whether this build (its tier) has the Verilated model of a configuration.
bool has_stream_core(const Configuration& configuration);

/// The Verilated model of a configuration, its registers at random values drawn from the seed.
/// Throws std::invalid_argument where `has_stream_core` is false.
std::unique_ptr<StreamCore> make_stream_core(const Configuration& configuration,
                                             std::uint64_t seed);

}  // namespace hwffd::tb
