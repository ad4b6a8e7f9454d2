#include "hwffd/mesh/mesh.hpp"

#include <assimp/scene.h>
#include <fmt/format.h>

#include <algorithm>
#include <cstring>
#include <limits>
#include <unordered_map>

#include "hwffd/error.hpp"
#include "mesh/normals.hpp"
#include "mesh/read_scene.hpp"
#include "mesh/scene.hpp"

namespace hwffd {
namespace {

using PositionKey = std::array<std::uint32_t, 3>;

struct PositionHash {
  std::size_t operator()(const PositionKey& key) const {
    std::uint64_t hash = 0;
    for (const std::uint32_t word : key) {
      hash = (hash ^ word) * 0x9e3779b97f4a7c15ull;
      hash ^= hash >> 29;
    }
    return static_cast<std::size_t>(hash);
  }
};

/// The bits of a position; -0 and +0 are equal.
PositionKey key_of(const aiVector3D& p) {
  const std::array<float, 3> values{p.x + 0.0f, p.y + 0.0f, p.z + 0.0f};
  PositionKey key{};
  std::memcpy(key.data(), values.data(), sizeof(key));
  return key;
}

}  // namespace

void Mesh::SceneDeleter::operator()(aiScene* scene) const { delete scene; }

Mesh::Mesh(Mesh&& other) noexcept = default;
Mesh& Mesh::operator=(Mesh&& other) noexcept = default;
Mesh::~Mesh() = default;

Mesh::Mesh(ScenePtr scene, std::string name) : scene_(std::move(scene)), name_(std::move(name)) {
  weld();
  numbers_ = weld_;
  read_count_ = weld_.size();
  find_triangles();
  normals_ = std::make_unique<SceneNormals>(*scene_, weld_);
}

Mesh::Mesh(ReadScene read, const std::filesystem::path& path)
    : Mesh(ScenePtr(read.scene.release()), path.filename().string()) {
  if (!read.numbers.empty()) {
    is_numbered_ = true;
    numbers_ = std::move(read.numbers);
    read_count_ = std::size_t{*std::max_element(numbers_.begin(), numbers_.end())} + 1;
  }
  dropped_ = std::move(read.dropped);
  folder_ = std::filesystem::absolute(path).parent_path();
  unit_ = read.unit;
}

void Mesh::weld() {
  std::unordered_map<PositionKey, std::uint32_t, PositionHash> seen;
  std::vector<Eigen::Vector3d> unique;
  each_part(*scene_, [&](const aiMesh& part, std::size_t) {
    for (unsigned v = 0; v < part.mNumVertices; ++v) {
      const auto [entry, is_new] =
          seen.emplace(key_of(part.mVertices[v]), static_cast<std::uint32_t>(unique.size()));
      if (is_new) unique.push_back(to_eigen(part.mVertices[v]));
      weld_.push_back(entry->second);
    }
  });
  positions_.resize(static_cast<Eigen::Index>(unique.size()), 3);
  for (std::size_t i = 0; i < unique.size(); ++i) {
    positions_.row(static_cast<Eigen::Index>(i)) = unique[i];
  }
}

void Mesh::find_triangles() {
  triangles_.clear();
  each_part(*scene_, [&](const aiMesh& part, std::size_t first) {
    for (unsigned f = 0; f < part.mNumFaces; ++f) {
      const aiFace& face = part.mFaces[f];
      for (unsigned c = 2; c < face.mNumIndices; ++c) {
        triangles_.push_back({weld_[first + face.mIndices[0]], weld_[first + face.mIndices[c - 1]],
                              weld_[first + face.mIndices[c]]});
      }
    }
  });
}

void Mesh::set_positions(const Points& positions) {
  constexpr double kUnknown = std::numeric_limits<double>::quiet_NaN();
  const std::vector<Eigen::Matrix3d> unknown(vertex_count(), Eigen::Matrix3d::Constant(kUnknown));
  set_positions(positions, unknown);
}

void Mesh::set_positions(const Points& positions, const std::vector<Eigen::Matrix3d>& gradients) {
  if (positions.rows() != positions_.rows()) {
    throw Error(fmt::format("{}: {} new positions for {} vertices; give one for each vertex", name_,
                            positions.rows(), positions_.rows()));
  }
  if (gradients.size() != vertex_count()) {
    throw Error(fmt::format("{}: {} gradients for {} vertices; give one for each vertex", name_,
                            gradients.size(), vertex_count()));
  }
  const Points rounded = positions.cast<float>().cast<double>();
  for (Eigen::Index i = 0; i < rounded.rows(); ++i) {
    if (rounded.row(i).allFinite()) continue;
    throw Error(
        fmt::format("{}: new position of vertex {} is not a finite binary32 number; "
                    "check the control points",
                    name_, i));
  }
  positions_ = rounded;
  each_part(*scene_, [&](aiMesh& part, std::size_t first) {
    for (unsigned v = 0; v < part.mNumVertices; ++v) {
      const Eigen::RowVector3f p = positions_.row(weld_[first + v]).cast<float>();
      part.mVertices[v] = aiVector3D(p.x(), p.y(), p.z());
    }
  });
  orient_faces(is_mirror(gradients));
  normals_->follow(*scene_, gradients, turned_ ? -1.0 : 1.0);
}

void Mesh::orient_faces(bool turned) {
  if (turned == turned_) return;
  turned_ = turned;
  each_part(*scene_, [](aiMesh& part, std::size_t) { turn_faces(part); });
  find_triangles();
}

Points Mesh::smooth_normals() const { return hwffd::smooth_normals(positions_, triangles_); }

}  // namespace hwffd
