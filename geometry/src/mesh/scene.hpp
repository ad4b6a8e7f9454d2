#pragma once

#include <assimp/scene.h>

#include <Eigen/Core>
#include <cstddef>
#include <string>
#include <vector>

#include "mesh/space.hpp"

namespace hwffd {

inline Eigen::Vector3d to_eigen(const aiVector3D& p) { return {p.x, p.y, p.z}; }

/// Calls f(part, number of its first vertex) for every part of the scene.
template <typename F>
void each_part(const aiScene& scene, F f) {
  std::size_t first = 0;
  for (unsigned m = 0; m < scene.mNumMeshes; ++m) {
    f(*scene.mMeshes[m], first);
    first += scene.mMeshes[m]->mNumVertices;
  }
}

/// Turns all faces round. First corners stay first, so fans are cut along the same diagonals.
void turn_faces(aiMesh& mesh);

/// Drops what does not follow a deformation: animations, bones, morph targets, cameras, lights,
/// tangents; and faces without corners.
/// @return what that was, but for tangents and such faces: "2 animations"
std::vector<std::string> strip_scene(aiScene& scene);

/// Makes corners of a part that agree in every attribute, bit for bit, one vertex, in the order of
/// their first appearance. (Assimp's own step also joins vertices that are merely close.)
void join_corners(aiScene& scene);

/// Applies every node's transform to the parts below it, gives each instance a part of its own,
/// turns faces of mirrored parts round, and drops parts that no node shows.
void bake_transforms(aiScene& scene);

/// Takes back the turn (x, y, z) -> (x, z, -y) that Assimp's reader puts on the root of 3ds files:
/// coordinates are then those in the file.
void undo_3ds_turn(aiScene& scene);

/// Takes the unit and the turn of a dae file to y up out of the root's transform, where Assimp's
/// reader puts them: coordinates are then those in the file.
Space take_space(aiScene& scene);

/// Drops faces of one or two corners.
void drop_points_and_lines(aiScene& scene);

}  // namespace hwffd
