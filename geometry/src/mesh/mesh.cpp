#include "hwffd/mesh/mesh.hpp"

#include <assimp/scene.h>
#include <fmt/format.h>

#include <algorithm>
#include <cstring>

#include "hwffd/error.hpp"
#include "mesh/normals.hpp"
#include "mesh/read_scene.hpp"
#include "mesh/scene.hpp"

namespace hwffd {
namespace {

using PositionKey = std::array<std::uint32_t, 3>;

std::size_t hash_of(const PositionKey& key) {
  std::uint64_t hash = 0;
  for (const std::uint32_t word : key) {
    hash = (hash ^ word) * 0x9e3779b97f4a7c15ull;
    hash ^= hash >> 29;
  }
  return static_cast<std::size_t>(hash);
}

/// The bits of a position; -0 and +0 are equal.
PositionKey key_of(const aiVector3D& p) {
  const std::array<float, 3> values{p.x + 0.0f, p.y + 0.0f, p.z + 0.0f};
  PositionKey key{};
  std::memcpy(key.data(), values.data(), sizeof(key));
  return key;
}

/// Numbers positions in the order in which they are first seen. Of one table of whole numbers,
/// since a node for each of millions of positions costs more time and room than all else of a mesh.
class PositionNumbers {
 public:
  /// @param most  how many positions there may be
  explicit PositionNumbers(std::size_t most) {
    std::size_t size = 2;
    while (size < 2 * most) size *= 2;
    table_.assign(size, kFree);
  }

  std::uint32_t number_of(const PositionKey& key) {
    const std::size_t mask = table_.size() - 1;
    std::size_t at = hash_of(key) & mask;
    while (table_[at] != kFree && keys_[table_[at]] != key) at = (at + 1) & mask;
    if (table_[at] == kFree) {
      table_[at] = static_cast<std::uint32_t>(keys_.size());
      keys_.push_back(key);
    }
    return table_[at];
  }

  std::size_t count() const { return keys_.size(); }

 private:
  static constexpr std::uint32_t kFree = 0xffffffff;
  std::vector<std::uint32_t> table_;
  std::vector<PositionKey> keys_;
};

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
  std::size_t vertices = 0;
  each_part(*scene_, [&](const aiMesh& part, std::size_t) { vertices += part.mNumVertices; });
  weld_.reserve(vertices);
  PositionNumbers numbers(vertices);
  each_part(*scene_, [&](const aiMesh& part, std::size_t) {
    for (unsigned v = 0; v < part.mNumVertices; ++v) {
      weld_.push_back(numbers.number_of(key_of(part.mVertices[v])));
    }
  });
  positions_.resize(static_cast<Eigen::Index>(numbers.count()), 3);
  std::uint32_t next = 0;  // not seen yet
  each_part(*scene_, [&](const aiMesh& part, std::size_t first) {
    for (unsigned v = 0; v < part.mNumVertices; ++v) {
      if (weld_[first + v] == next) positions_.row(next++) = to_eigen(part.mVertices[v]);
    }
  });
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

bool Mesh::has_normals() const { return hwffd::has_normals(*scene_); }

Points Mesh::rounded(const Points& positions) const {
  if (positions.rows() != positions_.rows()) {
    throw Error(fmt::format("{}: {} new positions for {} vertices; give one for each vertex", name_,
                            positions.rows(), positions_.rows()));
  }
  Points rounded = positions.cast<float>().cast<double>();
  for (Eigen::Index i = 0; i < rounded.rows(); ++i) {
    if (rounded.row(i).allFinite()) continue;
    throw Error(
        fmt::format("{}: new position of vertex {} is not a finite binary32 number; "
                    "check the control points",
                    name_, i));
  }
  return rounded;
}

void Mesh::move(Points positions) {
  positions_ = std::move(positions);
  each_part(*scene_, [&](aiMesh& part, std::size_t first) {
    for (unsigned v = 0; v < part.mNumVertices; ++v) {
      const Eigen::RowVector3f p = positions_.row(weld_[first + v]).cast<float>();
      part.mVertices[v] = aiVector3D(p.x(), p.y(), p.z());
    }
  });
}

void Mesh::set_positions(const Points& positions) {
  move(rounded(positions));
  orient_faces(false);
  normals_->follow_faces(*scene_);
}

void Mesh::set_positions(const Points& positions, const std::vector<Eigen::Matrix3d>& gradients) {
  Points to = rounded(positions);
  if (gradients.size() != vertex_count()) {
    throw Error(fmt::format("{}: {} gradients for {} vertices; give one for each vertex", name_,
                            gradients.size(), vertex_count()));
  }
  move(std::move(to));
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
