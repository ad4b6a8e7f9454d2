#pragma once

#include <vector>

#include "coordinates.hpp"

namespace hwffd::certified {

/// The largest sum over l, m of |round(w_l w_m) - B_l B_m| over all pairs of coordinates, the two
/// axes alike, in fixed point of `fraction` digits: products rounded as the core rounds them.
double largest_pair(const std::vector<Candidate>& points, int fraction);

}  // namespace hwffd::certified
