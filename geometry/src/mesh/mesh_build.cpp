#include <assimp/material.h>
#include <assimp/scene.h>
#include <fmt/format.h>

#include <algorithm>

#include "hwffd/error.hpp"
#include "hwffd/mesh/mesh.hpp"
#include "mesh/normals.hpp"

namespace hwffd {
namespace {

using Part = Mesh::Part;

void check(const std::string& mesh, const Part& part) {
  const auto fail = [&](const std::string& what) {
    throw Error(fmt::format("{}: part {} {}; mend what it is built from", mesh, part.name, what));
  };
  if (part.triangles.empty()) fail("has no triangles");
  for (Eigen::Index p = 0; p < part.positions.rows(); ++p) {
    if (!part.positions.row(p).cast<float>().allFinite()) {
      fail(fmt::format("has a point {} that is not a finite binary32 number", p));
    }
  }
  for (const Mesh::Triangle& triangle : part.triangles) {
    const std::uint32_t last = *std::max_element(triangle.begin(), triangle.end());
    if (last >= part.positions.rows()) {
      fail(fmt::format("refers to point {} of {}", last, part.positions.rows()));
    }
  }
}

aiVector3D to_assimp(const Point& p) {
  return {static_cast<float>(p.x()), static_cast<float>(p.y()), static_cast<float>(p.z())};
}

aiMesh* mesh_of(const Part& part, unsigned material) {
  auto* mesh = new aiMesh();
  mesh->mName = part.name;
  mesh->mPrimitiveTypes = aiPrimitiveType_TRIANGLE;
  mesh->mMaterialIndex = material;
  mesh->mNumVertices = static_cast<unsigned>(part.positions.rows());
  mesh->mVertices = new aiVector3D[mesh->mNumVertices];
  mesh->mNormals = new aiVector3D[mesh->mNumVertices];
  const Points normals = smooth_normals(part.positions, part.triangles);
  for (unsigned v = 0; v < mesh->mNumVertices; ++v) {
    mesh->mVertices[v] = to_assimp(part.positions.row(v));
    mesh->mNormals[v] = to_assimp(normals.row(v));
  }
  mesh->mNumFaces = static_cast<unsigned>(part.triangles.size());
  mesh->mFaces = new aiFace[part.triangles.size()];
  for (std::size_t t = 0; t < part.triangles.size(); ++t) {
    const Mesh::Triangle& triangle = part.triangles[t];
    mesh->mFaces[t].mNumIndices = 3;
    mesh->mFaces[t].mIndices = new unsigned[3]{triangle[0], triangle[1], triangle[2]};
  }
  return mesh;
}

aiMaterial* material_of(const Part& part) {
  auto* material = new aiMaterial();
  const aiString name(part.name);
  const aiColor3D colour(part.colour[0], part.colour[1], part.colour[2]);
  material->AddProperty(&name, AI_MATKEY_NAME);
  material->AddProperty(&colour, 1, AI_MATKEY_COLOR_DIFFUSE);
  return material;
}

}  // namespace

Mesh Mesh::build(std::string name, const std::vector<Part>& parts) {
  if (parts.empty()) throw Error(fmt::format("{}: has no parts; give at least one", name));
  for (const Part& part : parts) check(name, part);
  const auto count = static_cast<unsigned>(parts.size());
  auto scene = std::make_unique<aiScene>();
  scene->mRootNode = new aiNode(name);
  scene->mRootNode->mNumMeshes = count;
  scene->mRootNode->mMeshes = new unsigned[count];
  scene->mMeshes = new aiMesh* [count] {};
  scene->mMaterials = new aiMaterial* [count] {};
  for (unsigned p = 0; p < count; ++p) {
    scene->mRootNode->mMeshes[p] = p;
    scene->mMeshes[scene->mNumMeshes++] = mesh_of(parts[p], p);
    scene->mMaterials[scene->mNumMaterials++] = material_of(parts[p]);
  }
  return Mesh(std::move(scene), std::move(name));
}

}  // namespace hwffd
