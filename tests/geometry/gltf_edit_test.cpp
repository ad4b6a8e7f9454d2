// glTF and GLB files that come back in their own format: every byte that does not move stays.

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <sstream>

#include "errors.hpp"
#include "gltf_model.hpp"
#include "mesh_files.hpp"

namespace hwffd {
namespace {

/// The numbers of an accessor without gaps, as they are stored.
template <typename T>
std::vector<T> stored(const Json& json, const std::string& buffer, std::size_t accessor) {
  const Json& about = json["accessors"][accessor];
  const Json& view = json["bufferViews"][about["bufferView"].get<std::size_t>()];
  const std::string type = about["type"];
  const std::size_t components = type == "SCALAR" ? 1 : static_cast<std::size_t>(type[3] - '0');
  const std::size_t stride = view.value("byteStride", components * sizeof(T));
  const std::size_t begin =
      view.value("byteOffset", std::size_t{0}) + about.value("byteOffset", std::size_t{0});
  std::vector<T> values(about["count"].get<std::size_t>() * components);
  for (std::size_t i = 0; i < values.size(); ++i) {
    const std::size_t at = begin + i / components * stride + i % components * sizeof(T);
    EXPECT_LE(at + sizeof(T), buffer.size());
    std::memcpy(&values[i], buffer.data() + at, sizeof(T));
  }
  return values;
}

class GltfEdit : public MeshFiles {
 protected:
  /// The model with all vertices shifted, saved as GLB.
  std::string shifted(const GltfModel& model, const Eigen::RowVector3d& by) const {
    Mesh mesh = load(model.container(), "a.glb");
    mesh.set_positions(mesh.positions().rowwise() + by, identities(mesh));
    EXPECT_EQ(mesh.save(folder / "b.glb"), std::vector<std::string>{});
    return read_text(folder / "b.glb");
  }
  /// The model mirrored along x, saved as GLB.
  std::string mirrored(const GltfModel& model) const {
    Mesh mesh = load(model.container(), "a.glb");
    Eigen::Matrix3d mirror = Eigen::Matrix3d::Identity();
    mirror(0, 0) = -1;
    mesh.set_positions(mesh.positions() * mirror,
                       std::vector<Eigen::Matrix3d>(mesh.vertex_count(), mirror));
    EXPECT_EQ(mesh.save(folder / "b.glb"), std::vector<std::string>{});
    return read_text(folder / "b.glb");
  }
  static std::vector<Eigen::Matrix3d> identities(const Mesh& mesh) {
    return std::vector<Eigen::Matrix3d>(mesh.vertex_count(), Eigen::Matrix3d::Identity());
  }
};

TEST_F(GltfEdit, NothingMovesNothingChanges) {
  const GltfModel model = adorned();
  std::string tail = model.container() + "behind the end";
  const std::string extra = bytes_of<std::uint32_t>({4}) + "XTRAdata";
  std::string chunks = model.container() + extra;
  const auto length = static_cast<std::uint32_t>(chunks.size());
  std::memcpy(&chunks[8], &length, sizeof(length));
  std::string escaped = model.text();
  const std::string slash = "application/octet";
  escaped.replace(escaped.find(slash), slash.size(), "application\\/octet");
  int checked = 0;
  for (const auto& [name, text] : std::vector<std::pair<std::string, std::string>>{
           {"a.gltf", model.text()},
           {"a.gltf", escaped},
           {"a.gltf", "\xEF\xBB\xBF\r\n " + model.text() + "\r\n\t"},
           {"a.glb", model.container()},
           {"a.glb", chunks},
           {"a.glb", tail}}) {
    Mesh mesh = load(text, name);
    const std::string output = "b" + name.substr(1);
    EXPECT_EQ(mesh.save(folder / output), std::vector<std::string>{});
    EXPECT_EQ(read_text(folder / output), text) << name;
    mesh.set_positions(mesh.positions(), identities(mesh));
    mesh.save(folder / output);
    EXPECT_EQ(read_text(folder / output), text) << name;
    ++checked;
  }
  EXPECT_EQ(checked, 6);
}

/// All bytes but those of positions, and of the JSON but min and max.
TEST_F(GltfEdit, OnlyPositionsChange) {
  const GltfModel model = adorned();
  const std::string before = model.container();
  const std::string after = shifted(model, {0, 0.25, 0});
  // The node turns x to y: in its own space it moved along x.
  Json json = json_in(after);
  EXPECT_EQ(json["accessors"][0]["min"], (Json{0.25, 0, 0.0}));
  EXPECT_EQ(json["accessors"][0]["max"], (Json{1.25, 1, 0.5}));
  json["accessors"][0]["min"] = {0, 0, 0.0};
  json["accessors"][0]["max"] = {1, 1, 0.5};
  EXPECT_EQ(json.dump(), json_in(before).dump());
  EXPECT_EQ(stored<float>(json, buffer_in(after), 0),
            (std::vector<float>{0.25f, 0, 0, 1.25f, 0, 0, 1.25f, 1, 0, 0.25f, 1, 0.5f}));
  const std::string old = buffer_in(before);
  std::string edited = buffer_in(after);
  edited.replace(0, 48, old, 0, 48);
  EXPECT_EQ(edited, old);
  const Points moved =
      Mesh::load(folder / "a.glb").positions().rowwise() + Eigen::RowVector3d(0, 0.25, 0);
  EXPECT_LE((Mesh::load(folder / "b.glb").positions() - moved).cwiseAbs().maxCoeff(), 1e-15);
}

/// The same in a data URI, where the text of what stays is the same, too.
TEST_F(GltfEdit, DataUriIsChangedInPlace) {
  const std::string before = adorned().text();
  Mesh mesh = load(before, "a.gltf");
  Points moved = mesh.positions();
  moved.row(3) *= 2;
  mesh.set_positions(moved, identities(mesh));
  mesh.save(folder / "b.gltf");
  std::istringstream before_lines(before);
  std::istringstream after_lines(read_text(folder / "b.gltf"));
  std::vector<std::string> differ;
  for (std::string line, now; std::getline(before_lines, line);) {
    std::getline(after_lines, now);
    if (now == line) continue;
    differ.push_back(line);
    const std::size_t data = line.find("base64,") + 7;
    if (data < 7) continue;
    ASSERT_EQ(now.size(), line.size());
    for (std::size_t at = 0; at < line.size(); ++at) {
      if (at >= data + 36 / 3 * 4 && at < data + 48 / 3 * 4) continue;
      EXPECT_EQ(now[at], line[at]) << at;
    }
  }
  EXPECT_EQ(differ.size(), 3u);  // two numbers of max, and the buffer
  EXPECT_LE((Mesh::load(folder / "b.gltf").positions() - moved).cwiseAbs().maxCoeff(), 1e-15);
}

/// Normals and tangents turn with the mesh, each in its own type; the last number of a tangent says
/// on which side the third direction lies, and follows a mirror.
TEST_F(GltfEdit, NormalsAndTangentsFollow) {
  GltfModel model = adorned();
  model.json["nodes"][0].erase("rotation");
  Mesh mesh = load(model.container(), "a.glb");
  Eigen::Matrix3d turn;  // x to z, z to -x
  turn << 0, 0, -1, 0, 1, 0, 1, 0, 0;
  mesh.set_positions(mesh.positions() * turn.transpose(), std::vector<Eigen::Matrix3d>(4, turn));
  mesh.save(folder / "b.glb");
  const std::string after = read_text(folder / "b.glb");
  const Json json = json_in(after);
  const Json& attributes = json["meshes"][0]["primitives"][0]["attributes"];
  EXPECT_EQ(attributes, model.primitive()["attributes"]);
  const auto normals = stored<std::int8_t>(json, buffer_in(after), attributes["NORMAL"]);
  const auto tangents = stored<float>(json, buffer_in(after), attributes["TANGENT"]);
  for (std::size_t v = 0; v < 4; ++v) {
    EXPECT_EQ(normals[3 * v], -127) << v;
    EXPECT_EQ(tangents[4 * v + 2], 1) << v;
    EXPECT_EQ(tangents[4 * v + 3], 1) << v;
  }
  const std::string mirror = mirrored(model);
  const auto sides = stored<float>(json_in(mirror), buffer_in(mirror), attributes["TANGENT"]);
  EXPECT_EQ(sides[0], -1);
  EXPECT_EQ(sides[3], -1);
}

TEST_F(GltfEdit, QuantizedPositions) {
  GltfModel model = square();
  model.json["extensionsRequired"] = {"KHR_mesh_quantization"};
  const std::size_t position =
      model.add<std::int8_t>({0, 0, 0, 100, 0, 0, 100, 100, 0, 0, 100, 50}, "VEC3", 4);
  model.json["accessors"][position]["min"] = {0, 0, 0};
  model.json["accessors"][position]["max"] = {100, 100, 50};
  model.primitive()["attributes"]["POSITION"] = position;
  model.json["nodes"][0]["scale"] = {0.01, 0.01, 0.01};
  const std::string after = shifted(model, {0.1, 0, -0.203});
  const Json json = json_in(after);
  EXPECT_EQ(stored<std::int8_t>(json, buffer_in(after), position),
            (std::vector<std::int8_t>{10, 0, -20, 110, 0, -20, 110, 100, -20, 10, 100, 30}));
  EXPECT_EQ(json["accessors"][position]["min"], (Json{10, 0, -20}));
  EXPECT_EQ(json["accessors"][position]["max"], (Json{110, 100, 30}));
  const std::string gap = buffer_in(after).substr(60 + 3, 1);
  EXPECT_EQ(gap, "\xaa") << "the gap between elements";
  Mesh mesh = Mesh::load(folder / "a.glb");
  mesh.set_positions(mesh.positions().array() + 1, identities(mesh));
  EXPECT_ERROR(mesh.save(folder / "c.glb"),
               (folder / "c.glb").string() +
                   ": vertex 1 of mesh 0, primitive 0: its coordinate 200 does not fit the numbers "
                   "of accessor 2; write another format, such as ply");
  EXPECT_EQ(folder.files().count("c.glb"), 0u);
  EXPECT_TRUE(mesh.save(folder / "c.ply").empty());
}

/// A mesh that two nodes show and that moves apart: the first keeps its accessors, the second gets
/// a mesh of its own behind the bytes that were read.
TEST_F(GltfEdit, InstancesMoveApart) {
  GltfModel model = square();
  model.json["nodes"] = Json::parse(R"([{"mesh": 0, "children": [1, 2]},
    {"mesh": 0, "translation": [10, 0, 0]}, {"mesh": 0, "translation": [0, 0, 5]}])");
  model.json["meshes"][0]["name"] = "tile";
  Mesh mesh = load(model.container(), "a.glb");
  EXPECT_EQ(mesh.vertex_count(), 12u);
  Points moved = mesh.positions();
  for (Eigen::Index v = 0; v < moved.rows(); ++v) moved(v, 1) += moved(v, 0) * 0.25;
  mesh.set_positions(moved, identities(mesh));
  mesh.save(folder / "b.glb");
  const std::string after = read_text(folder / "b.glb");
  const Json json = json_in(after);
  EXPECT_EQ(Mesh::load(folder / "b.glb").positions(), moved);
  ASSERT_EQ(json["meshes"].size(), 2u);  // the first and third move alike
  EXPECT_EQ(json["meshes"][1]["name"], "tile");
  EXPECT_EQ(json["nodes"][0]["mesh"], 0);
  EXPECT_EQ(json["nodes"][1]["mesh"], 1);
  EXPECT_EQ(json["nodes"][2]["mesh"], 0);
  EXPECT_EQ(json["accessors"].size(), 3u);
  EXPECT_EQ(json["accessors"][2]["max"], (Json{1.0, 3.75, 0.5}));
  EXPECT_EQ(json["meshes"][1]["primitives"][0]["indices"], 1);
  EXPECT_EQ(buffer_in(after).substr(48, 12), model.bytes.substr(48));
  EXPECT_EQ(json["buffers"][0]["byteLength"], 108);
}

/// What has other uses than the place of vertices stays for them.
TEST_F(GltfEdit, OtherUsesStay) {
  struct Use {
    const char* pointer;
    Json value;
  };
  const std::vector<Use> all{
      {"/meshes/0/primitives/0/attributes/TEXCOORD_0", 0},
      {"/meshes/0/primitives/0/targets", {{{"POSITION", 0}}}},
      {"/animations",
       Json::parse(R"([{"samplers": [{"input": 1, "output": 0}], "channels": []}])")},
      {"/accessors/2",
       {{"bufferView", 0}, {"componentType", 5126}, {"count", 2}, {"type", "VEC4"}}},
      {"/images", {{{"bufferView", 0}, {"mimeType", "image/png"}}}},
      {"/nodes/1", {{"mesh", 0}}}};  // in no scene
  for (const Use& use : all) {
    SCOPED_TRACE(use.pointer);
    GltfModel model = square();
    model.json[Json::json_pointer(use.pointer)] = use.value;
    if (std::string(use.pointer).find("TEXCOORD") != std::string::npos) {
      model.json["accessors"][0]["type"] = "VEC3";
    }
    const std::string after = shifted(model, {0, 0, 1});
    EXPECT_EQ(buffer_in(after).substr(0, model.bytes.size()), model.bytes);
    EXPECT_EQ(buffer_in(after).size(), model.bytes.size() + 48);
    EXPECT_EQ(Mesh::load(folder / "b.glb").positions()(3, 2), 1.5);
    // And where nothing moves, nothing is added.
    EXPECT_EQ(shifted(model, {0, 0, 0}), model.container());
  }
  EXPECT_EQ(all.size(), 6u);
}

/// Of zeros, too, where nothing but the elements that replace them is stored.
TEST_F(GltfEdit, SparsePositionsBecomeDense) {
  for (const bool has_base : {true, false}) {
    GltfModel model = square();
    const std::size_t indices = model.add<std::uint8_t>({1}, "SCALAR");
    const std::size_t values = model.add<float>({5, 6, 7}, "VEC3");
    Json& sparse = model.json["accessors"][0];
    sparse["sparse"] = {{"count", 1},
                        {"indices", {{"bufferView", indices}, {"componentType", 5121}}},
                        {"values", {{"bufferView", values}}}};
    if (!has_base) {
      sparse.erase("bufferView");
      sparse.erase("max");
    }
    EXPECT_EQ(shifted(model, {0, 0, 0}), model.container());
    const std::string after = shifted(model, {0, 0, 1});
    const Json json = json_in(after);
    EXPECT_EQ(json["accessors"][0], json_in(model.container())["accessors"][0]);
    const std::size_t position = json["meshes"][0]["primitives"][0]["attributes"]["POSITION"];
    EXPECT_EQ(position, json["accessors"].size() - 1);
    EXPECT_FALSE(json["accessors"][position].contains("sparse"));
    const std::vector<float> expected =
        has_base ? std::vector<float>{0, 0, 1, 5, 6, 8, 1, 1, 1, 0, 1, 1.5f}
                 : std::vector<float>{0, 0, 1, 5, 6, 8, 0, 0, 1, 0, 0, 1};
    EXPECT_EQ(stored<float>(json, buffer_in(after), position), expected);
    EXPECT_EQ(json["accessors"][position]["min"], (Json{0.0, 0.0, 1.0}));
    if (!has_base) {
      EXPECT_EQ(json["accessors"][position]["max"], (Json{5.0, 6.0, 8.0}));
    }
  }
}

/// Positions and normals in turn in one view: positions change in place, unless an accessor has
/// some of their bytes, too. Its offset is from the first position.
TEST_F(GltfEdit, InterleavedPositions) {
  struct Other {
    std::size_t view;  ///< 0: that of both, 1: one of all bytes
    Json accessor;
    bool is_in_place;
  };
  const std::vector<Other> others{
      {0, {{"byteOffset", 0}, {"componentType", 5126}, {"count", 0}, {"type", "SCALAR"}}, true},
      {0, {{"byteOffset", 8}, {"componentType", 5126}, {"count", 4}, {"type", "SCALAR"}}, false},
      {0, {{"byteOffset", 16}, {"componentType", 5126}, {"count", 3}, {"type", "VEC3"}}, false},
      {1, {{"componentType", 5121}, {"count", 156}, {"type", "SCALAR"}}, false}};
  for (const bool is_first : {true, false}) {
    for (const Other& other : others) {
      SCOPED_TRACE(other.accessor.dump());
      GltfModel model = square();
      const std::vector<float> one{9, 0, 0, 8, 0, 0, 8, 7, 0, 6, 7, 0};
      std::vector<float> both;
      for (std::size_t v = 0; v < 4; ++v) {
        if (!is_first) both.insert(both.end(), {0, 0, 1});
        both.insert(both.end(), &one[3 * v], &one[3 * v] + 3);
        if (is_first) both.insert(both.end(), {0, 0, 1});
      }
      const std::size_t number = model.add(both, "VEC3");
      Json& accessors = model.json["accessors"];
      Json& views = model.json["bufferViews"];
      views[number]["byteStride"] = 24;
      views.push_back({{"buffer", 0}, {"byteLength", model.bytes.size()}});
      accessors[number]["count"] = 4;
      accessors.push_back(accessors[number]);
      accessors.back()["byteOffset"] = 12;
      accessors.push_back(other.accessor);
      accessors.back()["bufferView"] = number + other.view;
      if (other.view == 0 && !is_first) {
        accessors.back()["byteOffset"] = other.accessor["byteOffset"].get<std::size_t>() + 12;
      }
      const std::size_t position = number + (is_first ? 0 : 1);
      const std::size_t normal = number + (is_first ? 1 : 0);
      model.primitive()["attributes"] = {{"POSITION", position}, {"NORMAL", normal}};
      const std::string after = shifted(model, {0, 0, 1});
      const Json json = json_in(after);
      const std::string buffer = buffer_in(after);
      EXPECT_EQ(buffer.size(), model.bytes.size() + (other.is_in_place ? 0 : 48));
      const std::size_t now = json["meshes"][0]["primitives"][0]["attributes"]["POSITION"];
      EXPECT_EQ(stored<float>(json, buffer, now),
                (std::vector<float>{9, 0, 1, 8, 0, 1, 8, 7, 1, 6, 7, 1}));
      EXPECT_EQ(stored<float>(json, buffer, normal),
                (std::vector<float>{0, 0, 1, 0, 0, 1, 0, 0, 1, 0, 0, 1}));
      if (!other.is_in_place) {
        EXPECT_EQ(buffer.substr(0, model.bytes.size()), model.bytes);
      }
    }
  }
}

/// The first of two instances moves, in place; the second gets what was there before.
TEST_F(GltfEdit, OneInstanceMoves) {
  GltfModel model = square();
  model.json["nodes"] =
      Json::parse(R"([{"mesh": 0, "children": [1]}, {"mesh": 0, "translation": [10, 0, 0]}])");
  Mesh mesh = load(model.container(), "a.glb");
  Points moved = mesh.positions();
  moved.topRows(4).col(1).array() += 0.25;
  mesh.set_positions(moved, identities(mesh));
  mesh.save(folder / "b.glb");
  EXPECT_EQ(Mesh::load(folder / "b.glb").positions(), moved);
  const std::string after = read_text(folder / "b.glb");
  const Json json = json_in(after);
  EXPECT_EQ(json["nodes"][1]["mesh"], 1);
  EXPECT_EQ(buffer_in(after).substr(60), model.bytes.substr(0, 48));
  EXPECT_EQ(json["accessors"][2]["max"], (Json{1.0, 1.0, 0.5}));
  EXPECT_EQ(json["accessors"][0]["max"], (Json{1, 1.25, 0.5}));
}

/// Positions that are all 0 need not be stored; once they move they are, where there is a buffer.
TEST_F(GltfEdit, PositionsThatAreNotStored) {
  GltfModel model = square();
  model.json["accessors"] = {{{"componentType", 5126}, {"count", 3}, {"type", "VEC3"}}};
  model.json.erase("bufferViews");
  model.primitive().erase("indices");
  const std::string text = model.text();
  Mesh mesh = load(text, "a.gltf");
  EXPECT_EQ(mesh.positions(), Points::Zero(1, 3));
  mesh.save(folder / "b.gltf");
  EXPECT_EQ(read_text(folder / "b.gltf"), text);
  mesh.set_positions(Eigen::RowVector3d(1, 2, 3), identities(mesh));
  mesh.save(folder / "b.gltf");
  const Mesh again = Mesh::load(folder / "b.gltf");
  EXPECT_EQ(again.positions(), mesh.positions());
  EXPECT_EQ(again.vertex_count_read(), 3u);
  const Json json = Json::parse(read_text(folder / "b.gltf"));
  EXPECT_EQ(json["bufferViews"].size(), 1u);
  EXPECT_EQ(json["buffers"][0]["byteLength"], model.bytes.size() + 36);

  mesh = load(model.json.dump(), "a.gltf");  // without its buffer
  mesh.set_positions(Eigen::RowVector3d(1, 2, 3), identities(mesh));
  EXPECT_ERROR_PART(mesh.save(folder / "c.gltf"),
                    "it has no buffer for what has moved; give its positions a buffer");
}

/// Elements of an attribute begin at multiples of four bytes.
TEST_F(GltfEdit, NewQuantizedPositions) {
  GltfModel model = square();
  model.json["extensionsRequired"] = {"KHR_mesh_quantization"};
  const std::size_t position =
      model.add<std::int8_t>({0, 0, 0, 100, 0, 0, 100, 100, 0, 0, 100, 50}, "VEC3", 4);
  model.primitive()["attributes"]["POSITION"] = position;
  model.primitive()["targets"] = {{{"POSITION", position}}};  // which stays
  const std::string after = shifted(model, {1, 2, 3});
  const Json json = json_in(after);
  const std::size_t now = json["meshes"][0]["primitives"][0]["attributes"]["POSITION"];
  EXPECT_EQ(stored<std::int8_t>(json, buffer_in(after), now),
            (std::vector<std::int8_t>{1, 2, 3, 101, 2, 3, 101, 102, 3, 1, 102, 53}));
  EXPECT_EQ(json["bufferViews"].back()["byteStride"], 4);
  EXPECT_EQ(json["meshes"][0]["primitives"][0]["targets"][0]["POSITION"], position);
  EXPECT_EQ(buffer_in(after).substr(0, model.bytes.size()), model.bytes);
}

/// What moves by less than its numbers can tell has not changed.
TEST_F(GltfEdit, ChangesThatAreRoundedAway) {
  GltfModel model = square();
  model.json["extensionsRequired"] = {"KHR_mesh_quantization"};
  Json& attributes = model.primitive()["attributes"];
  attributes["POSITION"] =
      model.add<std::int8_t>({0, 0, 0, 100, 0, 0, 100, 100, 0, 0, 100, 50}, "VEC3", 4);
  attributes["NORMAL"] =
      model.add<std::int8_t>({0, 0, 127, 0, 0, 127, 0, 0, 127, 0, 0, 127}, "VEC3", 4, true);
  Mesh mesh = load(model.container(), "a.glb");
  const Eigen::Matrix3d turn = Eigen::AngleAxisd(1e-3, Eigen::Vector3d::UnitX()).toRotationMatrix();
  mesh.set_positions(mesh.positions() * turn.transpose(), std::vector<Eigen::Matrix3d>(4, turn));
  mesh.save(folder / "b.glb");
  EXPECT_EQ(read_text(folder / "b.glb"), model.container());
}

/// Smallest and largest that are no three numbers stay as they are.
TEST_F(GltfEdit, BrokenBoundsStay) {
  GltfModel model = square();
  model.json["accessors"][0]["min"] = {0, 0};
  model.json["accessors"][0]["max"] = {1, nullptr, 0.5};
  const Json json = json_in(shifted(model, {1, 1, 1}));
  EXPECT_EQ(json["accessors"][0]["min"], (Json{0, 0}));
  EXPECT_EQ(json["accessors"][0]["max"], (Json{2, nullptr, 1.5}));
}

/// A mesh that a node of no scene shows as well: that node keeps all of it.
TEST_F(GltfEdit, NodesOutsideOfTheSceneStay) {
  GltfModel model = adorned();
  model.json["meshes"].push_back(Json(square().json["meshes"][0]));
  model.json["nodes"].push_back({{"mesh", 1}});
  model.json["nodes"].push_back({{"mesh", 0}});
  model.json["scenes"][0]["nodes"] = {0, 1};
  EXPECT_EQ(shifted(model, {0, 0, 0}), model.container());
  const std::string after = shifted(model, {0, 0.25, 0});
  const Json json = json_in(after);
  EXPECT_EQ(buffer_in(after).substr(0, model.bytes.size()), model.bytes);
  EXPECT_EQ(json["meshes"][0], json_in(model.container())["meshes"][0]);
  EXPECT_EQ(json["nodes"][2]["mesh"], 0);
  EXPECT_EQ(json["nodes"][0]["mesh"], 2);
  const Json& before = model.primitive()["attributes"];
  Json attributes = json["meshes"][2]["primitives"][0]["attributes"];
  EXPECT_NE(attributes["POSITION"], before["POSITION"]);
  attributes["POSITION"] = before["POSITION"];
  EXPECT_EQ(attributes, before);
}

/// A node that is a mirror image has tangents whose third direction is on the other side; in the
/// file it stays where it was.
TEST_F(GltfEdit, TangentsOfAMirrorImage) {
  GltfModel model = adorned();
  model.json["nodes"][0].erase("rotation");
  model.json["nodes"][0]["scale"] = {-1, 1, 1};
  Mesh mesh = load(model.container(), "a.glb");
  Eigen::Matrix3d turn;  // x to y, y to -x
  turn << 0, -1, 0, 1, 0, 0, 0, 0, 1;
  mesh.set_positions(mesh.positions() * turn.transpose(), std::vector<Eigen::Matrix3d>(4, turn));
  mesh.save(folder / "b.glb");
  const std::string after = read_text(folder / "b.glb");
  const std::size_t tangent = model.primitive()["attributes"]["TANGENT"];
  const auto tangents = stored<float>(json_in(after), buffer_in(after), tangent);
  for (std::size_t v = 0; v < 4; ++v) {
    EXPECT_EQ(std::vector<float>(&tangents[4 * v], &tangents[4 * v] + 4),
              (std::vector<float>{0, -1, 0, 1}))
        << v;
  }
}

/// Triangles of each kind face outwards after a mirror.
TEST_F(GltfEdit, MirrorsTurnTriangles) {
  int checked = 0;
  for (const int mode : {4, 5, 6}) {
    for (const std::size_t corners : {5u, 6u}) {
      for (const bool is_indexed : {true, false}) {
        GltfModel model = square();
        const std::vector<float> places{0, 0, 0, 1, 0, 0, 0, 1, 0, 1, 1, 0, 0, 2, 0, 1, 2, 0};
        model.primitive()["attributes"]["POSITION"] =
            model.add(std::vector<float>(places.begin(),
                                         places.begin() + 3 * static_cast<std::ptrdiff_t>(corners)),
                      "VEC3");
        std::vector<std::uint8_t> indices(corners);
        for (std::size_t i = 0; i < corners; ++i) indices[i] = static_cast<std::uint8_t>(i);
        model.primitive()["indices"] = model.add(indices, "SCALAR");
        model.primitive()["mode"] = mode;
        if (!is_indexed) model.primitive().erase("indices");
        const Mesh before = load(model.container(), "a.glb");
        const std::string after = mirrored(model);
        const Mesh mesh = Mesh::load(folder / "b.glb");
        EXPECT_EQ(mesh.vertex_count_read(), corners);
        const auto areas = [](const Mesh& m) {
          std::multiset<double> areas;  // above and below, twice
          for (const Mesh::Triangle& t : m.triangles()) {
            const Eigen::RowVector3d a = m.positions().row(t[1]) - m.positions().row(t[0]);
            const Eigen::RowVector3d b = m.positions().row(t[2]) - m.positions().row(t[0]);
            const double area = a.x() * b.y() - a.y() * b.x();
            if (area != 0) areas.insert(area);
          }
          return areas;
        };
        EXPECT_EQ(areas(mesh), areas(before)) << mode << corners << is_indexed;
        const bool in_place = is_indexed && !(mode == 5 && corners == 6);
        EXPECT_EQ(buffer_in(after).size() == buffer_in(model.container()).size(), in_place);
        ++checked;
      }
    }
  }
  EXPECT_EQ(checked, 12);
}

/// Indices that a mirror gives to several primitives are stored once; lists of none stay.
TEST_F(GltfEdit, MirrorsTurnPrimitivesAlike) {
  GltfModel model = square();
  Json& primitives = model.json["meshes"][0]["primitives"];
  primitives[0].erase("indices");
  primitives[0]["mode"] = 6;
  primitives.push_back(primitives[0]);
  const std::string after = mirrored(model);
  const Json json = json_in(after);
  const std::size_t indices = json["meshes"][0]["primitives"][0]["indices"];
  EXPECT_EQ(json["meshes"][0]["primitives"][1]["indices"], indices);
  EXPECT_EQ(json["accessors"].size(), 3u);
  EXPECT_EQ(stored<std::uint16_t>(json, buffer_in(after), indices),
            (std::vector<std::uint16_t>{0, 3, 2, 1}));
  for (const int mode : {4, 5, 6}) {
    GltfModel empty = square();
    empty.primitive()["indices"] = empty.add<std::uint8_t>({}, "SCALAR");
    empty.primitive()["mode"] = mode;
    const Json now = json_in(mirrored(empty));
    EXPECT_EQ(now["meshes"], json_in(empty.container())["meshes"]) << mode;
  }
}

/// A strip that a mirror makes longer may be a short one of vertices that 16 bits do not number.
TEST_F(GltfEdit, MirrorsTurnStripsOfManyVertices) {
  constexpr std::uint32_t kVertices = 70000;
  GltfModel model = square();
  std::vector<float> places(3 * (kVertices - 4), 0.0f);
  places.insert(places.end(), {0, 0, 0, 1, 0, 0, 0, 1, 0, 1, 1, 0});
  model.primitive()["attributes"]["POSITION"] = model.add(places, "VEC3");
  model.primitive()["indices"] = model.add<std::uint32_t>(
      {kVertices - 4, kVertices - 3, kVertices - 2, kVertices - 1}, "SCALAR");
  model.primitive()["mode"] = 5;
  const Json json = json_in(mirrored(model));
  const std::size_t indices = json["meshes"][0]["primitives"][0]["indices"];
  EXPECT_EQ(stored<std::uint32_t>(json, buffer_in(read_text(folder / "b.glb")), indices),
            (std::vector<std::uint32_t>{kVertices - 4, kVertices - 4, kVertices - 3, kVertices - 2,
                                        kVertices - 1}));
}

/// What acts on the shape at rest is named, and stays.
TEST_F(GltfEdit, SkinsAndMorphTargetsStay) {
  GltfModel model = adorned();
  model.json["nodes"].push_back({{"name", "bone"}});
  model.json["scenes"][0]["nodes"].push_back(1);
  model.json["nodes"][0]["skin"] = 0;
  model.json["skins"] = {{{"joints", {1}}}};
  const Mesh mesh = load(model.container(), "a.glb");
  EXPECT_EQ(mesh.unfollowed(), (std::vector<std::string>{"1 skin", "1 morph target"}));
  Json json = json_in(shifted(model, {0, 0.25, 0}));
  for (const char* bound : {"min", "max"}) {
    json["accessors"][0][bound] = model.json["accessors"][0][bound];
  }
  EXPECT_EQ(json, json_in(model.container()));
}

/// A node without size shows nothing that could move.
TEST_F(GltfEdit, NodesWithoutSizeStay) {
  GltfModel model = square();
  model.json["nodes"][0]["scale"] = {1, 0, 1};
  EXPECT_EQ(shifted(model, {0, 1, 0}), model.container());
}

}  // namespace
}  // namespace hwffd
