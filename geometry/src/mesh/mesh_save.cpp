#include <assimp/scene.h>
#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <numeric>

#include "hwffd/atomic_file.hpp"
#include "hwffd/error.hpp"
#include "hwffd/mesh/extension.hpp"
#include "hwffd/mesh/mesh.hpp"
#include "mesh/mesh_writers.hpp"
#include "mesh/scene.hpp"

namespace hwffd {
namespace {

namespace fs = std::filesystem;

using Writer = Files (*)(const Output&);

/// By extension.
const std::map<std::string, Writer>& writers() {
  static const std::map<std::string, Writer> kWriters = {
      {".obj", write_obj},  {".ply", write_ply},   {".off", write_off}, {".stl", write_stl},
      {".glb", write_gltf}, {".gltf", write_gltf}, {".dae", write_dae}};
  return kWriters;
}

Writer writer_for(const fs::path& path) {
  const auto entry = writers().find(extension_of(path));
  if (entry != writers().end()) return entry->second;
  const std::string extension = path.extension().string();
  throw UsageError(fmt::format(
      "{}: cannot write {}; use the extension obj, ply, off, stl, glb, gltf or dae", path.string(),
      extension.empty() ? "without an extension" : extension + " meshes"));
}

std::size_t count_of(const Output& output) {
  return std::size_t{*std::max_element(output.numbers.begin(), output.numbers.end())} + 1;
}

}  // namespace

std::vector<aiVector3D> numbered_positions(const Output& output) {
  std::vector<aiVector3D> positions(count_of(output));
  each_part(output.scene, [&](const aiMesh& part, std::size_t first) {
    for (unsigned v = 0; v < part.mNumVertices; ++v) {
      positions[output.numbers[first + v]] = part.mVertices[v];
    }
  });
  return positions;
}

bool repeats_vertices(const Output& output) { return output.numbers.size() > count_of(output); }

std::vector<std::uint32_t> rows_of(const Output& output) {
  if (!repeats_vertices(output)) return output.numbers;
  std::vector<std::uint32_t> rows(output.numbers.size());
  std::iota(rows.begin(), rows.end(), 0u);
  return rows;
}

bool Mesh::can_save(const fs::path& path) { return writers().count(extension_of(path)) != 0; }

void Mesh::check_format(const fs::path& path) { writer_for(path); }

std::vector<std::string> Mesh::save(const fs::path& path) const {
  const Output output{*scene_, numbers_, path, folder_, unit_};
  const Writer write = writer_for(path);
  Files made;
  try {
    made = write(output);
  } catch (const Error& error) {
    throw Error(fmt::format("{}: {}", path.string(), error.what()));
  }
  const std::string name = path.filename().string();
  std::vector<FileContent> files;
  for (auto& [file, bytes] : made) {
    if (file != name) files.push_back({path.parent_path() / file, std::move(bytes)});
  }
  files.push_back({path, std::move(made.at(name))});
  write_files(files);
  return losses_of(output, is_numbered_);
}

}  // namespace hwffd
