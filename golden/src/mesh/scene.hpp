#pragma once

#include <assimp/scene.h>

#include <filesystem>

namespace hwffd {

/// Drops what does not follow a deformation: animations, bones, morph targets, cameras, lights,
/// tangents.
void strip_scene(aiScene& scene);

/// Makes corners of a part that agree in every attribute, bit for bit, one vertex, in the order of
/// their first appearance. (Assimp's own step also joins vertices that are merely close.)
void join_corners(aiScene& scene);

/// Applies every node's transform to the parts below it, gives each instance a part of its own,
/// turns faces of mirrored parts round, and drops parts that no node shows.
void bake_transforms(aiScene& scene);

/// Takes back the turn (x, y, z) -> (x, z, -y) that Assimp's reader puts on the root of 3ds files:
/// coordinates are then those in the file.
void undo_3ds_turn(aiScene& scene);

}  // namespace hwffd
