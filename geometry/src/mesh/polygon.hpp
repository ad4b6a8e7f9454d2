#pragma once

#include <assimp/mesh.h>

#include <array>
#include <vector>

namespace hwffd {

/// The triangles of a polygon, which may be concave, turned as it is: n - 2 of them, each with
/// three of its vertices.
std::vector<std::array<unsigned, 3>> triangles_of(const aiMesh& part, const aiFace& face);

}  // namespace hwffd
