// glTF and GLB files as they are read: types, places and joins of their numbers, what they refer
// to, and what is refused.

#include <assimp/material.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "errors.hpp"
#include "gltf_model.hpp"
#include "mesh_files.hpp"

namespace hwffd {
namespace {

class GltfRead : public MeshFiles {
 protected:
  Points positions(const GltfModel& model) const {
    return load(model.text(), "a.gltf").positions();
  }
  std::string error(const std::string& text, const std::string& name = "a.gltf") const {
    const std::filesystem::path path = folder.write(name, text);
    std::string message = message_of<Error>([&] { Mesh::load(path); });
    expect_part(message, path.string() + ": ");
    return message;
  }
};

Points points_of(const std::vector<double>& values) {
  return Eigen::Map<const Points>(values.data(), static_cast<Eigen::Index>(values.size() / 3), 3);
}

/// Integers, plain and normalized, with and without gaps (KHR_mesh_quantization), under a node that
/// gives them their size.
TEST_F(GltfRead, QuantizedPositions) {
  int checked = 0;
  const auto check = [&](auto most, bool is_normalized, std::size_t stride) {
    using T = decltype(most);
    GltfModel model = square();
    model.json["extensionsUsed"] = {"KHR_mesh_quantization"};
    model.json["extensionsRequired"] = {"KHR_mesh_quantization"};
    model.json["nodes"][0]["scale"] = {2, 2, 2};
    model.primitive()["attributes"]["POSITION"] = model.add<T>(
        {0, 0, 0, most, 0, 0, most, most, 0, 0, most, 0}, "VEC3", stride, is_normalized);
    const double size = is_normalized ? 2.0 : 2.0 * most;
    EXPECT_EQ(positions(model), size * points_of({0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0}));
    ++checked;
  };
  for (const bool is_normalized : {false, true}) {
    for (const std::size_t gap : {0, 1}) {
      check(std::int8_t{127}, is_normalized, 4 * gap);
      check(std::uint8_t{255}, is_normalized, 4 * gap);
      check(std::int16_t{32767}, is_normalized, 8 * gap);
      check(std::uint16_t{65535}, is_normalized, 8 * gap);
    }
  }
  EXPECT_EQ(checked, 16);
}

/// The smallest of a signed type stands for -1, too (glTF 2.0, section 3.6.2.2).
TEST_F(GltfRead, NormalizedIntegersDoNotPassOne) {
  GltfModel model = square();
  model.primitive()["attributes"]["POSITION"] =
      model.add<std::int8_t>({-128, -127, 127, 0, 0, 0, 1, 1, 1, 0, 0, 0}, "VEC3", 4, true);
  EXPECT_EQ(Eigen::RowVector3d(positions(model).row(0)), Eigen::RowVector3d(-1, -1, 1));
}

/// Two attributes in turn in one view.
TEST_F(GltfRead, InterleavedAttributes) {
  GltfModel model = square();
  const std::size_t both = model.add<float>(
      {9, 0, 0, 0, 0, 1, 8, 0, 0, 0, 0, 1, 8, 7, 0, 0, 0, 1, 6, 7, 0, 0, 0, 1}, "VEC3");
  Json& accessors = model.json["accessors"];
  model.json["bufferViews"][both]["byteStride"] = 24;
  accessors[both]["count"] = 4;
  accessors.push_back(accessors[both]);
  accessors.back()["byteOffset"] = 12;
  model.primitive()["attributes"] = {{"POSITION", both}, {"NORMAL", both + 1}};
  const Mesh mesh = load(model.text(), "a.gltf");
  EXPECT_EQ(mesh.positions(), points_of({9, 0, 0, 8, 0, 0, 8, 7, 0, 6, 7, 0}));
  each_vertex(mesh, [](const aiMesh& part, unsigned v) {
    EXPECT_EQ(part.mNormals[v], aiVector3D(0, 0, 1));
  });
}

/// Elements that take the place of others, or of zeros where there are none.
TEST_F(GltfRead, SparsePositions) {
  for (const bool has_base : {true, false}) {
    GltfModel model = square();
    const std::size_t indices = model.add<std::uint8_t>({1, 3}, "SCALAR");
    const std::size_t values = model.add<float>({5, 6, 7, 8, 9, 10}, "VEC3");
    Json& position = model.json["accessors"][0];
    position["sparse"] = {{"count", 2},
                          {"indices", {{"bufferView", indices}, {"componentType", 5121}}},
                          {"values", {{"bufferView", values}}}};
    if (!has_base) position.erase("bufferView");
    const double one = has_base ? 1 : 0;
    Points expected = points_of({0, 0, 0, 5, 6, 7, one, one, 0, 8, 9, 10});
    if (!has_base) {  // two corners in one place
      expected = points_of({0, 0, 0, 5, 6, 7, 8, 9, 10});
    }
    EXPECT_EQ(positions(model), expected);
  }
}

/// Every way to join vertices (section 3.7.2.1), with indices and without.
TEST_F(GltfRead, Modes) {
  struct Mode {
    int mode;
    unsigned faces;
    unsigned corners;
  };
  for (const Mode& mode : std::vector<Mode>{
           {0, 5, 1}, {1, 2, 2}, {2, 5, 2}, {3, 4, 2}, {4, 1, 3}, {5, 3, 3}, {6, 3, 3}}) {
    for (const bool is_indexed : {true, false}) {
      GltfModel model = square();
      model.primitive()["attributes"]["POSITION"] =
          model.add<float>({0, 0, 0, 1, 0, 0, 0, 1, 0, 1, 1, 0, 0, 2, 0}, "VEC3");
      model.primitive()["indices"] = model.add<std::uint32_t>({0, 1, 2, 3, 4}, "SCALAR");
      model.primitive()["mode"] = mode.mode;
      if (!is_indexed) model.primitive().erase("indices");
      const Mesh mesh = load(model.text(), "a.gltf");
      const aiMesh& part = *mesh.scene().mMeshes[0];
      ASSERT_EQ(part.mNumFaces, mode.faces) << mode.mode;
      EXPECT_EQ(part.mFaces[0].mNumIndices, mode.corners) << mode.mode;
      EXPECT_EQ(mesh.vertex_count_read(), 5u);
      if (mode.mode != 5) continue;
      for (const Mesh::Triangle& t : mesh.triangles()) {  // all seen from above
        const Eigen::RowVector3d a = mesh.positions().row(t[1]) - mesh.positions().row(t[0]);
        const Eigen::RowVector3d b = mesh.positions().row(t[2]) - mesh.positions().row(t[0]);
        EXPECT_GT(a.x() * b.y() - a.y() * b.x(), 0);
      }
    }
  }
}

/// Parts of a mesh that have their attributes in common have vertices in common.
TEST_F(GltfRead, PartsShareVertices) {
  GltfModel model = square();
  Json& primitives = model.json["meshes"][0]["primitives"];
  primitives.push_back(primitives[0]);
  primitives[1]["mode"] = 1;
  const Mesh mesh = load(model.text(), "a.gltf");
  EXPECT_EQ(mesh.vertex_count_read(), 4u);
  EXPECT_EQ(mesh.scene().mNumMeshes, 2u);
}

/// Node transforms in double: the sum is not rounded to binary32 in between.
TEST_F(GltfRead, TransformsAreDouble) {
  GltfModel model = square();
  model.json["nodes"] = Json::parse(R"([{"children": [1], "translation": [5e6, 0, 0]},
    {"mesh": 0, "matrix": [0.125,0,0,0, 0,0.125,0,0, 0,0,0.125,0, 0.25,0,0,1]}])");
  EXPECT_EQ(positions(model)(1, 0), 5e6 + 0.125 + 0.25);
  EXPECT_EQ(positions(model)(3, 2), 0.0625);
}

TEST_F(GltfRead, FilesBesideIt) {
  const GltfModel model = square();
  for (const auto& [uri, name] : std::vector<std::pair<std::string, std::string>>{
           {"my%20bin.bin", "my bin.bin"},
           {"a%c3%a4.bin", "a\u00e4.bin"},
           {"100%.bin", "100%.bin"},
           {"my bin.bin", "my bin.bin"},
           {"a%zzb%4.bin", "a%zzb%4.bin"},
           {"./a:b.bin", "a:b.bin"},
           {"a_b:c.bin", "a_b:c.bin"},     // no scheme has a _
           {"a%20b.bin", "a%20b.bin"}}) {  // of a writer that encodes nothing
    const auto file = folder.write(name, model.bytes);
    EXPECT_EQ(load(model.text(uri), "a.gltf").vertex_count(), 4u) << uri;
    std::filesystem::remove(file);
    expect_part(error(model.text(uri)), "buffer 0: there is no file '");
  }
  for (const std::string uri : {"/dev/zero", "https://example.org/a.bin", "."}) {
    expect_part(error(model.text(uri)), "buffer 0: there is no file '");
  }
  folder.write("short.bin", "x");
  expect_part(error(model.text("short.bin")), "buffer 0: has 1 bytes, 60 by its byteLength");
}

TEST_F(GltfRead, RequiredExtensions) {
  for (const std::string name : {"KHR_materials_unlit", "KHR_texture_transform"}) {
    GltfModel model = square();
    model.json["extensionsRequired"] = {name};
    EXPECT_EQ(load(model.text(), "a.gltf").vertex_count(), 4u) << name;
  }
  GltfModel model = square();
  model.json["extensionsRequired"] = {"VENDOR_secret_layout"};
  for (const auto& [name, text] :
       {std::pair("a.gltf", model.text()), {"a.glb", model.container()}}) {
    expect_part(error(text, name),
                "requires the extension VENDOR_secret_layout, which is not known here");
  }
  model.json.erase("extensionsRequired");
  model.json["extensionsUsed"] = {"VENDOR_secret_layout"};  // a helping of salt, not the meal
  EXPECT_EQ(load(model.text(), "a.gltf").vertex_count(), 4u);
}

TEST_F(GltfRead, CompressedGeometry) {
  for (const char* list : {"extensionsUsed", "extensionsRequired"}) {
    for (const std::string name :
         {"KHR_draco_mesh_compression", "EXT_meshopt_compression", "KHR_meshopt_compression"}) {
      GltfModel model = square();
      model.json[list] = {name};
      expect_part(error(model.text()), "its geometry is compressed by " + name);
    }
  }
  GltfModel model = square();  // in no list
  model.primitive()["extensions"]["KHR_draco_mesh_compression"] = {{"bufferView", 0}};
  expect_part(error(model.text()), "its geometry is compressed by KHR_draco_mesh_compression");
}

/// Sizes, offsets and numbers that lead out of what is there.
TEST_F(GltfRead, BrokenReferences) {
  struct Bad {
    const char* pointer;
    Json value;
    const char* message;
  };
  const std::vector<Bad> all{
      {"/accessors/0/count", 5, "accessor 0: ends behind the 48 bytes of its bufferView"},
      {"/accessors/0/count", 9007199254740991, "accessor 0: ends behind"},
      {"/accessors/0/count", -1, "accessor 0: its count is no whole number"},
      {"/accessors/0/byteOffset", 4, "accessor 0: ends behind"},
      {"/accessors/0/byteOffset", 18446744073709551615u, "accessor 0: ends behind"},
      {"/accessors/0/bufferView", 7, "accessor 0: its bufferView is 7 of 2"},
      {"/accessors/0/componentType", 5124, "a componentType that glTF does not know, 5124"},
      {"/accessors/0/type", "VEC5", "has a type that glTF does not know, 'VEC5'"},
      {"/accessors/0/type", "VEC2", "POSITION is an accessor of 2 components, not 3"},
      {"/bufferViews/0/byteLength", 100, "bufferView 0: ends behind the 60 bytes of buffer 0"},
      {"/bufferViews/0/byteOffset", 18446744073709551600u, "bufferView 0: ends behind"},
      {"/bufferViews/0/byteStride", 4, "its byteStride is 4, its elements have 12 bytes"},
      {"/bufferViews/0/buffer", 1, "bufferView 0: its buffer is 1 of 1"},
      {"/meshes/0/primitives/0/attributes/POSITION", 9, "its POSITION is 9 of 2"},
      {"/meshes/0/primitives/0/attributes/NORMAL", 1, "NORMAL is an accessor of 1 components"},
      {"/meshes/0/primitives/0/attributes/TEXCOORD_0", 1, "has 6 elements for 4 vertices"},
      {"/meshes/0/primitives/0/indices", 9, "its indices is 9 of 2"},
      {"/meshes/0/primitives/0/mode", 7, "has a mode that glTF does not know, 7"},
      {"/meshes/0/primitives/0/material", 0, "its material is 0 of 0"},
      {"/nodes/0/mesh", 1, "node 0: its mesh is 1 of 1"},
      {"/nodes/0/children", {0}, "node 0: stands twice in the tree of nodes"},
      {"/nodes/0/scale", {1, 1}, "node 0: its scale has 2 numbers, not 3"},
      {"/nodes/0/matrix", {1}, "node 0: its matrix has 1 numbers, not 16"},
      {"/nodes/0", 3, "node 0: is no object"},
      {"/scene", 1, "its scene is 1 of 1"},
      {"/asset/version", "1.0", "glTF version 1.0"},
      {"/accessors", 3, "its accessors are no array"},
      {"/accessors/0/count", 3.5, "accessor 0: its count is no whole number"},
      {"/accessors/0/count", -4.0, "accessor 0: its count is no whole number"},
      {"/accessors/0/count", 1e300, "accessor 0: its count is no whole number"},
      {"/accessors/0/normalized", 1, "accessor 0: its normalized is neither true nor false"},
      {"/accessors/0",
       {{"bufferView", 0}, {"componentType", 5126}, {"count", 3}, {"type", "MAT2"}},
       "POSITION is an accessor of 4 components, not 3"},
      {"/accessors/0",
       {{"bufferView", 0}, {"componentType", 5121}, {"count", 5}, {"type", "MAT3"}},
       "accessor 0: ends behind the 48 bytes of its bufferView"},  // of columns of four bytes
      {"/bufferViews/0", {{"byteLength", 48}}, "bufferView 0: has no buffer"},
      {"/nodes/0/name", 3, "node 0: its name is no text"},
      {"/nodes/0/scale", {1, "1", 1}, "node 0: its scale has an entry that is no number"},
      {"/nodes/0/children", {"a"}, "node 0: its children has an entry that is none of 1"},
      {"/scenes/0/nodes", {1}, "scene 0: its nodes has an entry that is none of 1"},
      {"/extensionsUsed", {3}, "the file: its extensionsUsed has an entry that is no text"},
      {"/materials", {{{"alphaCutoff", "half"}}}, "material 0: its alphaCutoff is no number"}};
  for (const Bad& bad : all) {
    SCOPED_TRACE(bad.pointer);
    GltfModel model = square();
    model.json[Json::json_pointer(bad.pointer)] = bad.value;
    expect_part(error(model.text()), bad.message);
    expect_part(error(model.container(), "a.glb"), bad.message);
  }
  EXPECT_EQ(all.size(), 40u);
  GltfModel model = square();
  model.primitive()["indices"] = model.add<std::uint8_t>({0, 1, 4}, "SCALAR");
  expect_part(error(model.text()), "refers to vertex 4 of 4; repair the mesh");
}

/// 4.0 is a whole number, too.
TEST_F(GltfRead, WholeNumbersWithAPoint) {
  GltfModel model = square();
  model.json["accessors"][0]["count"] = 4.0;
  model.json["scene"] = 0.0;
  EXPECT_EQ(positions(model), positions(square()));
}

/// A file without scenes shows all of its nodes.
TEST_F(GltfRead, NodesWithoutAScene) {
  GltfModel model = square();
  model.json["nodes"] =
      Json::parse(R"([{"mesh": 0}, {"children": [0], "translation": [0, 0, 5]}, {"mesh": 0}])");
  model.json.erase("scenes");
  model.json.erase("scene");
  const Mesh mesh = load(model.text(), "a.gltf");
  EXPECT_EQ(mesh.vertex_count(), 8u);
  EXPECT_EQ(mesh.positions()(0, 2), 5);
  EXPECT_EQ(mesh.positions()(4, 2), 0);
}

/// Primitives without positions are not shown; where there are no others, nothing is.
TEST_F(GltfRead, NothingToShow) {
  GltfModel model = square();
  Json& primitives = model.json["meshes"][0]["primitives"];
  primitives.push_back({{"attributes", Json::object()}});
  EXPECT_EQ(load(model.text(), "a.gltf").scene().mNumMeshes, 1u);
  primitives.erase(primitives.begin());
  expect_part(error(model.text()), "holds no vertices");
  model = square();
  model.json["scenes"][0]["nodes"] = Json::array();
  expect_part(error(model.text()), "holds no vertices");
}

/// Lists too short for the faces of their mode have none.
TEST_F(GltfRead, ModesOfOneCorner) {
  for (const int mode : {1, 2, 3, 4, 5, 6}) {
    GltfModel model = square();
    model.primitive()["indices"] = model.add<std::uint8_t>({2}, "SCALAR");
    model.primitive()["mode"] = mode;
    const Mesh mesh = load(model.text(), "a.gltf");
    EXPECT_EQ(mesh.scene().mMeshes[0]->mNumFaces, 0u) << mode;
    EXPECT_EQ(mesh.vertex_count(), 4u) << mode;
  }
}

/// Indices of zeros but for a few, without a view of their own.
TEST_F(GltfRead, SparseIndices) {
  GltfModel model = square();
  const std::size_t places = model.add<std::uint16_t>({1, 2}, "SCALAR");
  const std::size_t values = model.add<std::uint16_t>({2, 3}, "SCALAR");
  model.json["accessors"].push_back(
      {{"componentType", 5123},
       {"count", 3},
       {"type", "SCALAR"},
       {"sparse",
        {{"count", 2},
         {"indices", {{"bufferView", places}, {"componentType", 5123}}},
         {"values", {{"bufferView", values}}}}}});
  model.primitive()["indices"] = model.json["accessors"].size() - 1;
  EXPECT_EQ(load(model.text(), "a.gltf").triangles(), (std::vector<Mesh::Triangle>{{0, 2, 3}}));
}

/// A part has the colours and texture coordinates that it names, and no more than eight sets.
TEST_F(GltfRead, SetsOfEachPart) {
  GltfModel model = square();
  Json& primitives = model.json["meshes"][0]["primitives"];
  primitives.push_back(primitives[0]);
  primitives.push_back(primitives[0]);
  const std::vector<std::uint8_t> red{255, 0, 0, 255, 0, 0, 255, 0, 0, 255, 0, 0};
  const std::vector<float> green{0, 1, 0, 0.5f, 0, 1, 0, 0.5f, 0, 1, 0, 0.5f, 0, 1, 0, 0.5f};
  primitives[0]["attributes"]["COLOR_0"] = model.add(red, "VEC3", 4, true);
  primitives[1]["attributes"]["COLOR_0"] = model.add(green, "VEC4");
  const std::vector<float> places{0, 1, 0, 0.75f, 1, 1, 1, 0};
  primitives[1]["attributes"]["TEXCOORD_1"] = model.add(places, "VEC2");
  primitives[1]["attributes"]["TEXCOORD_9"] = model.add(places, "VEC2");
  const Mesh mesh = load(model.text(), "a.gltf");
  ASSERT_EQ(mesh.scene().mNumMeshes, 3u);
  const aiMesh& first = *mesh.scene().mMeshes[0];
  const aiMesh& second = *mesh.scene().mMeshes[1];
  EXPECT_EQ(first.mColors[0][3], aiColor4D(1, 0, 0, 1));
  EXPECT_FALSE(first.HasTextureCoords(0));
  EXPECT_EQ(second.mColors[0][3], aiColor4D(0, 1, 0, 0.5f));
  ASSERT_EQ(second.GetNumUVChannels(), 1u);
  EXPECT_EQ(second.mTextureCoords[0][1], aiVector3D(0, 0.25f, 0));
  EXPECT_FALSE(mesh.scene().mMeshes[2]->HasVertexColors(0));
}

/// Base64 of either alphabet, with line ends in between.
TEST_F(GltfRead, DataUris) {
  GltfModel model = square();
  // Of a coordinate that has the digits + and / in base64.
  const std::vector<float> places{-1.9375f, 0, 0, 1, 0, 0, -1.99609375f, 1, 0, 0, 1, 0.5f};
  model.primitive()["attributes"]["POSITION"] = model.add(places, "VEC3");
  const std::string text = model.text();
  const Points expected = load(text, "a.gltf").positions();
  EXPECT_EQ(expected(0, 0), places[0]);
  const std::size_t begin = text.find("base64,") + 7;
  const std::size_t end = text.find('"', begin);
  const std::string plain = text.substr(begin, end - begin);
  ASSERT_NE(plain.find_first_of("+/"), plain.npos);
  const auto with = [&](const std::string& data) {
    return text.substr(0, begin) + data + text.substr(end);
  };
  std::string alphabet = plain;
  std::replace(alphabet.begin(), alphabet.end(), '+', '-');
  std::replace(alphabet.begin(), alphabet.end(), '/', '_');
  std::string blanks = plain;
  for (const char* blank : {"\\n", "\\r", "\\t", " "}) blanks.insert(8, blank);
  for (const std::string& data : {alphabet, blanks}) {
    EXPECT_EQ(load(with(data), "a.gltf").positions(), expected);
  }
  std::string percent = text;
  percent.replace(percent.find(";base64"), 7, "");
  std::string comma = text;
  comma.replace(begin - 1, 1, "");
  for (const std::string& broken : {with("AA*A" + plain), percent, comma, with("")}) {
    const bool is_empty = broken == with("");
    expect_part(error(broken),
                is_empty ? "buffer 0: has 0 bytes" : "buffer 0: its data URI is not base64");
  }
}

/// Two buffers of one file; a buffer that has neither a name nor the chunk of a GLB.
TEST_F(GltfRead, HomesOfBuffers) {
  GltfModel model = square();
  folder.write("a.bin", model.bytes);
  Json json = Json::parse(model.text("a.bin"));
  json["buffers"].push_back(json["buffers"][0]);
  json["bufferViews"][1]["buffer"] = 1;
  EXPECT_EQ(load(json.dump(), "a.gltf").positions(), positions(model));
  json["buffers"][0].erase("uri");
  expect_part(error(json.dump()), "buffer 0: has no uri");
  Json all = json_in(model.container());
  all["buffers"].push_back({{"byteLength", 1}});
  std::string text = all.dump();
  text.resize((text.size() + 3) / 4 * 4, ' ');
  const auto size = static_cast<std::uint32_t>(text.size());
  const std::string container = model.container();
  const std::string chunk = container.substr(container.find(std::string("BIN\0", 4)) - 4);
  const auto length = static_cast<std::uint32_t>(20 + size + chunk.size());
  expect_part(
      error("glTF" + bytes_of<std::uint32_t>({2, length, size}) + "JSON" + text + chunk, "a.glb"),
      "buffer 1: has no uri");
}

TEST_F(GltfRead, BrokenSparse) {
  for (const auto& [index, message] :
       {std::pair<std::uint8_t, const char*>(4, "a sparse accessor replaces element 4 of 4")}) {
    GltfModel model = square();
    const std::size_t indices = model.add<std::uint8_t>({index}, "SCALAR");
    model.json["accessors"][0]["sparse"] = {
        {"count", 1},
        {"indices", {{"bufferView", indices}, {"componentType", 5121}}},
        {"values", {{"bufferView", 0}}}};
    expect_part(error(model.text()), message);
    model.json["accessors"][0]["sparse"]["count"] = 2;
    expect_part(error(model.text()), "ends behind the 1 bytes of its bufferView");
    model.json["accessors"][0]["sparse"]["count"] = 1;
    for (const char* part : {"values", "indices"}) {
      model.json["accessors"][0]["sparse"].erase(part);
      expect_part(error(model.text()),
                  part == std::string("values")
                      ? "values of sparse of accessor 0: has no bufferView"
                      : "indices of sparse of accessor 0: has no componentType");
    }
    model.json["accessors"][0]["sparse"]["indices"] = {{"componentType", 5121}};
    expect_part(error(model.text()), "indices of sparse of accessor 0: has no bufferView");
  }
}

/// Meshes that nodes repeat until no memory would hold them.
TEST_F(GltfRead, TooManyVertices) {
  GltfModel model = square();
  model.json["accessors"][0].erase("bufferView");
  model.json["accessors"][0]["count"] = 4000000000;
  model.primitive().erase("indices");
  expect_part(error(model.text()), "nodes show over ");
}

TEST_F(GltfRead, JsonNestedTooDeeply) {
  GltfModel model = square();
  std::string text = model.text();
  const std::string deep = std::string(50000, '[') + std::string(50000, ']');
  text.replace(text.find("\"scene\""), 0, "\"extras\":" + deep + ",");
  expect_part(error(text), "its JSON is nested over 1000 deep");
}

TEST_F(GltfRead, NodesNestedTooDeeply) {
  GltfModel model = square();
  Json nodes = Json::array();
  for (int n = 0; n < 2000; ++n) nodes.push_back({{"children", {n + 1}}});
  nodes.push_back({{"mesh", 0}});
  model.json["nodes"] = nodes;
  expect_part(error(model.text()), "nodes are nested over 1000 deep");
}

TEST_F(GltfRead, Containers) {
  const std::string good = square().container();
  EXPECT_EQ(load(good, "a.glb").vertex_count(), 4u);
  EXPECT_EQ(load(good, "a.gltf").vertex_count(), 4u);  // its bytes say what it is
  EXPECT_EQ(load(square().text(), "a.glb").vertex_count(), 4u);
  EXPECT_EQ(load("\xEF\xBB\xBF" + square().text(), "a.gltf").vertex_count(), 4u);
  EXPECT_EQ(load(good + "trailing", "a.glb").vertex_count(), 4u);
  for (const std::size_t size : {6u, 19u, 100u}) {
    expect_part(error(good.substr(0, size), "a.glb"), "not a mesh that can be read (the file ends");
  }
  std::string other = good;
  other[4] = 1;
  expect_part(error(other, "a.glb"), "GLB version 1, not 2");
  expect_part(error("{\"asset\":\n x", "a.gltf"), "no JSON in line 2, column 2");
  expect_part(error("{\"asset\": 1e999}", "a.gltf"), "a number too large for double precision");
  expect_part(error("[]", "a.gltf"), "its JSON is no object");
  expect_part(error("", "a.gltf"), "no JSON in line 1, column 1");
  expect_part(error(std::string("{\"asset\":\0 {}}", 13), "a.gltf"), "a zero byte in its JSON");
  other = good;
  other.replace(16, 4, std::string("BIN\0", 4));
  expect_part(error(other, "a.glb"), "its first chunk is not JSON");
  // A container of JSON alone, with its buffer in the text.
  std::string text = square().text();
  text.resize((text.size() + 3) / 4 * 4, ' ');
  const auto size = static_cast<std::uint32_t>(text.size());
  const std::string alone = "glTF" + bytes_of<std::uint32_t>({2, 20 + size, size}) + "JSON" + text;
  const Mesh mesh = load(alone, "a.glb");
  EXPECT_EQ(mesh.vertex_count(), 4u);
  EXPECT_TRUE(mesh.save(folder / "b.glb").empty());
  EXPECT_EQ(read_text(folder / "b.glb"), alone);
}

/// Alpha comes through every chain of formats that has it once, however often.
TEST_F(GltfRead, AlphaIsNotSquared) {
  GltfModel model = square();
  model.json["materials"] = {{{"name", "glass"},
                              {"pbrMetallicRoughness", {{"baseColorFactor", {1, 1, 1, 0.5}}}},
                              {"alphaMode", "BLEND"}}};
  model.primitive()["material"] = 0;
  int checked = 0;
  for (const std::vector<std::string>& chain :
       std::vector<std::vector<std::string>>{{"b.obj", "c.gltf"},
                                             {"b.dae", "c.gltf"},
                                             {"b.dae", "c.obj", "d.gltf"},
                                             {"b.obj", "c.dae", "d.obj", "e.dae", "f.gltf"},
                                             {"b.gltf", "c.obj", "d.gltf", "e.obj", "f.gltf"}}) {
    Mesh mesh = load(model.text(), "a.gltf");
    for (const std::string& name : chain) mesh = again(mesh, name);
    const Json file = Json::parse(read_text(folder / chain.back()));
    for (const Json& material : file["materials"]) {
      if (material["name"] != "glass") continue;
      EXPECT_FLOAT_EQ(material["pbrMetallicRoughness"]["baseColorFactor"][3].get<float>(), 0.5f)
          << chain.front();
      ++checked;
    }
  }
  EXPECT_EQ(checked, 5);
}

/// Materials of one name, and those without any, are not taken for one in other formats, nor is the
/// one's colour taken for lost by the other.
TEST_F(GltfRead, MaterialsOfOneName) {
  for (const std::string& name : {std::string("paint"), std::string()}) {
    GltfModel model = square();
    model.json["meshes"].push_back(Json(model.json["meshes"][0]));
    model.json["nodes"].push_back({{"mesh", 1}});
    model.json["scenes"][0]["nodes"] = {0, 1};
    for (const std::size_t m : {0u, 1u}) {
      model.primitive(m)["material"] = m;
      Json& material = model.json["materials"][m];
      if (!name.empty()) material["name"] = name;
      material["pbrMetallicRoughness"] = {{"baseColorFactor", {1 - m, 0, m, 1}}};
    }
    const Mesh mesh = load(model.text(), "a.gltf");
    for (const char* file : {"b.obj", "b.dae"}) {
      SCOPED_TRACE(name + " " + file);
      const std::vector<std::string> losses = mesh.save(folder / file);
      EXPECT_EQ(std::count(losses.begin(), losses.end(), "statement kd of materials"), 0);
      const Mesh written = Mesh::load(folder / file);
      std::set<float> reds;
      for (unsigned p = 0; p < written.scene().mNumMeshes; ++p) {
        const unsigned m = written.scene().mMeshes[p]->mMaterialIndex;
        aiColor4D colour;
        written.scene().mMaterials[m]->Get(AI_MATKEY_COLOR_DIFFUSE, colour);
        reds.insert(colour.r);
      }
      EXPECT_EQ(reds, (std::set<float>{0, 1}));
    }
  }
}

/// What other formats do not hold is named.
TEST_F(GltfRead, WhatIsDropped) {
  GltfModel model = square();
  model.primitive()["attributes"]["_TEMPERATURE"] = model.add<float>({1, 2, 3, 4}, "SCALAR");
  model.primitive()["targets"] = {{{"POSITION", 0}}};
  model.json["extensionsUsed"] = {"KHR_materials_ior"};
  model.json["materials"] = {{{"normalTexture", {{"index", 0}, {"scale", 0.5}}}}};
  model.json["textures"] = {{{"source", 0}}};
  model.json["images"] = {{{"uri", "a.png"}}};
  model.json["nodes"][0]["extras"] = {{"a", 1}};
  EXPECT_EQ(
      load(model.text(), "a.gltf").dropped(),
      (std::vector<std::string>{"1 morph target", "settings of textures", "attribute _TEMPERATURE",
                                "extension KHR_materials_ior", "extras"}));
}

}  // namespace
}  // namespace hwffd
