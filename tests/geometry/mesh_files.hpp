#pragma once

#include <assimp/scene.h>
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <string>

#include "hwffd/mesh/mesh.hpp"
#include "temp_folder.hpp"

namespace hwffd {

/// The mesh that a file with this text holds.
inline Mesh load_text(const std::string& text, const std::string& name = "a.obj") {
  const TempFolder folder;
  return Mesh::load(folder.write(name, text));
}

/// For tests of meshes with files in a folder of their own.
class MeshFiles : public testing::Test {
 protected:
  Mesh load(const std::string& text, const std::string& name = "a.obj") const {
    return Mesh::load(folder.write(name, text));
  }

  /// Saved and loaded.
  Mesh again(const Mesh& mesh, const std::string& name) const {
    mesh.save(folder / name);
    return Mesh::load(folder / name);
  }

  const TempFolder folder;
};

/// Calls f(part, v) for every vertex of the mesh's scene, parts in order.
template <typename F>
void each_vertex(const Mesh& mesh, F f) {
  for (unsigned m = 0; m < mesh.scene().mNumMeshes; ++m) {
    const aiMesh& part = *mesh.scene().mMeshes[m];
    for (unsigned v = 0; v < part.mNumVertices; ++v) f(part, v);
  }
}

/// Six times the volume that the triangles enclose: positive if they face outwards.
inline double volume_times_six(const Mesh& mesh) {
  double sum = 0.0;
  for (const Mesh::Triangle& t : mesh.triangles()) {
    const Eigen::Vector3d a = mesh.positions().row(t[0]);
    const Eigen::Vector3d b = mesh.positions().row(t[1]);
    const Eigen::Vector3d c = mesh.positions().row(t[2]);
    sum += a.dot(b.cross(c));
  }
  return sum;
}

}  // namespace hwffd
