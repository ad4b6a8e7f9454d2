// Meshes: welding, moving, and those that come from no file.

#include "hwffd/mesh/mesh.hpp"

#include <assimp/scene.h>
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <map>
#include <nlohmann/json.hpp>

#include "errors.hpp"
#include "mesh_files.hpp"
#include "temp_folder.hpp"

namespace hwffd {
namespace {

/// Two unit squares that meet at a right angle along the z axis, as two groups, each with its own
/// corners, normals and texture coordinates: 8 corners at 6 places.
const char* const kFold =
    "v 0 0 0\nv 1 0 0\nv 1 0 1\nv 0 0 1\n"
    "v 0 0 0\nv 0 0 1\nv 0 1 1\nv 0 1 0\n"
    "vt 0 0\nvt 1 0\nvt 1 1\nvt 0 1\n"
    "vn 0 -1 0\nvn -1 0 0\n"
    "g floor\nf 1/1/1 2/2/1 3/3/1 4/4/1\n"
    "g wall\nf 5/1/2 6/2/2 7/3/2 8/4/2\n";

/// Distance to the vertex nearest to p.
double distance_to(const Mesh& mesh, const Eigen::RowVector3d& p) {
  return (mesh.positions().rowwise() - p).rowwise().norm().minCoeff();
}

TEST(Mesh, WeldsEqualPositionsOverAllParts) {
  const Mesh mesh = load_text(kFold, "fold.obj");
  EXPECT_EQ(mesh.name(), "fold.obj");
  EXPECT_EQ(mesh.scene().mNumMeshes, 2u);
  EXPECT_EQ(mesh.vertex_count_read(), 8u);
  EXPECT_EQ(mesh.vertex_count(), 6u);
  Points expected(6, 3);
  expected << 0, 0, 0, 1, 0, 0, 1, 0, 1, 0, 0, 1, 0, 1, 1, 0, 1, 0;
  EXPECT_EQ(mesh.positions(), expected);
  const std::vector<Mesh::Triangle> triangles{{0, 1, 2}, {0, 2, 3}, {0, 3, 4}, {0, 4, 5}};
  EXPECT_EQ(mesh.triangles(), triangles);
}

/// Only exact equality welds, along every axis: the next binary32 number is another place.
TEST(Mesh, DoesNotWeldWhatIsMerelyClose) {
  const Mesh mesh = load_text(
      "v 0.5 0.5 0.5\nv 0.50000006 0.5 0.5\nv 0.5 0.50000006 0.5\n"
      "v 0.5 0.5 0.50000006\nv 0.5 0.5 0.5\nv 1e-7 0 1\nv 0 0 1\n"
      "f 1 2 3\nf 4 5 6\nf 5 6 7\n");
  EXPECT_EQ(mesh.vertex_count(), 6u);
}

TEST(Mesh, WeldsNegativeZero) {
  const Mesh mesh =
      load_text("v 0 0 0\nv -0 0 0\nv 0 -0 0\nv 0 0 -0\nv 1 0 0\nv 0 1 0\nf 1 2 5\nf 3 4 6\n");
  EXPECT_EQ(mesh.vertex_count_read(), 6u);
  EXPECT_EQ(mesh.vertex_count(), 3u);
}

TEST(Mesh, NewPositionsReachEveryDuplicate) {
  Mesh mesh = load_text(kFold, "fold.obj");
  Points moved = mesh.positions();
  moved.row(0) << 10.1, 20.2, 30.3;
  mesh.set_positions(moved);
  EXPECT_EQ(mesh.positions()(0, 0), static_cast<double>(10.1f));
  int copies = 0;
  each_vertex(mesh, [&](const aiMesh& part, unsigned v) {
    if (part.mVertices[v] == aiVector3D(10.1f, 20.2f, 30.3f)) ++copies;
  });
  EXPECT_EQ(copies, 2);
}

/// Normals follow the deformation, and the hard edge between floor and wall stays hard.
TEST(Mesh, NormalsFollowAndHardEdgesStay) {
  Mesh mesh = load_text(kFold, "fold.obj");
  const Eigen::Matrix3d turn =
      Eigen::AngleAxisd(0.5, Eigen::Vector3d(1, 2, 3).normalized()).toRotationMatrix();
  mesh.set_positions(mesh.positions() * turn.transpose());
  // The faces of kFold are wound so that these are their sides.
  int checked = 0;
  each_vertex(mesh, [&](const aiMesh& part, unsigned v) {
    const bool is_floor = &part == mesh.scene().mMeshes[0];
    const Eigen::Vector3d side = is_floor ? Eigen::Vector3d(0, -1, 0) : Eigen::Vector3d(-1, 0, 0);
    const aiVector3D& n = part.mNormals[v];
    EXPECT_LT((Eigen::Vector3d(n.x, n.y, n.z) - turn * side).norm(), 1e-6);
    ++checked;
  });
  EXPECT_EQ(checked, 8);
}

TEST(Mesh, SmoothNormals) {
  const Mesh mesh = load_text(kFold, "fold.obj");
  const Points normals = mesh.smooth_normals();
  EXPECT_LT((normals.row(1) - Eigen::RowVector3d(0, -1, 0)).norm(), 1e-12);
  EXPECT_LT((normals.row(4) - Eigen::RowVector3d(-1, 0, 0)).norm(), 1e-12);
  EXPECT_LT((normals.row(0) - Eigen::RowVector3d(-1, -1, 0).normalized()).norm(), 1e-12);
}

/// A part shown three times, once mirrored, all under a moved node: each place gets vertices of its
/// own in world coordinates, and faces of the mirrored one are turned round.
TEST(Mesh, NodeTransformsAndInstances) {
  const TempFolder folder;
  load_text("v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n")
      .save(folder / "two.gltf");
  nlohmann::json file = nlohmann::json::parse(read_text(folder / "two.gltf"));
  file["nodes"] = nlohmann::json::parse(R"([
      {"name": "a", "children": [1, 2, 3], "translation": [0.005, 0, 0]},
      {"name": "b", "mesh": 0, "scale": [-1, 1, 1]},
      {"name": "c", "mesh": 0, "translation": [10, 20, 30]},
      {"name": "d", "mesh": 0, "translation": [0, 0, -0.009]}])");
  Mesh mesh = Mesh::load(folder.write("two.gltf", file.dump()));
  EXPECT_EQ(mesh.vertex_count(), 12u);
  EXPECT_EQ(mesh.triangles().size(), 12u);
  EXPECT_LT(distance_to(mesh, {-0.995, 0, 0}), 1e-6);
  EXPECT_LT(distance_to(mesh, {0.005, 0, 1}), 1e-6);
  EXPECT_LT(distance_to(mesh, {11.005, 20, 30}), 1e-6);
  EXPECT_LT(distance_to(mesh, {10.005, 21, 30}), 1e-6);
  EXPECT_LT(distance_to(mesh, {1.005, 0, -0.009}), 1e-6);  // a shift that is nearly none
  EXPECT_NEAR(volume_times_six(mesh), 3.0, 1e-2);
  mesh.set_positions(2.0 * mesh.positions());
  mesh.save(folder / "three.glb");
  const Mesh again = Mesh::load(folder / "three.glb");
  EXPECT_EQ(again.vertex_count(), 12u);
  EXPECT_LT(distance_to(again, {22.01, 40, 60}), 1e-5);
}

TEST(Mesh, ProceduralIsClosedAndTurnedOutwards) {
  const Mesh mesh = Mesh::procedural();
  EXPECT_EQ(mesh.name(), "procedural");
  EXPECT_EQ(mesh.vertex_count(), 3072u);
  EXPECT_EQ(mesh.vertex_count_read(), 3072u);
  EXPECT_EQ(mesh.triangles().size(), 6144u);
  std::map<std::pair<std::uint32_t, std::uint32_t>, int> edges;
  for (const Mesh::Triangle& t : mesh.triangles()) {
    for (std::size_t c = 0; c < 3; ++c) ++edges[{t[c], t[(c + 1) % 3]}];
  }
  EXPECT_EQ(edges.size(), 3u * 6144u);
  for (const auto& [edge, count] : edges) {
    EXPECT_EQ(count, 1);
    EXPECT_EQ(edges.count({edge.second, edge.first}), 1u);
  }
  // About the tube's section (a 16-gon) times the length of the knot.
  EXPECT_GT(volume_times_six(mesh), 0.0);
  const aiMesh& part = *mesh.scene().mMeshes[0];
  const Points normals = mesh.smooth_normals();
  for (unsigned v = 0; v < part.mNumVertices; ++v) {
    const aiVector3D& n = part.mNormals[v];
    EXPECT_LT((Eigen::RowVector3d(n.x, n.y, n.z) - normals.row(v)).norm(), 1e-6);
  }
}

class Glmark2Model : public ::testing::Test {
 protected:
  static std::filesystem::path find(const std::string& name) {
    const std::filesystem::path path = "/usr/share/glmark2/models/" + name;
    return std::filesystem::exists(path) ? path : std::filesystem::path();
  }
};

/// The counts are those in the file's own headers. The file has y up, and the cat sits on y =
/// -1.3411; Assimp's turn would lay it on its back.
TEST_F(Glmark2Model, Cat) {
  if (find("cat.3ds").empty()) GTEST_SKIP() << "package glmark2-data is not installed";
  EXPECT_EQ(find_model("cat.3ds"), find("cat.3ds"));
  const Mesh mesh = Mesh::load(find_model("cat.3ds"));
  EXPECT_EQ(mesh.name(), "cat.3ds");
  EXPECT_EQ(mesh.vertex_count_read(), 7340u);
  EXPECT_EQ(mesh.vertex_count(), 7340u);
  EXPECT_EQ(mesh.triangles().size(), 14348u);
  const Eigen::RowVector3d low = mesh.positions().colwise().minCoeff();
  const Eigen::RowVector3d high = mesh.positions().colwise().maxCoeff();
  EXPECT_LT((low - Eigen::RowVector3d(-2.233167, -1.353040, -1.283225)).norm(), 1e-5);
  EXPECT_LT((high - Eigen::RowVector3d(2.252167, 1.341132, 1.244906)).norm(), 1e-5);
}

TEST_F(Glmark2Model, CubeIsWeldedToItsEightCorners) {
  if (find("cube.3ds").empty()) GTEST_SKIP() << "package glmark2-data is not installed";
  const Mesh mesh = Mesh::load(find("cube.3ds"));
  EXPECT_EQ(mesh.vertex_count_read(), 20u);
  EXPECT_EQ(mesh.vertex_count(), 8u);
  EXPECT_EQ(mesh.triangles().size(), 12u);
}

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
