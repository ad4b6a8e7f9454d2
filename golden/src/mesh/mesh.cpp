#include "hwffd/mesh/mesh.hpp"

#include <assimp/scene.h>
#include <fmt/format.h>

#include <Eigen/Geometry>
#include <cmath>
#include <cstring>
#include <unordered_map>

#include "hwffd/error.hpp"

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

Eigen::Vector3d to_eigen(const aiVector3D& p) { return {p.x, p.y, p.z}; }

/// Calls f(part, index of its first vertex) for every part of the scene.
template <typename F>
void each_part(const aiScene& scene, F f) {
  std::size_t first = 0;
  for (unsigned m = 0; m < scene.mNumMeshes; ++m) {
    f(*scene.mMeshes[m], first);
    first += scene.mMeshes[m]->mNumVertices;
  }
}

}  // namespace

void Mesh::SceneDeleter::operator()(aiScene* scene) const { delete scene; }

Mesh::Mesh(Mesh&& other) noexcept = default;
Mesh& Mesh::operator=(Mesh&& other) noexcept = default;
Mesh::~Mesh() = default;

Mesh::Mesh(ScenePtr scene, std::string name) : scene_(std::move(scene)), name_(std::move(name)) {
  weld();
  find_triangles();
  find_normal_classes();
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

void Mesh::find_normal_classes() {
  constexpr double kSameNormal = 0.9999;  // cosine; readers repeat a normal with rounding errors
  struct Class {
    Eigen::Vector3d normal;
    std::uint32_t index;
  };
  std::vector<std::vector<Class>> at_vertex(vertex_count());
  normal_class_.assign(weld_.size(), 0);
  each_part(*scene_, [&](const aiMesh& part, std::size_t first) {
    if (!part.HasNormals()) return;
    for (unsigned v = 0; v < part.mNumVertices; ++v) {
      const Eigen::Vector3d normal = to_eigen(part.mNormals[v]).normalized();
      std::vector<Class>& classes = at_vertex[weld_[first + v]];
      std::size_t c = 0;
      while (c < classes.size() && !(classes[c].normal.dot(normal) > kSameNormal)) ++c;
      if (c == classes.size()) classes.push_back({normal, normal_classes_++});
      normal_class_[first + v] = classes[c].index;
    }
  });
}

void Mesh::update_normals() {
  std::vector<Eigen::Vector3d> sums(normal_classes_, Eigen::Vector3d::Zero());
  each_part(*scene_, [&](const aiMesh& part, std::size_t first) {
    if (!part.HasNormals()) return;
    for (unsigned f = 0; f < part.mNumFaces; ++f) {
      const aiFace& face = part.mFaces[f];
      Eigen::Vector3d area = Eigen::Vector3d::Zero();
      for (unsigned c = 2; c < face.mNumIndices; ++c) {
        const Eigen::Vector3d origin = to_eigen(part.mVertices[face.mIndices[0]]);
        area += (to_eigen(part.mVertices[face.mIndices[c - 1]]) - origin)
                    .cross(to_eigen(part.mVertices[face.mIndices[c]]) - origin);
      }
      for (unsigned c = 0; c < face.mNumIndices; ++c) {
        sums[normal_class_[first + face.mIndices[c]]] += area;
      }
    }
  });
  each_part(*scene_, [&](const aiMesh& part, std::size_t first) {
    if (!part.HasNormals()) return;
    for (unsigned v = 0; v < part.mNumVertices; ++v) {
      const Eigen::Vector3d n = sums[normal_class_[first + v]].stableNormalized();
      if (n.isZero()) continue;  // no direction: the old normal stays
      part.mNormals[v] = aiVector3D(static_cast<float>(n.x()), static_cast<float>(n.y()),
                                    static_cast<float>(n.z()));
    }
  });
}

void Mesh::set_positions(const Points& positions) {
  if (positions.rows() != positions_.rows()) {
    throw Error(fmt::format("{}: {} new positions for {} vertices; give one for each vertex", name_,
                            positions.rows(), positions_.rows()));
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
  each_part(*scene_, [&](const aiMesh& part, std::size_t first) {
    for (unsigned v = 0; v < part.mNumVertices; ++v) {
      const Eigen::RowVector3f p = positions_.row(weld_[first + v]).cast<float>();
      part.mVertices[v] = aiVector3D(p.x(), p.y(), p.z());
    }
  });
  update_normals();
}

Points Mesh::smooth_normals() const {
  Points normals = Points::Zero(positions_.rows(), 3);
  for (const Triangle& t : triangles_) {
    const Eigen::Vector3d a = positions_.row(t[0]);
    const Eigen::Vector3d b = positions_.row(t[1]);
    const Eigen::Vector3d c = positions_.row(t[2]);
    const Eigen::Vector3d area = (b - a).cross(c - a);
    for (const std::uint32_t v : t) normals.row(v) += area;
  }
  for (Eigen::Index i = 0; i < normals.rows(); ++i) {
    const Eigen::Vector3d n = normals.row(i).transpose().stableNormalized();
    normals.row(i) = n.isZero() ? Eigen::Vector3d::UnitY() : n;
  }
  return normals;
}

}  // namespace hwffd
