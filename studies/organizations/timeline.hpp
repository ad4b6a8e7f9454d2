#pragma once

#include <string>
#include <vector>

#include "comparison.hpp"
#include "lanes.hpp"

namespace hwffd::organizations {

/// The lanes of a row from its recorded schedule, from the polynomials to the accumulator. Throws
/// std::logic_error where the clocks between the probes are not what the row's latencies say.
std::vector<Lane> lanes_of(const Row& row);

/// timelines.json: which unit is busy in which clock of the first vertex and a little of what
/// follows, of each row of a format.
std::string timelines(const Comparison& comparison, const std::string& format);

}  // namespace hwffd::organizations
