#pragma once

#include <assimp/scene.h>

#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "hwffd/error.hpp"
#include "mesh/space.hpp"

namespace hwffd {

/// A scene as a file holds it, ready to be deformed: transforms applied, nothing in it that would
/// not follow.
struct ReadScene {
  std::unique_ptr<aiScene> scene;
  /// The number in the file of every vertex of the scene, parts in order; empty for a format whose
  /// reader gives each corner of a face a vertex of its own. Every number occurs.
  std::vector<std::uint32_t> numbers;
  Space space;                       ///< of its coordinates; dae only says it
  std::vector<std::string> dropped;  ///< what was left out: "2 animations"
};

/// What Mesh::load() takes, for messages.
inline constexpr const char* kAcceptedMeshes =
    "accepted are obj, ply, stl, 3ds, glb, gltf, dae and what else Assimp reads";

/// A file that is no mesh.
inline Error not_a_mesh(const std::string& reason) {
  return Error("not a mesh that can be read (" + reason + "); " + kAcceptedMeshes);
}

/// Reads a mesh file through Assimp, whose readers trust their input: for a child process.
/// @throws Error, here and below without the name of the file
ReadScene read_scene(const std::filesystem::path& path, const std::string& bytes);

/// @throws Error if the scene has no vertices, a coordinate that is not
///   finite, or an index beyond its end
void check_scene(const aiScene& scene);

/// The scene as bytes, for another process.
/// @throws Error for nodes nested too deeply
std::string pack(const ReadScene& read);

/// @throws Error for bytes that pack() does not make
ReadScene unpack(const std::string& bytes);

}  // namespace hwffd
