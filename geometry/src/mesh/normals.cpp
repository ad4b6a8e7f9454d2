#include "mesh/normals.hpp"

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <algorithm>

#include "cofactor.hpp"
#include "mesh/scene.hpp"

namespace hwffd {
namespace {

constexpr double kSameNormal = 0.9999;  // cosine; readers repeat a normal with rounding errors

/// Takes the direction as a normal, if it is one.
void set_normal(aiVector3D& normal, const Eigen::Vector3d& direction) {
  const Eigen::Vector3d n = direction.stableNormalized();
  if (n.isZero() || !n.allFinite()) return;
  normal =
      aiVector3D(static_cast<float>(n.x()), static_cast<float>(n.y()), static_cast<float>(n.z()));
}

/// Area vector of a face times two.
Eigen::Vector3d area_of(const aiMesh& part, const aiFace& face) {
  Eigen::Vector3d area = Eigen::Vector3d::Zero();
  for (unsigned c = 2; c < face.mNumIndices; ++c) {
    const Eigen::Vector3d origin = to_eigen(part.mVertices[face.mIndices[0]]);
    area += (to_eigen(part.mVertices[face.mIndices[c - 1]]) - origin)
                .cross(to_eigen(part.mVertices[face.mIndices[c]]) - origin);
  }
  return area;
}

}  // namespace

Points smooth_normals(const Points& points, const std::vector<Mesh::Triangle>& triangles) {
  Points normals = Points::Zero(points.rows(), 3);
  for (const Mesh::Triangle& t : triangles) {
    const Point a = points.row(t[0]);
    const Point area = (Point(points.row(t[1])) - a).cross(Point(points.row(t[2])) - a);
    for (const std::uint32_t v : t) normals.row(v) += area;
  }
  for (Eigen::Index v = 0; v < normals.rows(); ++v) {
    const Point normal = normals.row(v).transpose().stableNormalized();
    normals.row(v) = normal.isZero() ? Point::UnitY() : normal;
  }
  return normals;
}

bool is_mirror(const std::vector<Eigen::Matrix3d>& gradients) {
  bool some = false;
  for (const Eigen::Matrix3d& gradient : gradients) {
    const double determinant = known(gradient).determinant();
    if (determinant > 0.0) return false;
    some = some || determinant < 0.0;
  }
  return some;
}

bool has_normals(const aiScene& scene) {
  bool some = false;
  each_part(scene, [&](const aiMesh& part, std::size_t) { some = some || part.HasNormals(); });
  return some;
}

SceneNormals::SceneNormals(const aiScene& scene, const std::vector<std::uint32_t>& weld)
    : weld_(weld) {
  if (!has_normals(scene)) return;
  read_.resize(weld.size(), Eigen::Vector3f::Zero());
  class_.resize(weld.size(), 0);
  each_part(scene, [&](const aiMesh& part, std::size_t first) {
    if (!part.HasNormals()) return;
    for (unsigned v = 0; v < part.mNumVertices; ++v) {
      read_[first + v] = to_eigen(part.mNormals[v]).cast<float>();
    }
  });
  find_classes(scene);
}

void SceneNormals::find_classes(const aiScene& scene) {
  struct Class {
    Eigen::Vector3d normal;
    std::uint32_t index;
  };
  const auto last = std::max_element(weld_.begin(), weld_.end());
  std::vector<std::vector<Class>> at_vertex(last == weld_.end() ? 0 : std::size_t{*last} + 1);
  each_part(scene, [&](const aiMesh& part, std::size_t first) {
    if (!part.HasNormals()) return;
    for (unsigned v = 0; v < part.mNumVertices; ++v) {
      const Eigen::Vector3d normal = read_[first + v].cast<double>().normalized();
      std::vector<Class>& classes = at_vertex[weld_[first + v]];
      std::size_t c = 0;
      while (c < classes.size() && !(classes[c].normal.dot(normal) > kSameNormal)) ++c;
      if (c == classes.size()) classes.push_back({normal, classes_++});
      class_[first + v] = classes[c].index;
    }
  });
}

void SceneNormals::follow_faces(aiScene& scene) const {
  std::vector<Eigen::Vector3d> sums(classes_, Eigen::Vector3d::Zero());
  each_part(scene, [&](const aiMesh& part, std::size_t first) {
    if (!part.HasNormals()) return;
    for (unsigned f = 0; f < part.mNumFaces; ++f) {
      const aiFace& face = part.mFaces[f];
      const Eigen::Vector3d area = area_of(part, face);
      for (unsigned c = 0; c < face.mNumIndices; ++c) {
        sums[class_[first + face.mIndices[c]]] += area;
      }
    }
  });
  each_part(scene, [&](aiMesh& part, std::size_t first) {
    if (!part.HasNormals()) return;
    for (unsigned v = 0; v < part.mNumVertices; ++v) {
      set_normal(part.mNormals[v], sums[class_[first + v]]);
    }
  });
}

void SceneNormals::follow(aiScene& scene, const std::vector<Eigen::Matrix3d>& gradients,
                          double sign) const {
  follow_faces(scene);
  each_part(scene, [&](aiMesh& part, std::size_t first) {
    if (!part.HasNormals()) return;
    for (unsigned v = 0; v < part.mNumVertices; ++v) {
      const Eigen::Matrix3d turn = sign * cofactor(known(gradients[weld_[first + v]]));
      set_normal(part.mNormals[v], turn * read_[first + v].cast<double>());
    }
  });
}

}  // namespace hwffd
