#include <assimp/material.h>
#include <assimp/scene.h>

#include <Eigen/Geometry>
#include <cmath>
#include <numeric>

#include "hwffd/mesh/mesh.hpp"
#include "mesh/normals.hpp"

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

aiVector3D tube_point(unsigned ring, unsigned corner) {
  const double t = static_cast<double>(ring) / kAlong;
  const double angle = kTurn * corner / kAround;
  const double step = 1e-4;
  const Eigen::Vector3d tangent = (knot(t + step) - knot(t - step)).normalized();
  const Eigen::Vector3d side = tangent.cross(knot(t)).normalized();  // never parallel to knot(t)
  const Eigen::Vector3d up = side.cross(tangent);
  const Eigen::Vector3d p = knot(t) + kTube * (std::cos(angle) * side + std::sin(angle) * up);
  return {static_cast<float>(p.x()), static_cast<float>(p.y()), static_cast<float>(p.z())};
}

void set_triangle(aiFace& face, unsigned a, unsigned b, unsigned c) {
  face.mNumIndices = 3;
  face.mIndices = new unsigned[3]{a, b, c};
}

aiMesh* tube() {
  auto* mesh = new aiMesh();
  mesh->mName = "procedural";
  mesh->mPrimitiveTypes = aiPrimitiveType_TRIANGLE;
  mesh->mNumVertices = kVertices;
  mesh->mVertices = new aiVector3D[mesh->mNumVertices];
  mesh->mNormals = new aiVector3D[mesh->mNumVertices];
  mesh->mNumFaces = 2 * kVertices;
  mesh->mFaces = new aiFace[std::size_t{2} * kVertices];
  for (unsigned ring = 0; ring < kAlong; ++ring) {
    for (unsigned corner = 0; corner < kAround; ++corner) {
      const unsigned next_ring = (ring + 1) % kAlong * kAround;
      const unsigned next_corner = (corner + 1) % kAround;
      const unsigned v = ring * kAround + corner;
      mesh->mVertices[v] = tube_point(ring, corner);
      const unsigned across = next_ring + next_corner;
      set_triangle(mesh->mFaces[std::size_t{2} * v], v, next_ring + corner, across);
      set_triangle(mesh->mFaces[std::size_t{2} * v + 1], v, across, ring * kAround + next_corner);
    }
  }
  return mesh;
}

}  // namespace

Mesh Mesh::procedural() {
  ScenePtr scene(new aiScene());
  scene->mNumMeshes = 1;
  scene->mMeshes = new aiMesh* [1] { tube() };
  scene->mNumMaterials = 1;
  scene->mMaterials = new aiMaterial* [1] { new aiMaterial() };
  scene->mRootNode = new aiNode("procedural");
  scene->mRootNode->mNumMeshes = 1;
  scene->mRootNode->mMeshes = new unsigned[1]{0};
  std::vector<std::uint32_t> nothing_to_weld(kVertices);
  std::iota(nothing_to_weld.begin(), nothing_to_weld.end(), 0);
  SceneNormals(*scene, nothing_to_weld).follow_faces(*scene);
  return Mesh(std::move(scene), "procedural");
}

}  // namespace hwffd
