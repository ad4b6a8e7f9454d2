#pragma once

#include <Eigen/Geometry>

#include "hwffd/mesh/mesh.hpp"

namespace hwffd {

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
