#include "hwffd/mesh/mesh.hpp"

#include <assimp/scene.h>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

#include "hwffd/error.hpp"
#include "mesh/format/document.hpp"
#include "mesh/format/scene_of.hpp"
#include "mesh/normals.hpp"
#include "mesh/read_scene.hpp"
#include "mesh/scene.hpp"
#include "mesh/tangents.hpp"
#include "mesh/weld.hpp"

namespace hwffd {

Points settled(Points positions, const Points& rest) {
  constexpr double kRounding = 0x1p-50;  // of a double, a few times
  const double most = rest.rows() == 0 ? 0.0 : kRounding * rest.cwiseAbs().maxCoeff();
  for (Eigen::Index row = 0; row < rest.rows(); ++row) {
    for (int axis = 0; axis < 3; ++axis) {
      const bool stays = std::abs(positions(row, axis) - rest(row, axis)) <= most;
      if (stays) positions(row, axis) = rest(row, axis);
    }
  }
  return positions;
}

/// The scene of a mesh and where its vertices come from.
struct Mesh::Scene {
  ContentScene built;
  std::vector<std::uint32_t> welded;   ///< scene vertex -> welded vertex
  std::vector<std::uint32_t> numbers;  ///< scene vertex -> vertex of the file
};

Mesh::Mesh(Mesh&& other) noexcept = default;
Mesh& Mesh::operator=(Mesh&& other) noexcept = default;
Mesh::~Mesh() = default;

Mesh::Mesh(std::unique_ptr<aiScene> scene, std::string name)
    : name_(std::move(name)), content_(std::make_unique<Content>(content_of(*scene))) {
  weld();
  scene_ = std::make_unique<Scene>();
  std::vector<std::uint32_t>& vertices = scene_->built.vertices;
  vertices.resize(weld_.size());
  std::iota(vertices.begin(), vertices.end(), 0u);
  if (!content_->normals.empty()) scene_->built.normals = vertices;
  scene_->built.scene = std::move(scene);
  scene_->welded = weld_;
  scene_->numbers = weld_;
}

Mesh::Mesh(ReadScene read, const std::filesystem::path& path)
    : Mesh(std::move(read.scene), path.filename().string()) {
  is_numbered_ = !read.numbers.empty();
  if (is_numbered_) scene_->numbers = std::move(read.numbers);
  dropped_ = std::move(read.dropped);
  inputs_ = {path};
  folder_ = std::filesystem::absolute(path).parent_path();
  content_->space = read.space;
}

Mesh::Mesh(std::unique_ptr<Document> document, const std::filesystem::path& path)
    : name_(path.filename().string()),
      document_(std::move(document)),
      content_(std::make_unique<Content>(std::move(document_->content()))),
      is_numbered_(content_->is_numbered),
      dropped_(content_->extras),
      inputs_(document_->companions()),
      folder_(std::filesystem::absolute(path).parent_path()) {
  inputs_.push_back(path);
  weld();
}

void Mesh::weld() {
  Welded welded = hwffd::weld(std::move(content_->positions));
  positions_ = std::move(welded.positions);
  weld_ = std::move(welded.vertices);
  normals_ = std::make_unique<FollowingNormals>(*content_, weld_, positions_);
  tangents_ = std::make_unique<FollowingTangents>(*content_);
}

const std::vector<Mesh::Triangle>& Mesh::triangles() const {
  if (triangles_) return *triangles_;
  triangles_.emplace();
  triangles_->reserve(content_->corners.size() / 3);
  for (std::size_t f = 0; f < content_->face_count(); ++f) {
    const std::size_t begin = content_->face_begin(f);
    const std::size_t corners = content_->face_end(f) - begin;
    // The first corner stays the first of a face that is turned round.
    const auto vertex = [&](std::size_t c) {
      return weld_[content_->corners[begin + (turned_ && c > 0 ? corners - c : c)]];
    };
    for (std::size_t c = 2; c < corners; ++c) {
      triangles_->push_back({vertex(0), vertex(c - 1), vertex(c)});
    }
  }
  return *triangles_;
}

const std::vector<std::string>& Mesh::unfollowed() const { return content_->unfollowed; }

bool Mesh::is_single() const { return content_->is_single; }

bool Mesh::has_normals() const { return !content_->normals.empty(); }

Points Mesh::rounded(const Points& positions) const {
  if (positions.rows() != positions_.rows()) {
    throw Error(fmt::format("{}: {} new positions for {} vertices; give one for each vertex", name_,
                            positions.rows(), positions_.rows()));
  }
  for (Eigen::Index i = 0; i < positions.rows(); ++i) {
    if (positions.row(i).cast<float>().allFinite()) continue;
    throw Error(
        fmt::format("{}: new position of vertex {} is not a finite binary32 number; "
                    "check the control points",
                    name_, i));
  }
  Points to = settled(positions, rest());
  if (is_single()) to = to.cast<float>().cast<double>();
  return to;
}

const Points& Mesh::rest() const { return rest_.rows() == 0 ? positions_ : rest_; }

void Mesh::move(Points positions, bool turned) {
  if (rest_.rows() == 0) rest_ = std::move(positions_);
  positions_ = std::move(positions);
  if (turned == turned_) return;
  turned_ = turned;
  triangles_.reset();
  if (!scene_) return;
  each_part(*scene_->built.scene, [](aiMesh& part, std::size_t) { turn_faces(part); });
}

void Mesh::set_positions(const Points& positions) {
  move(rounded(positions), false);
  normals_->follow_faces(*content_, positions_, 1.0);
  tangents_->follow(*content_, weld_, {}, false);
  update_scene();
}

void Mesh::set_positions(const Points& positions, const std::vector<Eigen::Matrix3d>& gradients) {
  Points to = rounded(positions);
  if (gradients.size() != vertex_count()) {
    throw Error(fmt::format("{}: {} gradients for {} vertices; give one for each vertex", name_,
                            gradients.size(), vertex_count()));
  }
  move(std::move(to), is_mirror(gradients));
  normals_->follow(*content_, positions_, gradients, turned_ ? -1.0 : 1.0);
  tangents_->follow(*content_, weld_, gradients, turned_);
  update_scene();
}

Mesh::Scene& Mesh::edited() const {
  if (scene_) return *scene_;
  auto scene = std::make_unique<Scene>();
  scene->built = scene_of(*content_, weld_.size(), [&](std::uint32_t vertex) -> Eigen::RowVector3d {
    return positions_.row(weld_[vertex]);
  });
  for (const std::uint32_t vertex : scene->built.vertices) scene->welded.push_back(weld_[vertex]);
  scene->numbers = is_numbered_ ? scene->built.vertices : scene->welded;
  if (turned_) {
    each_part(*scene->built.scene, [](aiMesh& part, std::size_t) { turn_faces(part); });
  }
  scene_ = std::move(scene);
  return *scene_;
}

void Mesh::update_scene() const {
  if (!scene_) return;
  each_part(*scene_->built.scene, [&](aiMesh& part, std::size_t first) {
    for (unsigned v = 0; v < part.mNumVertices; ++v) {
      const Eigen::RowVector3f p = positions_.row(scene_->welded[first + v]).cast<float>();
      part.mVertices[v] = aiVector3D(p.x(), p.y(), p.z());
      if (!part.HasNormals() || scene_->built.normals[first + v] == kNone) continue;
      const Eigen::RowVector3f n = content_->normals.rows.row(scene_->built.normals[first + v]);
      part.mNormals[v] = aiVector3D(n.x(), n.y(), n.z());
    }
  });
}

aiScene& Mesh::mutable_scene() const { return *edited().built.scene; }

const aiScene& Mesh::scene() const { return mutable_scene(); }

const std::vector<std::uint32_t>& Mesh::welded() const { return edited().welded; }

const std::vector<std::uint32_t>& Mesh::numbers() const { return edited().numbers; }

Points Mesh::smooth_normals() const { return hwffd::smooth_normals(positions_, triangles()); }

}  // namespace hwffd
