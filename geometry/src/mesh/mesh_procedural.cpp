#include <assimp/material.h>
#include <assimp/scene.h>

#include <Eigen/Geometry>
#include <cmath>
#include <utility>

#include "hwffd/mesh/mesh.hpp"

namespace hwffd {
namespace {

constexpr unsigned kAlong = 192;  // rings along the knot
constexpr unsigned kAround = 16;  // vertices of a ring
constexpr unsigned kVertices = kAlong * kAround;
constexpr double kTube = 0.5;  // radius of the tube
constexpr double kTurn = 6.283185307179586476925;

/// The trefoil knot, t in [0, 1), standing upright on y.
Eigen::Vector3d knot(double t) {
  const double a = kTurn * t;
  const double radius = 2.0 + std::cos(3.0 * a);
  return {radius * std::cos(2.0 * a), radius * std::sin(2.0 * a), std::sin(3.0 * a)};
}

Point tube_point(unsigned ring, unsigned corner) {
  const double t = static_cast<double>(ring) / kAlong;
  const double angle = kTurn * corner / kAround;
  const double step = 1e-4;
  const Eigen::Vector3d tangent = (knot(t + step) - knot(t - step)).normalized();
  const Eigen::Vector3d side = tangent.cross(knot(t)).normalized();  // never parallel to knot(t)
  const Eigen::Vector3d up = side.cross(tangent);
  return knot(t) + kTube * (std::cos(angle) * side + std::sin(angle) * up);
}

}  // namespace

Mesh Mesh::procedural() {
  Part tube{"procedural", {}, Points(kVertices, 3), {}};
  for (unsigned ring = 0; ring < kAlong; ++ring) {
    for (unsigned corner = 0; corner < kAround; ++corner) {
      const unsigned next_ring = (ring + 1) % kAlong * kAround;
      const unsigned next_corner = (corner + 1) % kAround;
      const unsigned v = ring * kAround + corner;
      tube.positions.row(v) = tube_point(ring, corner).cast<float>().cast<double>();
      tube.triangles.push_back({v, next_ring + corner, next_ring + next_corner});
      tube.triangles.push_back({v, next_ring + next_corner, ring * kAround + next_corner});
    }
  }
  Mesh mesh = build("procedural", {std::move(tube)});
  mesh.mutable_scene().mMaterials[0]->Clear();
  return mesh;
}

}  // namespace hwffd
