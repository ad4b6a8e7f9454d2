#pragma once

#include <array>
#include <cstdint>

namespace hwffd::organizations {

/// Eq. (1) in software with uniform cubic B-splines: double precision, three nested loops over the
/// 64 control points (x, y, z each, n fastest), as the B-spline transforms of image registration
/// have it. Without Eigen, whose types may not cross from code for this processor to other code.
std::array<double, 3> reference_vertex(const std::array<double, 192>& points,
                                       const std::array<double, 3>& local);

/// Vertices a second of it on the calling thread.
/// @param vertices evaluated, of random supports
double reference_vertices_per_s(std::size_t vertices, std::uint64_t seed);

}  // namespace hwffd::organizations
