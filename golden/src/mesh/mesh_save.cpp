#include <assimp/SceneCombiner.h>
#include <assimp/postprocess.h>
#include <assimp/scene.h>
#include <fmt/format.h>

#include <algorithm>
#include <assimp/Exporter.hpp>
#include <map>
#include <memory>

#include "hwffd/atomic_file.hpp"
#include "hwffd/error.hpp"
#include "hwffd/mesh/extension.hpp"
#include "hwffd/mesh/mesh.hpp"
#include "mesh/memory_io.hpp"
#include "mesh/scene.hpp"

namespace hwffd {
namespace {

namespace fs = std::filesystem;

/// Assimp's exporters by extension.
const std::map<std::string, std::string>& exporters() {
  static const std::map<std::string, std::string> kExporters = {
      {".obj", "obj"},  {".ply", "plyb"},   {".stl", "stlb"},
      {".glb", "glb2"}, {".gltf", "gltf2"}, {".dae", "collada"}};
  return kExporters;
}

std::string exporter_for(const fs::path& path) {
  const auto entry = exporters().find(extension_of(path));
  if (entry != exporters().end()) return entry->second;
  const std::string extension = path.extension().string();
  throw UsageError(fmt::format(
      "{}: cannot write {}; use the extension obj, ply, stl, glb, gltf "
      "or dae",
      path.string(), extension.empty() ? "without an extension" : extension + " meshes"));
}

bool has_colours(const aiScene& scene) {
  bool found = false;
  each_part(scene,
            [&](const aiMesh& part, std::size_t) { found = found || part.HasVertexColors(0); });
  return found;
}

/// Corners of the largest face.
unsigned most_corners(const aiScene& scene) {
  unsigned most = 0;
  each_part(scene, [&](const aiMesh& part, std::size_t) {
    for (unsigned f = 0; f < part.mNumFaces; ++f) {
      most = std::max(most, part.mFaces[f].mNumIndices);
    }
  });
  return most;
}

/// What Assimp is asked for, so that it writes all that the format can hold.
struct Export {
  std::string exporter;
  unsigned steps = 0;                  ///< of Assimp, beside the exporter's own
  void (*change)(aiScene&) = nullptr;  ///< to a copy of the scene
};

Export export_for(const fs::path& path, const aiScene& scene) {
  Export result;
  result.exporter = exporter_for(path);
  if (result.exporter == "obj") result.change = name_parts_after_nodes;
  if (result.exporter == "plyb") {
    // The binary exporter writes colours as floats below a header that says bytes.
    if (has_colours(scene)) result.exporter = "ply";
    constexpr unsigned kMostCorners = 255;  // their number is written as a byte
    if (most_corners(scene) > kMostCorners) result.steps = aiProcess_Triangulate;
  }
  if (result.exporter == "stlb") {
    if (most_corners(scene) < 3) {
      throw Error(
          fmt::format("{}: the mesh has no faces, and stl holds nothing else; use obj, ply or glb",
                      path.string()));
    }
    // The exporter counts points and lines, but does not write them.
    result.change = drop_points_and_lines;
  }
  return result;
}

std::unique_ptr<aiScene> changed_copy(const aiScene& scene, void (*change)(aiScene&)) {
  aiScene* copy = nullptr;
  Assimp::SceneCombiner::CopyScene(&copy, &scene);
  std::unique_ptr<aiScene> owned(copy);
  change(*owned);
  return owned;
}

}  // namespace

bool Mesh::can_save(const fs::path& path) { return exporters().count(extension_of(path)) != 0; }

void Mesh::check_format(const fs::path& path) { exporter_for(path); }

void Mesh::save(const fs::path& path) const {
  const Export how = export_for(path, *scene_);
  const std::unique_ptr<aiScene> copy = how.change ? changed_copy(*scene_, how.change) : nullptr;
  const std::string name = path.filename().string();
  Assimp::Exporter exporter;
  auto* memory = new MemoryIo();  // owned by the exporter
  exporter.SetIOHandler(memory);
  const aiScene* const scene = copy ? copy.get() : scene_.get();
  if (exporter.Export(scene, how.exporter, name, how.steps) != aiReturn_SUCCESS) {
    throw Error(fmt::format("{}: cannot write the mesh ({}); try another format", path.string(),
                            exporter.GetErrorString()));
  }
  std::vector<FileContent> files;
  for (const auto& [file, bytes] : memory->files()) {
    if (file != name) files.push_back({path.parent_path() / fs::path(file).filename(), bytes});
  }
  files.push_back({path, memory->files().at(name)});
  write_files(files);
}

}  // namespace hwffd
