#pragma once

#include <cstdint>

namespace hwffd::organizations {

/// Vertices a second of eq. (1) in software, on one core: double precision, three nested loops over
/// the 64 control points, as the B-spline transforms of image registration have it.
/// @param vertices evaluated, of random supports
double reference_vertices_per_s(std::size_t vertices, std::uint64_t seed);

}  // namespace hwffd::organizations
