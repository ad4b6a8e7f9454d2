#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "hwffd/model/configuration.hpp"
#include "hwffd/stream/beat.hpp"

namespace hwffd::upsets {

/// Packets and what must come of them.
struct Traffic {
  std::vector<Beat> beats, results;
};

/// Points an axis that the cores keep at most: they have no more than the traffic uses.
constexpr int kAxis = 6;

/// Coefficients, a lattice, vertices with each kind of results and vertices with points of their
/// own: good packets only, all memories in use. Throws Error where the model has any event.
/// @param vertices  of each kind
Traffic make_traffic(const Configuration& row, std::size_t vertices, std::uint64_t seed);

}  // namespace hwffd::upsets
