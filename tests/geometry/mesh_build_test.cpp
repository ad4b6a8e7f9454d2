#include <assimp/scene.h>
#include <gtest/gtest.h>

#include <cmath>

#include "errors.hpp"
#include "hwffd/mesh/mesh.hpp"
#include "temp_folder.hpp"

namespace hwffd {
namespace {

/// A square of two triangles that faces z, at this depth.
Mesh::Part square(const std::string& name, double z) {
  Points corners(4, 3);
  corners << 0, 0, z, 1, 0, z, 1, 1, z, 0, 1, z;
  return {name, {0.25f, 0.5f, 0.75f}, corners, {{0, 1, 2}, {0, 2, 3}}};
}

TEST(MeshBuild, PartsBecomePartsOfTheScene) {
  const Mesh mesh = Mesh::build("two", {square("near", 1), square("far", 0)});
  EXPECT_EQ(mesh.name(), "two");
  EXPECT_EQ(mesh.vertex_count(), 8u);
  EXPECT_EQ(mesh.triangles().size(), 4u);
  EXPECT_EQ(mesh.triangles()[2], (Mesh::Triangle{4, 5, 6}));
  ASSERT_EQ(mesh.scene().mNumMeshes, 2u);
  EXPECT_STREQ(mesh.scene().mMeshes[1]->mName.C_Str(), "far");
  aiColor3D colour;
  mesh.scene().mMaterials[1]->Get(AI_MATKEY_COLOR_DIFFUSE, colour);
  EXPECT_EQ(colour, aiColor3D(0.25f, 0.5f, 0.75f));
}

TEST(MeshBuild, NormalsAreSmoothInAPartAndHardBetweenParts) {
  Mesh::Part roof = square("roof", 0);
  roof.positions.row(2).z() = -1;  // the triangles meet along the diagonal at an angle
  const Mesh mesh = Mesh::build("roof", {roof, square("flat", 0)});
  const aiVector3D* bent = mesh.scene().mMeshes[0]->mNormals;
  const aiVector3D* flat = mesh.scene().mMeshes[1]->mNormals;
  for (int v = 0; v < 4; ++v) EXPECT_EQ(flat[v], aiVector3D(0, 0, 1)) << v;
  // Faces (0, 1, 1) and (1, 0, 1): their sum on the diagonal.
  const float third = 1 / std::sqrt(6.0f);
  EXPECT_NEAR((bent[0] - aiVector3D(third, third, 2 * third)).Length(), 0, 1e-6);
  EXPECT_NEAR((bent[1] - aiVector3D(0, 1, 1) * std::sqrt(0.5f)).Length(), 0, 1e-6);
}

TEST(MeshBuild, FollowsADeformationAndIsSaved) {
  const TempFolder folder;
  Mesh mesh = Mesh::build("two", {square("near", 1), square("far", 0)});
  mesh.set_positions(mesh.positions() * 2);
  EXPECT_EQ(mesh.scene().mMeshes[0]->mNormals[0], aiVector3D(0, 0, 1));
  mesh.save(folder / "two.obj");
  EXPECT_EQ(Mesh::load(folder / "two.obj").vertex_count(), 8u);
}

TEST(MeshBuild, RefusesWhatIsNoMesh) {
  EXPECT_ERROR(Mesh::build("m", {}), "m: has no parts; give at least one");
  Mesh::Part part = square("p", 0);
  part.triangles.push_back({0, 1, 4});
  EXPECT_ERROR_PART(Mesh::build("m", {part}), "m: part p refers to point 4 of 4");
  part.triangles.clear();
  EXPECT_ERROR_PART(Mesh::build("m", {part}), "part p has no triangles");
  part = square("p", 1e300);
  EXPECT_ERROR_PART(Mesh::build("m", {part}), "point 0 that is not a finite binary32 number");
}

}  // namespace
}  // namespace hwffd
