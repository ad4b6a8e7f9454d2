#include <assimp/scene.h>
#include <fmt/format.h>

#include <algorithm>
#include <assimp/Exporter.hpp>
#include <cctype>
#include <map>

#include "hwffd/atomic_file.hpp"
#include "hwffd/error.hpp"
#include "hwffd/mesh/mesh.hpp"
#include "mesh/memory_io.hpp"

namespace hwffd {
namespace {

namespace fs = std::filesystem;

/// Assimp's exporter for the path's extension.
std::string exporter_for(const fs::path& path) {
  static const std::map<std::string, std::string> kExporters = {
      {".obj", "obj"},  {".ply", "plyb"},   {".stl", "stlb"},
      {".glb", "glb2"}, {".gltf", "gltf2"}, {".dae", "collada"}};
  std::string extension = path.extension().string();
  std::transform(extension.begin(), extension.end(), extension.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  const auto entry = kExporters.find(extension);
  if (entry != kExporters.end()) return entry->second;
  throw Error(fmt::format(
      "{}: cannot write {}; use the extension obj, ply, stl, glb, gltf "
      "or dae",
      path.string(), extension.empty() ? "without an extension" : extension + " meshes"));
}

}  // namespace

void Mesh::save(const fs::path& path) const {
  const std::string exporter_id = exporter_for(path);
  const std::string name = path.filename().string();
  Assimp::Exporter exporter;
  auto* memory = new MemoryIo();  // owned by the exporter
  exporter.SetIOHandler(memory);
  if (exporter.Export(scene_.get(), exporter_id, name) != aiReturn_SUCCESS) {
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
