// Names, units and paths on their way through formats, and what is dropped.

#include <assimp/material.h>
#include <assimp/scene.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "errors.hpp"
#include "mesh_files.hpp"

namespace hwffd {
namespace {

using MeshNames = MeshFiles;

const char* const kNamedTriangle = "v 0 0 0\nv 1 0 0\nv 0 1 0\nvt 0 0\nf 1/1 2/1 3/1\n";

TEST_F(MeshNames, Latin1BecomesUtf8) {
  folder.write("a.mtl", "newmtl gr\xfcn\nKd 0 1 0\nmap_Kd b\xe4r.png\n");
  const Mesh mesh = load(std::string("mtllib a.mtl\ng t\xfcr\nusemtl gr\xfcn\n") + kNamedTriangle);
  mesh.save(folder / "b.gltf");
  const nlohmann::json file = nlohmann::json::parse(read_text(folder / "b.gltf"));
  EXPECT_EQ(file["materials"].back()["name"], "gr\u00fcn");
  EXPECT_EQ(file["images"][0]["uri"], "b\u00e4r.png");
  mesh.save(folder / "b.glb");
  mesh.save(folder / "b.dae");
  const std::string dae = read_text(folder / "b.dae");
  expect_part(dae, "gr\u00fcn");
  expect_part(dae, "b%c3%a4r.png");
  EXPECT_EQ(dae.find('\xfc'), std::string::npos) << "a byte of Latin-1";
  for (const std::string name : {"b.gltf", "b.glb", "b.dae"}) {
    EXPECT_EQ(Mesh::load(folder / name).vertex_count(), 3u) << name;
  }
  mesh.save(folder / "b.obj");  // which has no encoding: as it was
  expect_part(read_text(folder / "b.obj"), "g t\xfcr\n");
}

/// In UTF-8 a name may become longer than Assimp has room for; it is cut between two characters.
TEST_F(MeshNames, LongNamesAreCut) {
  for (const std::string first : {"", "g"}) {
    const std::string latin = first + std::string(700, '\xfc');
    folder.write("a.mtl", "newmtl " + latin + "\nKd 0 1 0\n");
    const Mesh mesh = load("mtllib a.mtl\nusemtl " + latin + "\n" + kNamedTriangle);
    mesh.save(folder / "b.gltf");
    const nlohmann::json file = nlohmann::json::parse(read_text(folder / "b.gltf"));
    std::string wanted = first;
    while (wanted.size() + 2 <= MAXLEN - 1) wanted += "\u00fc";
    EXPECT_EQ(file["materials"].back()["name"], wanted);
  }
}

TEST_F(MeshNames, Utf8Stays) {
  const Mesh mesh = load(std::string("g t\u00fcr \u6728\n") + kNamedTriangle);
  mesh.save(folder / "b.gltf");
  expect_part(read_text(folder / "b.gltf"), "\"t\u00fcr \u6728\"");
}

TEST_F(MeshNames, MessagesAreOneLine) {
  EXPECT_STREQ(Error("a\nb\x7f: caf\u00e9").what(), "a\\x0ab\\x7f: caf\u00e9");
  EXPECT_ERROR_PART(Mesh::load("no\nsuch.obj"), "no\\x0asuch.obj: ");
}

TEST_F(MeshNames, TexturesAreFoundFromAnotherFolder) {
  for (const char* name : {"in", "in/skin", "out"})
    std::filesystem::create_directory(folder / name);
  folder.write("in/skin/red.png", "x");
  folder.write("in/a.mtl", "newmtl red\nmap_Kd skin/red.png\nnewmtl far\nmap_Kd /abs/far.png\n");
  const Mesh mesh =
      Mesh::load(folder.write("in/a.obj", std::string("mtllib a.mtl\nusemtl red\n") +
                                              kNamedTriangle + "usemtl far\nf 1 3 2\n"));
  mesh.save(folder / "in/b.obj");
  expect_part(read_text(folder / "in/b.obj"), "mtllib a.mtl\n");
  mesh.save(folder / "out/b.obj");
  expect_part(read_text(folder / "out/b.obj"), "mtllib ../in/a.mtl\n");
  mesh.save(folder / "out/b.gltf");
  Mesh::load(folder / "out/b.gltf").save(folder / "in/c.obj");
  expect_part(read_text(folder / "in/c.mtl"), "map_Kd skin/red.png\n");
  expect_part(read_text(folder / "in/c.mtl"), "map_Kd /abs/far.png\n");
  expect_part(read_text(folder / "out/b.gltf"), "\"../in/skin/red.png\"");
  mesh.save(folder / "out/b.ply");
  expect_part(read_text(folder / "out/b.ply"), "comment TextureFile ../in/skin/red.png\n");
}

/// All of several libraries, and of several textures.
TEST_F(MeshNames, SeveralFilesAreFoundFromAnotherFolder) {
  for (const char* name : {"in a", "out"}) std::filesystem::create_directory(folder / name);
  folder.write("in a/a.mtl", "newmtl red\nKd 1 0 0\n");
  folder.write("in a/b.mtl", "newmtl blue\nKd 0 0 1\n");
  const std::string faces = std::string("usemtl red\n") + kNamedTriangle + "usemtl blue\nf 1 3 2\n";
  const std::string text = "mtllib a.mtl none.mtl b.mtl\n" + faces;
  const Mesh mesh = Mesh::load(folder.write("in a/a.obj", text));
  mesh.save(folder / "in a/b.obj");
  EXPECT_EQ(read_text(folder / "in a/b.obj"), text);
  mesh.save(folder / "out/b.obj");
  EXPECT_EQ(read_text(folder / "out/b.obj"),
            "mtllib ../in a/a.mtl \nmtllib none.mtl \nmtllib ../in a/b.mtl\n" + faces);
  const Mesh moved = Mesh::load(folder / "out/b.obj");
  aiColor4D colour;
  moved.scene().mMaterials[2]->Get(AI_MATKEY_COLOR_DIFFUSE, colour);
  EXPECT_EQ(colour, aiColor4D(0, 0, 1, 1));

  const auto ply = [](const std::string& from) {
    return "ply\nformat ascii 1.0\ncomment TextureFile " + from + "a.png\ncomment TextureFile " +
           from + "b.png\nelement vertex 1\nproperty float x\nproperty float y\n" +
           "property float z\nend_header\n0 0 0\n";
  };
  Mesh::load(folder.write("in a/a.ply", ply(""))).save(folder / "out/a.ply");
  EXPECT_EQ(read_text(folder / "out/a.ply"), ply("../in a/"));
}

/// A triangle of 300, 0, 0 and so on in this unit, as Assimp writes it but for the unit.
std::filesystem::path dae_file(const TempFolder& folder, const std::string& unit) {
  Mesh::load(folder.write("a.obj", "v 0 0 0\nv 300 0 0\nv 0 1.7 0\nf 1 2 3\n"))
      .save(folder / "a.dae");
  std::string text = read_text(folder / "a.dae");
  const std::string metre = "<unit name=\"meter\" meter=\"1\" />";
  EXPECT_NE(text.find(metre), std::string::npos) << text;
  text.replace(text.find(metre), metre.size(), unit);
  return folder.write("a.dae", text);
}

TEST_F(MeshNames, UnitOfDaeIsKept) {
  const Mesh mesh = Mesh::load(dae_file(folder, "<unit name=\"centimeter\" meter=\"0.01\" />"));
  EXPECT_EQ(mesh.positions()(1, 0), 300);
  EXPECT_EQ(again(mesh, "b.dae").positions(), mesh.positions());
  expect_part(read_text(folder / "b.dae"), "meter=\"0.01\"");
  EXPECT_EQ(again(mesh, "b.obj").positions(), mesh.positions());
  // Metres by definition.
  EXPECT_FLOAT_EQ(static_cast<float>(again(mesh, "b.glb").positions()(1, 0)), 3.0f);
}

/// Whichever axis points up, coordinates are those in the file.
TEST_F(MeshNames, UpAxisOfDaeIsKept) {
  const std::filesystem::path path =
      dae_file(folder, "<unit name=\"centimeter\" meter=\"0.01\" />");
  const std::string text = read_text(path);
  const std::string up = "<up_axis>Y_UP</up_axis>";
  ASSERT_NE(text.find(up), std::string::npos);
  const Points positions = Mesh::load(path).positions();
  for (const std::string axis : {"X", "Y", "Z"}) {
    std::string turned = text;
    turned.replace(turned.find(up), up.size(), "<up_axis>" + axis + "_UP</up_axis>");
    const Mesh mesh = load(turned, "b.dae");
    EXPECT_EQ(mesh.positions(), positions) << axis;
    EXPECT_EQ(again(mesh, "c.dae").positions(), positions) << axis;
    expect_part(read_text(folder / "c.dae"), "<up_axis>" + axis + "_UP</up_axis>");
    expect_part(read_text(folder / "c.dae"), "meter=\"0.01\"");
    EXPECT_EQ(again(mesh, "c.obj").positions(), positions) << axis;
    // In glTF y points up, by definition.
    const Points upright = again(mesh, "c.glb").positions();
    const int a = axis[0] - 'X';
    EXPECT_NEAR((upright.col(1) - 0.01 * positions.col(a)).cwiseAbs().maxCoeff(), 0, 1e-9) << axis;
  }
}

TEST_F(MeshNames, DroppedPropertiesOfPly) {
  const Mesh mesh = load(
      "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\n"
      "property float z\nproperty float quality\nelement face 1\n"
      "property list uchar int vertex_indices\nproperty uchar red\nelement edge 1\n"
      "property int vertex1\nend_header\n0 0 0 1\n1 0 0 1\n0 1 0 1\n3 0 1 2 7\n1\n",
      "a.ply");
  EXPECT_EQ(mesh.dropped(), (std::vector<std::string>{"property quality of vertex",
                                                      "property red of face", "element edge"}));
}

TEST_F(MeshNames, DroppedAnimationsAndCameras) {
  load(kNamedTriangle).save(folder / "a.gltf");
  nlohmann::json file = nlohmann::json::parse(read_text(folder / "a.gltf"));
  file["cameras"] = {{{"type", "perspective"}, {"perspective", {{"yfov", 1}, {"znear", 1}}}}};
  file["nodes"].push_back({{"name", "eye"}, {"camera", 0}});
  file["nodes"][0]["children"].push_back(file["nodes"].size() - 1);
  file["animations"] = {
      {{"samplers", {{{"input", 2}, {"output", 0}}}},
       {"channels", {{{"sampler", 0}, {"target", {{"node", 0}, {"path", "translation"}}}}}}}};
  const Mesh mesh = load(file.dump(), "b.gltf");
  EXPECT_EQ(mesh.dropped(), (std::vector<std::string>{"1 animation", "1 camera"}));
}

TEST_F(MeshNames, ObjectNamesThatObjDrops) {
  const Mesh mesh = load(std::string("o car\ng wheel\n") + kNamedTriangle + "g wheel 2\nf 1 3 2\n");
  EXPECT_EQ(
      mesh.save(folder / "b.ply"),
      (std::vector<std::string>{"order of vertices", "part names", "names of empty objects"}));
  // A vertex of the file is one in each of the two parts.
  EXPECT_EQ(mesh.save(folder / "b.glb"), std::vector<std::string>{"order of vertices"});
}

}  // namespace
}  // namespace hwffd
