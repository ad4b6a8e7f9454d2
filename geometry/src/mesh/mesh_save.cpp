#include <assimp/scene.h>
#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <numeric>
#include <system_error>

#include "hwffd/atomic_file.hpp"
#include "hwffd/error.hpp"
#include "hwffd/mesh/mesh.hpp"
#include "mesh/format/document.hpp"
#include "mesh/formats.hpp"
#include "mesh/mesh_writers.hpp"
#include "mesh/normals.hpp"
#include "mesh/scene.hpp"

namespace hwffd {
namespace {

namespace fs = std::filesystem;

/// What can be written, as in "obj, ply or off".
std::string written_extensions() {
  std::vector<std::string> names;
  for (const MeshFormat& format : mesh_formats()) {
    if (format.write != nullptr) names.emplace_back(format.extension + 1);
  }
  const std::string last = names.back();
  names.pop_back();
  return fmt::format("{} or {}", fmt::join(names, ", "), last);
}

MeshFormat::Write writer_for(const fs::path& path) {
  const MeshFormat* format = format_of(path);
  if (format != nullptr && format->write != nullptr) return format->write;
  const std::string extension = path.extension().string();
  throw UsageError(fmt::format("{}: cannot write {}; use the extension {}", path.string(),
                               extension.empty() ? "without an extension" : extension + " meshes",
                               written_extensions()));
}

/// A file that is written beside the one that is named never takes the place of one that was read.
void refuse_inputs(const Files& contents, const fs::path& path,
                   const std::vector<fs::path>& inputs) {
  for (const auto& [name, bytes] : contents) {
    const fs::path target = path.parent_path() / name;
    for (const fs::path& input : inputs) {
      std::error_code ignored;
      if (name == path.filename().string() || !fs::equivalent(target, input, ignored)) continue;
      throw Error(fmt::format(
          "{}, which goes beside it, would replace a file that the mesh was read from; name the "
          "output otherwise",
          target.string()));
    }
  }
}

std::size_t count_of(const Output& output) {
  return std::size_t{*std::max_element(output.numbers.begin(), output.numbers.end())} + 1;
}

}  // namespace

Points numbered_positions(const Output& output) {
  Points positions(static_cast<Eigen::Index>(count_of(output)), 3);
  for (std::size_t v = 0; v < output.numbers.size(); ++v) {
    positions.row(output.numbers[v]) = output.positions.row(output.welded[v]);
  }
  return positions;
}

bool repeats_vertices(const Output& output) { return output.numbers.size() > count_of(output); }

std::vector<std::uint32_t> rows_of(const Output& output) {
  if (!repeats_vertices(output)) return output.numbers;
  std::vector<std::uint32_t> rows(output.numbers.size());
  std::iota(rows.begin(), rows.end(), 0u);
  return rows;
}

bool Mesh::can_save(const fs::path& path) {
  const MeshFormat* format = format_of(path);
  return format != nullptr && format->write != nullptr;
}

void Mesh::check_format(const fs::path& path) { writer_for(path); }

bool Mesh::edits(const fs::path& path) const { return document_ && document_->is_of(path); }

std::vector<std::string> Mesh::save(const fs::path& path) const {
  const MeshFormat::Write write = writer_for(path);
  const bool is_edit = edits(path);
  Files contents;
  try {
    if (is_edit) {
      contents = document_->edited(
          {positions_, weld_, content_->normals, normals_->origins(), content_->tangents, turned_},
          path);
    } else {
      const Output output{scene(),   positions_, welded(), is_single(),
                          numbers(), path,       folder_,  content_->space};
      contents = write(output);
    }
    refuse_inputs(contents, path, inputs_);
  } catch (const Error& error) {
    throw Error(fmt::format("{}: {}", path.string(), error.what()));
  }
  const std::string name = path.filename().string();
  std::vector<FileContent> files;
  for (auto& [file, bytes] : contents) {
    if (file != name) files.push_back({path.parent_path() / file, std::move(bytes)});
  }
  files.push_back({path, std::move(contents.at(name))});
  write_files(files);
  std::error_code ignored;
  if (is_edit || !fs::is_regular_file(path, ignored)) return {};
  try {
    return lost_in(load(path));
  } catch (const Error&) {  // it takes names that no reader takes
    return {"names that can be read again"};
  }
}

}  // namespace hwffd
