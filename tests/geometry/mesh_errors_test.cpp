#include <fmt/format.h>
#include <gtest/gtest.h>

#include <limits>

#include "errors.hpp"
#include "hwffd/lattice/box.hpp"
#include "hwffd/lattice/cylinder.hpp"
#include "hwffd/lattice/embedder.hpp"
#include "hwffd/lattice/sphere.hpp"
#include "mesh_files.hpp"
#include "unprivileged.hpp"

namespace hwffd {
namespace {

using MeshErrors = MeshFiles;

const std::string kAccepted =
    "accepted are obj, ply, stl, 3ds, glb, gltf, dae and what else Assimp reads";

std::string load_error(const std::filesystem::path& path) {
  std::string text = message_of<Error>([&] { Mesh::load(path); });
  EXPECT_EQ(text.rfind(path.string() + ": ", 0), 0u) << text;
  return text;
}

TEST_F(MeshErrors, MissingFile) {
  EXPECT_EQ(load_error("no/such.obj"),
            "no/such.obj: no such file; give the path of a mesh: " + kAccepted);
}

TEST_F(MeshErrors, FolderInsteadOfFile) {
  std::filesystem::create_directory(folder / "a.obj");
  expect_part(load_error(folder / "a.obj"), ": not a file; give the path of a mesh: " + kAccepted);
}

TEST_F(MeshErrors, NotAMesh) {
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
  }
}

TEST_F(MeshErrors, NoVertices) {
  const std::string comments(200, '#');
  expect_part(load_error(folder.write("a.obj", "# nothing here\n" + comments + "\n")), kAccepted);
  expect_part(load_error(folder.write("b.ply",
                                      "ply\nformat ascii 1.0\nelement vertex 0\nproperty float x\n"
                                      "property float y\nproperty float z\nend_header\n")),
              kAccepted);
}

TEST_F(MeshErrors, CoordinatesThatAreNotFinite) {
  for (const std::string bad : {"nan", "inf", "-inf", "1e39"}) {
    const std::string text = "v 0 0 0\nv 1 0 0\nv 0 " + bad + " 0\nf 1 2 3\n";
    expect_part(load_error(folder.write("a.obj", text)),
                ": vertex 2 has a coordinate that is not a finite binary32 number; repair or scale "
                "the mesh");
  }
}

/// A ply file of one triangle, with these lines in place of its own.
std::string ply_text(const std::string& vertices, const std::string& list,
                     const std::string& data) {
  return "ply\nformat ascii 1.0\n" + vertices +
         "property float x\nproperty float y\nproperty float z\nelement face 1\n" + list +
         "end_header\n" + data;
}

const char* const kVertices = "element vertex 3\n";
const char* const kList = "property list uchar int vertex_indices\n";

TEST_F(MeshErrors, FaceWithoutItsVertex) {
  const std::string corners = "0 0 0\n1 0 0\n0 1 0\n";
  EXPECT_EQ(load(ply_text(kVertices, kList, corners + "3 0 1 2\n"), "a.ply").vertex_count(), 3u);
  expect_part(load_error(folder.write("a.ply", ply_text(kVertices, kList, corners + "3 0 1 7\n"))),
              "a.ply: face 0 refers to vertex 7 of 3; repair the mesh");
  for (const std::string vertex : {"-1", "1.5", "5000000000"}) {
    const std::string faces = fmt::format("{}3 0 1 {}\n", corners, vertex);
    expect_part(load_error(folder.write("a.ply", ply_text(kVertices, kList, faces))),
                "a.ply: face 0 refers to vertex ");
  }
}

/// Headers and data that do not belong together: some of them crash Assimp's reader.
TEST_F(MeshErrors, BrokenPly) {
  const std::string data = "0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n";
  struct Bad {
    std::string text;
    const char* reason;
  };
  const std::string binary =
      "ply\nformat binary_little_endian 1.0\nelement face 1\nproperty list int float a\n"
      "end_header\n";
  const std::vector<Bad> all{
      {ply_text(kVertices, kList, "0 0 0\n1 0 0\n"), "the file ends before its data"},
      {ply_text("element vertex 4000000000\n", kList, data), "the file ends before its data"},
      {ply_text(kVertices, kList, "0 0 0\n1 0 0\n0 1 0\n9999 0 1 2\n"), "the file ends in a list"},
      {ply_text(kVertices, kList, "0 0 0\n1 0 0\n0 1 0\n-3 0 1 2\n"),
       "'-3' is not a number of rows or corners"},
      {ply_text("element vertex three\n", kList, data),
       "'three' is not a number of rows or corners"},
      {ply_text("", kList, data), "a property before the first element"},
      {ply_text(kVertices, "", data), "element 'face' has no properties"},
      {ply_text(kVertices, "property list float int a\n", data), "a list counted in 'float'"},
      {ply_text(kVertices, "property list uchar word a\n", data),
       "unknown type 'word' in the header"},
      {"ply\nformat ascii 1.0\nelement vertex 3\n", "no end_header"},
      {"ply\nformat rot13 1.0\nend_header\n", "unknown format 'rot13'"},
      {"ply\nformat\nend_header\n", "unknown format ''"},
      {"ply\nelement vertex 0\nend_header\n", "unknown format ''"},
      {"ply", "no end_header"},
      {"plywood\n", "it does not begin with 'ply'"},
      {"ply 2\nformat ascii 1.0\nend_header\n", "it does not begin with 'ply'"},
      {ply_text("element vertex\n", kList, data), "'' is not a number of rows or corners"},
      {ply_text(kVertices, "property\n", data), "unknown type '' in the header"},
      {ply_text(kVertices, "property list\n", data), "unknown type '' in the header"},
      {"ply\nformat binary_big_endian 1.0\nelement face 1\nproperty list char uchar a\n"
       "end_header\n\xff",
       "a list of -1 values"},
      {binary + std::string("\2\0\0\0aaaabbb", 11), "the file ends before its data"},
      {binary + std::string("\2\0\0\x7f"
                            "aaaabbbb",
                            12),
       "the file ends in a list"}};
  for (const Bad& bad : all) {
    expect_part(load_error(folder.write("a.ply", bad.text)),
                ": not a mesh that can be read (" + std::string(bad.reason) + "); " + kAccepted);
  }
  EXPECT_EQ(all.size(), 22u);
}

TEST_F(MeshErrors, BrokenOff) {
  for (const auto& [text, reason] : std::vector<std::pair<std::string, std::string>>{
           {"", "the file ends before its data"},
           {"OFF BINARY\n3 1 0\n", "binary OFF"},
           {"4OFF\n1 0 0\n0 0 0 1\n", "OFF with vertices that are not x y z"},
           {"OFF\nthree 1 0\n", "'three' is not a number of vertices or faces"},
           {"OFF\n3 1 0\n0 0 0\n1 0 0\n", "the file ends before its data"},
           {"OFF\n1 1 0\n0 0 0\n4000000000 0\n", "the file ends in a face"},
           {"OFF\n1 1 0\n0 0 zero\n1 0\n", "'zero' is not a number"}}) {
    SCOPED_TRACE(text);
    expect_part(load_error(folder.write("a.off", text)),
                fmt::format(": not a mesh that can be read ({}); {}", reason, kAccepted));
  }
}

/// Text that is no facet, and binary files shorter than they say.
TEST_F(MeshErrors, BrokenStl) {
  const std::string begin = "solid a\nfacet normal 0 0 1\nouter loop\n";
  const std::string corners = "vertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\n";
  const std::string header(80, ' ');
  struct Bad {
    std::string bytes;
    const char* reason;
  };
  const std::vector<Bad> all{
      {"", "neither text nor long enough for its header"},
      {"soli", "neither text nor long enough for its header"},
      {"solid a\nvertex 0 0 0\n", "neither text nor long enough for its header"},
      {std::string("solid\0\1\2", 8), "neither text nor long enough for its header"},
      {header + std::string("\2\0\0\0", 4) + std::string(50, '\0'),
       "the file ends before its data"},
      {"solid a\nfacet tangent 0 0 1\n", "'tangent' where 'normal' should stand"},
      {begin + "corner 0 0 0\n", "'corner' where 'vertex' should stand"},
      {begin + corners + "vertex 1 1 0\nendloop\n", "'vertex' where 'endloop' should stand"},
      {begin + corners + "endloop\nendfacet\nvertex 1 1 0\n",
       "'vertex' where a facet should begin"},
      {begin + "vertex 0 0", "the file ends in a facet"},
      {begin + corners + "endloop\n", "the file ends in a facet"},
      {begin + "vertex 0 zero 0\n" + corners + "endloop\nendfacet\n",
       "'vertex' where 'endloop' should stand"},
      {begin + "vertex 0 zero 0\nvertex 1 0 0\nvertex 0 1 0\nendloop\nendfacet\n",
       "'zero' is not a number"}};
  for (const Bad& bad : all) {
    SCOPED_TRACE(bad.bytes);
    expect_part(load_error(folder.write("a.stl", bad.bytes)),
                ": not a mesh that can be read (" + std::string(bad.reason) + "); " + kAccepted);
  }
  // Solids without facets: of text, in a line of its own or not, and of a whole binary file.
  for (const std::string& bytes : {std::string("solid a\n"), std::string("solid a endsolid a\n"),
                                   "solid" + std::string(75, ' ') + std::string(4, '\0')}) {
    expect_part(load_error(folder.write("a.stl", bytes)), "holds no vertices; " + kAccepted);
  }
}

/// Texture coordinates are numbers, and faces have corners.
TEST_F(MeshErrors, ElementsOfAnObjFile) {
  const std::string no_texture = "texture coordinates are no numbers";
  for (const auto& [statement, reason] : std::vector<std::pair<std::string, std::string>>{
           {"vt", no_texture},
           {"vt x 0", no_texture},
           {"vt 0 0 .", no_texture},
           {"v 1 2 3 255 x 0", "a vertex is not three numbers"},
           {"f", "a face without corners"},
           {"l", "a face without corners"},
           {"f -9 1 1", "a face refers to number -9 of 1"}}) {
    SCOPED_TRACE(statement);
    const std::string text = "v 0 0 0\n" + statement + "\n";
    const std::string expected = "line 2: " + reason;
    EXPECT_ERROR_PART(load(text), expected);
  }
}

TEST_F(MeshErrors, UnreadableFile) {
  const auto path = folder.write("a.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
  std::filesystem::permissions(path, std::filesystem::perms(0));
  folder.open_to_all();
  // A file that opens, but whose first byte cannot be read.
  const std::string cure = ": cannot read; check that the file exists and is readable";
  EXPECT_EQ(load_error("/proc/self/mem"), "/proc/self/mem" + cure);
  const Unprivileged nobody;
  if (!nobody.effective()) GTEST_SKIP() << "permissions do not hold for this user";
  EXPECT_EQ(load_error(path), path.string() + cure);
}

/// A mesh in one plane, on one line, in one place: each shape of lattice around it holds all of it.
TEST_F(MeshErrors, FlatMeshInEveryLattice) {
  int checked = 0;
  for (const std::string text :
       {"v 0 0 3\nv 1 0 3\nv 1 2 3\nv 0 2 3\nf 1 2 3 4\n", "v 1 1 1\nv 2 2 2\nv 3 3 3\nf 1 2 3\n",
        "v 5 6 7\nv 5 6 7\nv 5 6 7\nf 1 2 3\n"}) {
    const Points points = load(text).positions();
    for (const Lattice& lattice :
         {Box::around(points).lattice({4, 4, 4}), Cylinder::around(points).lattice({4, 4, 6}),
          Sphere::around(points).lattice({4, 5, 6})}) {
      for (const Embedding& e : Embedder(lattice).embed(points)) {
        EXPECT_EQ(e.status, EmbeddingStatus::kInside) << text;
        ++checked;
      }
    }
  }
  EXPECT_EQ(checked, 3 * (4 + 3 + 1));
}

TEST_F(MeshErrors, NewPositions) {
  Mesh mesh = Mesh::procedural();
  const Points before = mesh.positions();
  EXPECT_ERROR(mesh.set_positions(before.topRows(5)),
               "procedural: 5 new positions for 3072 vertices; give one for each vertex");
  for (const double bad : {std::numeric_limits<double>::quiet_NaN(), 1e39}) {
    Points moved = before * 2.0;
    moved(17, 1) = bad;
    EXPECT_ERROR(mesh.set_positions(moved),
                 "procedural: new position of vertex 17 is not a finite binary32 number; check the "
                 "control points");
    EXPECT_EQ(mesh.positions(), before);
  }
}

/// A vertex of an obj file has three numbers, and beside them a weight that is not 0, or a colour.
TEST_F(MeshErrors, VerticesOfAnObjFile) {
  for (const std::string numbers :
       {"1 2", "1 2 x", "1 2 3x", "x 2 3", "1 2 3 w", "1 2 3 0", "1 2 +"}) {
    SCOPED_TRACE(numbers);
    EXPECT_ERROR_PART(load("v 0 0 0\nv " + numbers + "\n"),
                      "line 2: a vertex is not three numbers");
  }
}

TEST_F(MeshErrors, NumbersOfAnObjFileThatAreTooLarge) {
  for (const std::string& number : {std::string("1e39"), std::string("-1e39"), std::string("1e400"),
                                    std::string("1e+999"), std::string(400, '9')}) {
    SCOPED_TRACE(number);
    EXPECT_ERROR_PART(load("v 0 0 0\nv 1 0 " + number + "\n"), "is not a finite binary32 number");
  }
}

TEST(FindModel, LoadsWhatItFinds) {
  const TempFolder folder;
  EXPECT_EQ(load_model(folder.write("a.obj", "v 0 0 0\nv 1 0 0\n").string()).vertex_count(), 2u);
  EXPECT_ERROR_PART(load_model("no-such.obj"), "model 'no-such.obj': no such file");
  EXPECT_GT(load_model("").vertex_count(), 0u);
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
  EXPECT_ERROR(
      find_model("dog.3ds", {"/a", "/b"}),
      "model 'dog.3ds': no such file in this folder or /a or /b; give a path, or install the "
      "package glmark2-data (cat.3ds, horse.3ds, bunny.obj)");
  EXPECT_ERROR_PART(find_model(""),
                    "model '': no such file in this folder or /usr/share/glmark2/models or ");
}

}  // namespace
}  // namespace hwffd
