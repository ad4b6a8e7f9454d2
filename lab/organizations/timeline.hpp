#pragma once

#include <string>
#include <vector>

#include "comparison.hpp"
#include "hwffd/cores/lanes.hpp"

namespace hwffd::organizations {

/// The lanes of a row from its recorded schedule, from the polynomials to the accumulator. Throws
/// std::logic_error where the clocks between the probes are not what the row's latencies say.
std::vector<cores::Lane> lanes_of(const Row& row);

/// timelines.json: which unit is busy in which clock of the first vertex and a little of what
/// follows. Rows of all formats have the same clocks: each organization has those in fx18, in fx17
/// if there are none, else those in the format that comes first.
std::string timelines(const Comparison& comparison);

}  // namespace hwffd::organizations
