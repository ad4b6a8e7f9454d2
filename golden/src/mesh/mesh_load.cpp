#include <assimp/scene.h>
#include <fmt/format.h>

#include <algorithm>
#include <assimp/Importer.hpp>
#include <cmath>
#include <system_error>

#include "hwffd/error.hpp"
#include "hwffd/mesh/mesh.hpp"
#include "mesh/scene.hpp"

namespace hwffd {
namespace {

namespace fs = std::filesystem;

constexpr const char* kAccepted =
    "accepted are obj, ply, stl, 3ds, glb, gltf, dae and what else Assimp reads";

std::string one_line(std::string text) {
  std::replace(text.begin(), text.end(), '\n', ' ');
  while (!text.empty() && (text.back() == ' ' || text.back() == '.')) text.pop_back();
  return text;
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

bool is_3ds(const fs::path& path) {
  std::string extension = path.extension().string();
  std::transform(extension.begin(), extension.end(), extension.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return extension == ".3ds";
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
  Assimp::Importer importer;
  if (importer.ReadFile(file, 0) == nullptr) {
    throw Error(fmt::format("{}: not a mesh that can be read ({}); {}", file,
                            one_line(importer.GetErrorString()), kAccepted));
  }
  ScenePtr scene(importer.GetOrphanedScene());
  check_scene(file, *scene);
  strip_scene(*scene);
  if (is_3ds(path)) undo_3ds_turn(*scene);
  join_corners(*scene);
  bake_transforms(*scene);
  check_scene(file, *scene);  // a transform may overflow, and parts that no node shows are gone
  return Mesh(std::move(scene), path.filename().string());
}

}  // namespace hwffd
