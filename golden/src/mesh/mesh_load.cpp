#include <assimp/scene.h>
#include <fmt/format.h>

#include <algorithm>
#include <assimp/Importer.hpp>
#include <cmath>
#include <system_error>

#include "hwffd/error.hpp"
#include "hwffd/excerpt.hpp"
#include "hwffd/mesh/extension.hpp"
#include "hwffd/mesh/mesh.hpp"
#include "mesh/ply_check.hpp"
#include "mesh/scene.hpp"
#include "read_file.hpp"

namespace hwffd {
namespace {

namespace fs = std::filesystem;

constexpr const char* kAccepted =
    "accepted are obj, ply, stl, 3ds, glb, gltf, dae and what else Assimp reads";

/// What Assimp says, which may quote a line of the file.
std::string reason_of(const Assimp::Importer& importer) {
  std::string text = importer.GetErrorString();
  while (!text.empty() && (text.back() == ' ' || text.back() == '.' || text.back() == '\n')) {
    text.pop_back();
  }
  std::replace(text.begin(), text.end(), '\n', ' ');
  return excerpt(text);
}

Error not_a_mesh(const std::string& file, const std::string& reason) {
  return Error(fmt::format("{}: not a mesh that can be read ({}); {}", file, reason, kAccepted));
}

void check_part(const std::string& file, const aiMesh& mesh) {
  for (unsigned v = 0; v < mesh.mNumVertices; ++v) {
    const aiVector3D& p = mesh.mVertices[v];
    if (!std::isfinite(p.x) || !std::isfinite(p.y) || !std::isfinite(p.z)) {
      throw Error(
          fmt::format("{}: vertex {} has a coordinate that is not a finite binary32 "
                      "number; repair or scale the mesh",
                      file, v));
    }
  }
  for (unsigned f = 0; f < mesh.mNumFaces; ++f) {
    const aiFace& face = mesh.mFaces[f];
    for (unsigned c = 0; c < face.mNumIndices; ++c) {
      if (face.mIndices[c] < mesh.mNumVertices) continue;
      throw Error(fmt::format("{}: face {} refers to vertex {} of {}; repair the mesh", file, f,
                              face.mIndices[c], mesh.mNumVertices));
    }
  }
}

void check_scene(const std::string& file, const aiScene& scene) {
  std::size_t vertices = 0;
  for (unsigned m = 0; m < scene.mNumMeshes; ++m) {
    check_part(file, *scene.mMeshes[m]);
    vertices += scene.mMeshes[m]->mNumVertices;
  }
  if (vertices == 0 || scene.mRootNode == nullptr) {
    throw Error(fmt::format("{}: holds no vertices; {}", file, kAccepted));
  }
}

}  // namespace

Mesh Mesh::load(const fs::path& path) {
  const std::string file = path.string();
  std::error_code ignored;
  if (!fs::exists(path, ignored)) {
    throw Error(fmt::format("{}: no such file; give the path of a mesh: {}", file, kAccepted));
  }
  if (!fs::is_regular_file(path, ignored)) {
    throw Error(fmt::format("{}: not a file; give the path of a mesh: {}", file, kAccepted));
  }
  const std::string bytes = read_file(path);
  const std::string fault = extension_of(path) == ".ply" ? fault_of_ply(bytes) : "";
  if (!fault.empty()) throw not_a_mesh(file, fault);
  Assimp::Importer importer;
  if (importer.ReadFile(file, 0) == nullptr) throw not_a_mesh(file, reason_of(importer));
  ScenePtr scene(importer.GetOrphanedScene());
  check_scene(file, *scene);
  strip_scene(*scene);
  if (extension_of(path) == ".3ds") undo_3ds_turn(*scene);
  join_corners(*scene);
  bake_transforms(*scene);
  check_scene(file, *scene);  // a transform may overflow, and parts that no node shows are gone
  return Mesh(std::move(scene), path.filename().string());
}

}  // namespace hwffd
