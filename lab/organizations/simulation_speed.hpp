#pragma once

#include <cstdint>

#include "hwffd/model/configuration.hpp"

namespace hwffd::organizations {

/// Vertices a second of a row's simulated RTL at its read port, on the calling thread. Timed alone
/// only if nothing else runs: processors share caches and their clock.
/// @throws std::invalid_argument where this build does not have the row
double simulated_vertices_per_s(const Configuration& row, std::uint64_t seed);

}  // namespace hwffd::organizations
