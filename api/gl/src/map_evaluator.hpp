#pragma once

#include "state.hpp"
#include "vertex_batch.hpp"

namespace hwffd::gl {

/// What the maps that are switched on make of points of their domain, as OpenGL's evaluators do.
/// Where several maps make the same attribute, the one of most components counts.
/// @throws Error where a map does not fit its blending functions, and what Device throws
VertexBatch evaluate_maps(State& state, const std::vector<Eigen::Vector3d>& uvw);

/// Whether evaluation makes vertices at all.
bool makes_vertices(const State& state);

}  // namespace hwffd::gl
