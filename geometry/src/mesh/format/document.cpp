#include "mesh/format/document.hpp"

#include <fmt/format.h>

#include <limits>
#include <utility>

#include "hwffd/error.hpp"
#include "mesh/formats.hpp"
#include "mesh/read_scene.hpp"

namespace hwffd {
namespace {

void check_positions(const Points& positions) {
  if (positions.rows() == 0) throw Error(fmt::format("holds no vertices; {}", kAcceptedMeshes));
  for (Eigen::Index v = 0; v < positions.rows(); ++v) {
    if (positions.row(v).cast<float>().allFinite()) continue;
    throw Error(fmt::format(
        "vertex {} has a coordinate that is not a finite binary32 number; repair or scale the mesh",
        v));
  }
}

void check_corners(const Content& content) {
  for (std::size_t f = 0; f < content.face_count(); ++f) {
    for (std::size_t c = content.face_begin(f); c < content.face_end(f); ++c) {
      if (content.corners[c] < content.vertex_count()) continue;
      throw Error(fmt::format("face {} refers to vertex {} of {}; repair the mesh", f,
                              content.corners[c], content.vertex_count()));
    }
  }
}

template <int N>
void check_rows(const Values<N>& values, const char* what) {
  const auto rows = static_cast<std::size_t>(values.rows.rows());
  for (const std::uint32_t row : values.of_corner) {
    if (row == kNone || row < rows) continue;
    throw Error(fmt::format("a face refers to {} {} of {}; repair the mesh", what, row, rows));
  }
}

/// A normal with a number that is not finite is none.
void forget_broken_normals(Content& content) {
  for (Eigen::Index row = 0; row < content.normals.rows.rows(); ++row) {
    if (content.normals.rows.row(row).allFinite()) continue;
    content.normals.rows.row(row).setConstant(std::numeric_limits<float>::quiet_NaN());
  }
}

/// What whoever moves a mesh relies on.
void check(const Content& content) {
  check_positions(content.positions);
  check_corners(content);
  check_rows(content.normals, "normal");
  for (const auto& set : content.textures) check_rows(set, "texture coordinate");
  for (const auto& set : content.colours) check_rows(set, "colour");
}

}  // namespace

std::unique_ptr<Document> read_document(MeshFormat::Read read, const std::filesystem::path& path,
                                        std::string bytes) {
  std::unique_ptr<Document> document = read(path, std::move(bytes));
  forget_broken_normals(document->content());
  check(document->content());
  return document;
}

}  // namespace hwffd
