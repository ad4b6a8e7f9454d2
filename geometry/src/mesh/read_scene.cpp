#include "mesh/read_scene.hpp"

#include <assimp/DefaultIOSystem.h>
#include <assimp/MemoryIOWrapper.h>
#include <assimp/config.h>
#include <fmt/format.h>

#include <algorithm>
#include <assimp/Importer.hpp>
#include <cmath>
#include <filesystem>
#include <numeric>
#include <set>

#include "hwffd/excerpt.hpp"
#include "hwffd/mesh/extension.hpp"
#include "mesh/scene.hpp"

namespace hwffd {
namespace {

/// What Assimp's readers see: the bytes of one file, and beside it the files that it refers to.
/// Those are regular files: a pipe or a device might never end.
class SourceIo : public Assimp::DefaultIOSystem {
 public:
  SourceIo(std::string name, const std::string& bytes) : name_(std::move(name)), bytes_(bytes) {}

  bool Exists(const char* name) const override {
    std::error_code ignored;
    return name == name_ || std::filesystem::is_regular_file(name, ignored);
  }

  Assimp::IOStream* Open(const char* name, const char* mode) override {
    if (!Exists(name)) return nullptr;
    if (name != name_) return DefaultIOSystem::Open(name, mode);
    return new Assimp::MemoryIOStream(reinterpret_cast<const std::uint8_t*>(bytes_.data()),
                                      bytes_.size());
  }

 private:
  std::string name_;
  const std::string& bytes_;
};

/// What Assimp says, which may quote a line of the file.
std::string reason_of(const Assimp::Importer& importer) {
  std::string text = importer.GetErrorString();
  while (!text.empty() && (text.back() == ' ' || text.back() == '.' || text.back() == '\n')) {
    text.pop_back();
  }
  std::replace(text.begin(), text.end(), '\n', ' ');
  return excerpt(text);
}

std::unique_ptr<aiScene> import(const std::string& name, const std::string& bytes) {
  Assimp::Importer importer;
  importer.SetIOHandler(new SourceIo(name, bytes));  // owned by the importer
  // Where nodes show no mesh, it would make one of them.
  importer.SetPropertyBool(AI_CONFIG_IMPORT_NO_SKELETON_MESHES, true);
  if (importer.ReadFile(name, 0) == nullptr) throw not_a_mesh(reason_of(importer));
  std::unique_ptr<aiScene> scene(importer.GetOrphanedScene());
  if (scene->mRootNode == nullptr) throw not_a_mesh("no scene");
  return scene;
}

void check_part(const aiMesh& mesh) {
  for (unsigned v = 0; v < mesh.mNumVertices; ++v) {
    const aiVector3D& p = mesh.mVertices[v];
    if (!std::isfinite(p.x) || !std::isfinite(p.y) || !std::isfinite(p.z)) {
      throw Error(fmt::format(
          "vertex {} has a coordinate that is not a finite binary32 number; repair or scale the "
          "mesh",
          v));
    }
  }
  for (unsigned f = 0; f < mesh.mNumFaces; ++f) {
    const aiFace& face = mesh.mFaces[f];
    for (unsigned c = 0; c < face.mNumIndices; ++c) {
      if (face.mIndices[c] < mesh.mNumVertices) continue;
      throw Error(fmt::format("face {} refers to vertex {} of {}; repair the mesh", f,
                              face.mIndices[c], mesh.mNumVertices));
    }
  }
}

/// Formats whose vertices Assimp hands on as the file numbers them. The readers of the others give
/// each corner of a face a vertex of its own.
bool is_numbered(const std::string& extension) {
  static const std::set<std::string> kNumbered{".gltf", ".glb"};
  return kNumbered.count(extension) != 0;
}

std::vector<std::uint32_t> one_after_another(const aiScene& scene) {
  std::size_t vertices = 0;
  each_part(scene, [&](const aiMesh& part, std::size_t) { vertices += part.mNumVertices; });
  std::vector<std::uint32_t> numbers(vertices);
  std::iota(numbers.begin(), numbers.end(), 0u);
  return numbers;
}

}  // namespace

void check_scene(const aiScene& scene) {
  std::size_t vertices = 0;
  for (unsigned m = 0; m < scene.mNumMeshes; ++m) {
    check_part(*scene.mMeshes[m]);
    vertices += scene.mMeshes[m]->mNumVertices;
  }
  if (vertices == 0 || scene.mRootNode == nullptr) {
    throw Error(fmt::format("holds no vertices; {}", kAcceptedMeshes));
  }
}

ReadScene read_scene(const std::filesystem::path& path, const std::string& bytes) {
  const std::string extension = extension_of(path);
  ReadScene read;
  read.scene = import(path.string(), bytes);
  aiScene& scene = *read.scene;
  check_scene(scene);
  read.dropped = strip_scene(scene);
  if (extension == ".3ds") undo_3ds_turn(scene);
  if (extension == ".dae" || extension == ".zae") read.space = take_space(scene);
  if (!is_numbered(extension)) join_corners(scene);
  bake_transforms(scene);
  if (is_numbered(extension)) read.numbers = one_after_another(scene);
  check_scene(scene);  // a transform may overflow, and parts that no node shows are gone
  return read;
}

}  // namespace hwffd
