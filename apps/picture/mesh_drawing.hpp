#pragma once

#include "hwffd/mesh/mesh.hpp"

namespace hwffd::picture {

/// Draws a mesh to the current context, as vertex arrays, one call a part: with the diffuse colours
/// of its materials (light grey where there are none) and the normals of its file, or smooth ones
/// in parts without.
void draw_mesh(const Mesh& mesh);

}  // namespace hwffd::picture
