#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "hwffd/cores/stream_core.hpp"
#include "hwffd/stream/packets.hpp"
#include "hwffd/tb/random.hpp"

namespace hwffd::test {

/// Results of a core, and pulses of event 13, without a bench: nobody knows beforehand how many
/// vertices a grid has made when it is stopped.
struct Stopped {
  std::vector<Beat> results;
  std::size_t refusals = 0;
};

/// Sends all beats, with a pulse of grid_stop_i in a clock, and takes what comes until it is idle.
Stopped stopped_at(cores::StreamCore& core, tb::Random& random, const std::vector<Beat>& beats,
                   std::uint64_t at);

}  // namespace hwffd::test
