#include <gtest/gtest.h>

#include <limits>

#include "hwffd/mesh/mesh.hpp"
#include "temp_folder.hpp"

namespace hwffd {
namespace {

const std::string kAccepted =
    "accepted are obj, ply, stl, 3ds, glb, gltf, dae and what else Assimp reads";

std::string load_error(const std::filesystem::path& path) {
  std::string text = message_of<Error>([&] { Mesh::load(path); });
  EXPECT_EQ(text.rfind(path.string() + ": ", 0), 0u) << text;
  return text;
}

TEST(MeshErrors, MissingFile) {
  EXPECT_EQ(load_error("no/such.obj"),
            "no/such.obj: no such file; give the path of a mesh: " + kAccepted);
}

TEST(MeshErrors, FolderInsteadOfFile) {
  const TempFolder folder;
  std::filesystem::create_directory(folder / "a.obj");
  expect_part(load_error(folder / "a.obj"), ": not a file; give the path of a mesh: " + kAccepted);
}

TEST(MeshErrors, NotAMesh) {
  const TempFolder folder;
  int refused = 0;
  const std::string binary("\x89PNG\r\n\x1a\n\0\0\0\rIHDR", 16);
  for (const auto& [name, text] :
       std::vector<std::pair<std::string, std::string>>{{"a.txt", "Dear reader,\n"},
                                                        {"a.png", binary},
                                                        {"a.3ds", "not a 3ds file at all"},
                                                        {"a.ply", "plough\n"},
                                                        {"a.glb", "glTF"},
                                                        {"a.obj", ""},
                                                        {"a.ply", ""},
                                                        {"a", "v 1 2 3"}}) {
    const std::string error = load_error(folder.write(name, text));
    expect_part(error, "; " + kAccepted);
    ++refused;
  }
  EXPECT_EQ(refused, 8);
}

TEST(MeshErrors, NoVertices) {
  const TempFolder folder;
  const std::string comments(200, '#');
  expect_part(load_error(folder.write("a.obj", "# nothing here\n" + comments + "\n")), kAccepted);
  expect_part(load_error(folder.write("b.ply",
                                      "ply\nformat ascii 1.0\nelement vertex 0\nproperty float x\n"
                                      "property float y\nproperty float z\nend_header\n")),
              kAccepted);
}

TEST(MeshErrors, CoordinatesThatAreNotFinite) {
  const TempFolder folder;
  int refused = 0;
  for (const std::string bad : {"nan", "inf", "-inf", "1e39"}) {
    const std::string text = "v 0 0 0\nv 1 0 0\nv 0 " + bad + " 0\nf 1 2 3\n";
    expect_part(load_error(folder.write("a.obj", text)),
                ": vertex 2 has a coordinate that is not a finite binary32 number; repair or scale "
                "the mesh");
    ++refused;
  }
  EXPECT_EQ(refused, 4);
}

TEST(MeshErrors, FaceWithoutItsVertex) {
  const TempFolder folder;
  const std::string text =
      "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\n"
      "property float z\nelement face 1\nproperty list uchar int vertex_indices\nend_header\n"
      "0 0 0\n1 0 0\n0 1 0\n3 0 1 7\n";
  const std::string error = load_error(folder.write("a.ply", text));
  expect_part(error, "a.ply");
}

TEST(MeshErrors, NewPositions) {
  Mesh mesh = Mesh::procedural();
  const Points before = mesh.positions();
  EXPECT_EQ(message_of<Error>([&] { mesh.set_positions(before.topRows(5)); }),
            "procedural: 5 new positions for 3072 vertices; give one for each vertex");
  int refused = 0;
  for (const double bad : {std::numeric_limits<double>::quiet_NaN(), 1e39}) {
    Points moved = before * 2.0;
    moved(17, 1) = bad;
    EXPECT_EQ(message_of<Error>([&] { mesh.set_positions(moved); }),
              "procedural: new position of vertex 17 is not a finite binary32 number; check the "
              "control points");
    EXPECT_EQ(mesh.positions(), before);
    ++refused;
  }
  EXPECT_EQ(refused, 2);
}

TEST(FindModel, TakesPathsAndLooksInFolders) {
  const TempFolder folder;
  folder.write("cat.3ds", "x");
  const std::vector<std::filesystem::path> folders{folder / "empty", folder / ""};
  EXPECT_EQ(find_model("cat.3ds", folders), folder / "cat.3ds");
  EXPECT_EQ(find_model("some/where/cat.3ds", folders), "some/where/cat.3ds");
  EXPECT_EQ(find_model((folder / "cat.3ds").string(), {}), folder / "cat.3ds");
}

TEST(FindModel, NamesFoldersAndPackage) {
  EXPECT_EQ(message_of<Error>([] {
              find_model("dog.3ds", {"/a", "/b"});
            }),
            "model 'dog.3ds': no such file in this folder or /a or /b; give a path, or install the "
            "package glmark2-data (cat.3ds, horse.3ds, bunny.obj)");
  expect_part(message_of<Error>([] { find_model(""); }),
              "model '': no such file in this folder or /usr/share/glmark2/models or ");
}

}  // namespace
}  // namespace hwffd
