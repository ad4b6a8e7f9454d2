// Meshes that Assimp reads for this library: nodes, what is dropped, what is refused, and scenes on
// their way from the process that reads them.

#include <assimp/material.h>
#include <assimp/scene.h>
#include <gtest/gtest.h>

#include <array>
#include <cstring>
#include <string>
#include <vector>

#include "errors.hpp"
#include "gltf_model.hpp"
#include "mesh/read_scene.hpp"
#include "mesh_files.hpp"

namespace hwffd {
namespace {

/// A COLLADA file of one triangle, (0,0,0) (1,0,0) (0,1,0) unless told, which these nodes show.
struct DaeFile {
  std::string nodes = "<node><instance_geometry url=\"#g\"/></node>";
  std::string corners = "0 0 0 1 0 0 0 1 0";
  std::string unit = "1";
  std::string faces =
      "<triangles count=\"1\"><input semantic=\"VERTEX\" source=\"#v\" offset=\"0\"/>"
      "<input semantic=\"NORMAL\" source=\"#n\" offset=\"1\"/>"
      "<p>0 0 1 0 2 0</p></triangles>";
  std::string libraries;

  std::string text() const {
    const auto source = [](const std::string& name, const std::string& numbers, int rows) {
      const std::string count = std::to_string(rows);
      return "<source id=\"" + name + "\"><float_array id=\"" + name + "a\" count=\"" +
             std::to_string(3 * rows) + "\">" + numbers +
             "</float_array><technique_common><accessor source=\"#" + name + "a\" count=\"" +
             count +
             "\" stride=\"3\"><param name=\"X\" type=\"float\"/><param name=\"Y\" type=\"float\"/>"
             "<param name=\"Z\" type=\"float\"/></accessor></technique_common></source>";
    };
    return "<?xml version=\"1.0\"?>\n<COLLADA "
           "xmlns=\"http://www.collada.org/2005/11/COLLADASchema\" version=\"1.4.1\"><asset><unit "
           "name=\"u\" meter=\"" +
           unit + "\"/><up_axis>Y_UP</up_axis></asset>" + libraries +
           "<library_geometries><geometry id=\"g\" name=\"g\"><mesh>" + source("p", corners, 3) +
           source("n", "0.6 0 0.8", 1) +
           "<vertices id=\"v\"><input semantic=\"POSITION\" source=\"#p\"/></vertices>" + faces +
           "</mesh></geometry></library_geometries><library_visual_scenes><visual_scene id=\"s\">" +
           nodes +
           "</visual_scene></library_visual_scenes><scene><instance_visual_scene url=\"#s\"/>"
           "</scene></COLLADA>\n";
  }
};

class MeshByAssimp : public MeshFiles {
 protected:
  Mesh load_dae(const DaeFile& file) const { return load(file.text(), "a.dae"); }
};

/// Each place where nodes show a mesh is a part of its own, in its place; normals stay normal to
/// what is scaled, and triangles of mirror images face as their normals do.
TEST_F(MeshByAssimp, NodesPlaceTheirMeshes) {
  DaeFile file;
  file.nodes =
      "<node><instance_geometry url=\"#g\"/></node>"
      "<node><translate>10 0 0</translate><instance_geometry url=\"#g\"/>"
      "<node><scale>2 1 1</scale><instance_geometry url=\"#g\"/></node></node>"
      "<node><scale>-1 1 1</scale><instance_geometry url=\"#g\"/></node>";
  const Mesh mesh = load_dae(file);
  ASSERT_EQ(mesh.scene().mNumMeshes, 4u);
  const std::vector<std::array<aiVector3D, 3>> corners{
      {aiVector3D(0, 0, 0), aiVector3D(1, 0, 0), aiVector3D(0, 1, 0)},
      {aiVector3D(10, 0, 0), aiVector3D(11, 0, 0), aiVector3D(10, 1, 0)},
      {aiVector3D(10, 0, 0), aiVector3D(12, 0, 0), aiVector3D(10, 1, 0)},
      {aiVector3D(0, 0, 0), aiVector3D(0, 1, 0), aiVector3D(-1, 0, 0)}};
  const std::vector<aiVector3D> normals{aiVector3D(0.6f, 0, 0.8f), aiVector3D(0.6f, 0, 0.8f),
                                        aiVector3D(0.3f, 0, 0.8f).Normalize(),
                                        aiVector3D(-0.6f, 0, 0.8f)};
  for (unsigned m = 0; m < 4; ++m) {
    const aiMesh& part = *mesh.scene().mMeshes[m];
    ASSERT_EQ(part.mNumFaces, 1u);
    for (unsigned c = 0; c < 3; ++c) {
      const unsigned v = part.mFaces[0].mIndices[c];
      EXPECT_EQ(part.mVertices[v], corners[m][c]) << m << c;
      EXPECT_LT((part.mNormals[v] - normals[m]).Length(), 1e-6f) << m << c;
    }
  }
}

/// Lines have no side that a mirror turns.
TEST_F(MeshByAssimp, MirroredLines) {
  DaeFile file;
  file.faces =
      "<lines count=\"1\"><input semantic=\"VERTEX\" source=\"#v\" offset=\"0\"/><p>0 "
      "1</p></lines>";
  file.nodes = "<node><scale>-1 1 1</scale><instance_geometry url=\"#g\"/></node>";
  const Mesh mesh = load_dae(file);
  const aiMesh& part = *mesh.scene().mMeshes[0];
  ASSERT_EQ(part.mNumFaces, 1u);
  ASSERT_EQ(part.mFaces[0].mNumIndices, 2u);
  EXPECT_EQ(part.mVertices[part.mFaces[0].mIndices[1]], aiVector3D(-1, 0, 0));
}

TEST_F(MeshByAssimp, CamerasAndLightsAreDropped) {
  DaeFile file;
  file.libraries =
      "<library_cameras><camera id=\"c\"><optics><technique_common><perspective><xfov>45</xfov>"
      "<znear>1</znear><zfar>9</zfar></perspective></technique_common></optics></camera>"
      "</library_cameras><library_lights><light id=\"l\"><technique_common><point><color>1 1 1"
      "</color></point></technique_common></light></library_lights>";
  file.nodes +=
      "<node><instance_camera url=\"#c\"/></node><node><instance_light url=\"#l\"/></node>"
      "<node><translate>1 0 0</translate><instance_light url=\"#l\"/></node>";
  const Mesh mesh = load_dae(file);
  EXPECT_EQ(mesh.dropped(), (std::vector<std::string>{"1 camera", "2 lights"}));
  EXPECT_EQ(mesh.vertex_count(), 3u);
}

/// The file is named, then what is wrong with it.
TEST_F(MeshByAssimp, WhatIsRefused) {
  const auto error = [&](const DaeFile& file) {
    std::string text = message_of<Error>([&] { load_dae(file); });
    EXPECT_EQ(text.rfind((folder / "a.dae").string() + ": ", 0), 0u) << text;
    return text;
  };
  for (const std::string number : {"nan", "inf", "1e39"}) {
    for (int axis = 0; axis < 3; ++axis) {
      DaeFile file;
      file.corners = "0 0 0 1 0 0";
      for (int a = 0; a < 3; ++a) file.corners += a == axis ? " " + number : " 0";
      expect_part(error(file),
                  "vertex 2 has a coordinate that is not a finite binary32 number; repair or scale "
                  "the mesh");
    }
  }
  DaeFile far;  // finite until its node has placed it
  far.corners = "0 0 0 1e38 0 0 0 1e38 0";
  far.nodes = "<node><scale>100 100 1</scale><instance_geometry url=\"#g\"/></node>";
  expect_part(error(far), "has a coordinate that is not a finite binary32 number");
  DaeFile nothing;
  nothing.nodes = "<node/>";
  expect_part(error(nothing), "; accepted are obj, ply, stl, 3ds, glb, gltf, dae and what else");
}

/// A program of few formats has Assimp read glTF, whose vertices it numbers as the file does; the
/// scene that comes back from another process is the one that was read, with its pictures.
TEST_F(MeshByAssimp, ScenesArePacked) {
  GltfModel model = square();
  const std::string picture = "\x89PNG not really";
  const std::size_t bytes =
      model.add(std::vector<std::uint8_t>(picture.begin(), picture.end()), "SCALAR");
  model.json["images"] = {{{"bufferView", bytes}, {"mimeType", "image/png"}}};
  model.json["textures"] = {{{"source", 0}}};
  model.json["materials"] = {
      {{"name", "skin"}, {"pbrMetallicRoughness", {{"baseColorTexture", {{"index", 0}}}}}}};
  model.primitive()["material"] = 0;
  const std::string file = model.container();
  const ReadScene read = read_scene(folder.write("a.glb", file), file);
  EXPECT_EQ(read.numbers, (std::vector<std::uint32_t>{0, 1, 2, 3}));
  const std::string packed = pack(read);
  const ReadScene there = unpack(packed);
  EXPECT_EQ(pack(there), packed);
  EXPECT_EQ(there.numbers, read.numbers);
  ASSERT_EQ(there.scene->mNumTextures, 1u);
  const aiTexture& texture = *there.scene->mTextures[0];
  ASSERT_EQ(texture.mWidth, picture.size());
  EXPECT_EQ(std::memcmp(texture.pcData, picture.data(), picture.size()), 0);
  ASSERT_EQ(there.scene->mNumMeshes, 1u);
  const aiMesh& part = *there.scene->mMeshes[0];
  ASSERT_EQ(part.mNumVertices, 4u);
  EXPECT_EQ(part.mVertices[3], aiVector3D(0, 1, 0.5f));
  aiString name;
  there.scene->mMaterials[part.mMaterialIndex]->Get(AI_MATKEY_NAME, name);
  EXPECT_STREQ(name.C_Str(), "skin");
  for (const std::size_t size : {packed.size() - 1, packed.size() / 2, std::size_t{3}}) {
    EXPECT_ERROR(unpack(packed.substr(0, size)), "the bytes of its scene are broken");
  }
}

}  // namespace
}  // namespace hwffd
