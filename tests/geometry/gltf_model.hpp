#pragma once

#include <cstdint>
#include <cstring>
#include <nlohmann/json.hpp>
#include <string>
#include <type_traits>
#include <vector>

namespace hwffd {

using Json = nlohmann::ordered_json;

inline std::string base64_of(const std::string& bytes) {
  const std::string digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string text;
  for (std::size_t at = 0; at < bytes.size(); at += 3) {
    std::uint32_t word = 0;
    for (std::size_t i = at; i < at + 3; ++i) {
      word = word << 8 | (i < bytes.size() ? static_cast<unsigned char>(bytes[i]) : 0u);
    }
    for (std::size_t d = 0; d < 4; ++d) {
      text += at + d > bytes.size() ? '=' : digits[word >> (18 - 6 * d) & 63];
    }
  }
  return text;
}

template <typename T>
std::string bytes_of(const std::vector<T>& values) {
  return {reinterpret_cast<const char*>(values.data()), values.size() * sizeof(T)};
}

/// A number of glTF for the type of a component.
template <typename T>
int component_type() {
  if (std::is_same_v<T, float>) return 5126;
  return 5119 + 2 * (sizeof(T) == 4 ? 3 : static_cast<int>(sizeof(T))) +
         (std::is_signed_v<T> ? -1 : 0);
}

/// A glTF file that a test builds: its JSON, and one buffer.
struct GltfModel {
  Json json{{"asset", {{"version", "2.0"}}},
            {"scene", 0},
            {"scenes", {{{"nodes", {0}}}}},
            {"nodes", {{{"mesh", 0}}}},
            {"meshes", {{{"primitives", {{{"attributes", Json::object()}}}}}}},
            {"accessors", Json::array()},
            {"bufferViews", Json::array()}};
  std::string bytes;

  /// Adds an accessor with a view of its own. With a stride, elements have gaps of 0xAA.
  /// @return its number
  template <typename T>
  std::size_t add(const std::vector<T>& values, const std::string& type, std::size_t stride = 0,
                  bool is_normalized = false) {
    const std::size_t components = type == "SCALAR" ? 1 : static_cast<std::size_t>(type[3] - '0');
    const std::size_t size = components * sizeof(T);
    bytes.resize((bytes.size() + 3) / 4 * 4);
    const std::size_t begin = bytes.size();
    const std::string all = bytes_of(values);
    for (std::size_t at = 0; at < all.size(); at += size) {
      bytes += all.substr(at, size);
      if (stride > size) bytes.append(stride - size, '\xaa');
    }
    Json view{{"buffer", 0}, {"byteOffset", begin}, {"byteLength", bytes.size() - begin}};
    if (stride > 0) view["byteStride"] = stride;
    json["bufferViews"].push_back(view);
    Json accessor{{"bufferView", json["bufferViews"].size() - 1},
                  {"componentType", component_type<T>()},
                  {"count", values.size() / components},
                  {"type", type}};
    if (is_normalized) accessor["normalized"] = true;
    json["accessors"].push_back(accessor);
    return json["accessors"].size() - 1;
  }

  Json& primitive(std::size_t mesh = 0, std::size_t number = 0) {
    return json["meshes"][mesh]["primitives"][number];
  }

  /// As .gltf, the buffer in a data URI.
  std::string text() const {
    Json all = json;
    all["buffers"] = {{{"byteLength", bytes.size()},
                       {"uri", "data:application/octet-stream;base64," + base64_of(bytes)}}};
    return all.dump(1) + "\n";
  }

  /// As .gltf, the buffer in a file of this name.
  std::string text(const std::string& uri) const {
    Json all = json;
    all["buffers"] = {{{"byteLength", bytes.size()}, {"uri", uri}}};
    return all.dump();
  }

  /// As .glb.
  std::string container() const {
    Json all = json;
    all["buffers"] = {{{"byteLength", bytes.size()}}};
    const auto chunk = [](const std::string& type, std::string data, char fill) {
      data.resize((data.size() + 3) / 4 * 4, fill);
      return bytes_of<std::uint32_t>({static_cast<std::uint32_t>(data.size())}) + type + data;
    };
    const std::string body =
        chunk("JSON", all.dump(), ' ') + chunk(std::string("BIN\0", 4), bytes, '\0');
    return "glTF" + bytes_of<std::uint32_t>({2, static_cast<std::uint32_t>(12 + body.size())}) +
           body;
  }
};

/// Four corners of a square, 1 wide, in two triangles, all of binary32.
inline GltfModel square() {
  GltfModel model;
  const std::size_t position = model.add<float>({0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0.5f}, "VEC3");
  model.json["accessors"][position]["min"] = {0, 0, 0.0};
  model.json["accessors"][position]["max"] = {1, 1, 0.5};
  model.primitive()["attributes"]["POSITION"] = position;
  model.primitive()["indices"] = model.add<std::uint16_t>({0, 1, 2, 0, 2, 3}, "SCALAR");
  return model;
}

/// Odd blanks, names with escapes, numbers in unusual forms, and much that no mesh has.
inline GltfModel adorned() {
  GltfModel model = square();
  Json& json = model.json;
  json["asset"]["extras"] = {{"uri", "not a name of a file"}, {"n", 1.50}};
  json["nodes"][0]["name"] = "caf\u00e9 \"x\" \\ {[";
  json["nodes"][0]["rotation"] = {0, 0, 0.70710678, 0.70710678};
  json["materials"] = {{{"extensions", {{"KHR_materials_clearcoat", {{"clearcoatFactor", 0.5}}}}},
                        {"pbrMetallicRoughness", {{"baseColorFactor", {1, 1, 1, 0.5}}}},
                        {"normalTexture", {{"index", 0}, {"texCoord", 1}, {"scale", 0.5}}}}};
  json["textures"] = {{{"source", 0}}};
  json["images"] = {{{"uri", "my%20picture.png"}}};
  json["extensionsUsed"] = {"KHR_materials_clearcoat"};
  Json& attributes = model.primitive()["attributes"];
  attributes["NORMAL"] =
      model.add<std::int8_t>({0, 0, 127, 0, 0, 127, 0, 0, 127, 0, 0, 127}, "VEC3", 4, true);
  attributes["TANGENT"] =
      model.add<float>({1, 0, 0, 1, 1, 0, 0, 1, 1, 0, 0, 1, 1, 0, 0, 1}, "VEC4");
  attributes["COLOR_0"] =
      model.add<std::uint8_t>({255, 0, 0, 0, 255, 0, 0, 0, 255, 9, 9, 9}, "VEC3", 4, true);
  attributes["_ID"] = model.add<std::uint16_t>({4, 3, 2, 1}, "SCALAR", 4);
  model.primitive()["targets"] = {
      {{"POSITION", model.add<float>({0, 0, 1, 0, 0, 1, 0, 0, 1, 0, 0, 1}, "VEC3")}}};
  return model;
}

/// Nodes that repeat a mesh, a strip, a sparse accessor, interleaved and quantized ones.
inline GltfModel varied() {
  GltfModel model = adorned();
  const std::size_t small =
      model.add<std::int16_t>({0, 0, 0, 9, 0, 0, 0, 9, 0, 9, 9, 5}, "VEC3", 8);
  const std::size_t sparse = model.add<float>({0, 0, 0, 1, 0, 0, 0, 1, 0, 1, 1, 0}, "VEC3");
  const std::size_t places = model.add<std::uint8_t>({1, 2}, "SCALAR");
  const std::size_t values = model.add<float>({2, 3, 4, 5, 6, 7}, "VEC3");
  model.json["accessors"][sparse]["sparse"] = {
      {"count", 2},
      {"indices", {{"bufferView", places}, {"componentType", 5121}}},
      {"values", {{"bufferView", values}}}};
  Json& primitives = model.json["meshes"][0]["primitives"];
  primitives.push_back({{"attributes", {{"POSITION", small}}}, {"mode", 5}, {"material", 0}});
  model.json["meshes"].push_back(
      {{"primitives", {{{"attributes", {{"POSITION", sparse}}}, {"mode", 6}}}}});
  model.json["nodes"] = Json::parse(R"([{"name": "a", "mesh": 0, "children": [1, 2]},
    {"mesh": 0, "translation": [1, 2, 3], "rotation": [0, 0.6, 0, 0.8], "scale": [2, 1, -1]},
    {"name": "c", "mesh": 1, "matrix": [0,1,0,0, -1,0,0,0, 0,0,1,0, 5,0,0,1]}])");
  model.json["skins"] = {{{"joints", {2}}}};
  model.json["nodes"][0]["skin"] = 0;
  model.json["extensionsRequired"] = {"KHR_mesh_quantization"};
  return model;
}

/// The JSON of a .glb file.
inline Json json_in(const std::string& container) {
  std::uint32_t size = 0;
  std::memcpy(&size, container.data() + 12, sizeof(size));
  return Json::parse(container.substr(20, size));
}

/// The bytes of the binary chunk of a .glb file.
inline std::string buffer_in(const std::string& container) {
  std::uint32_t size = 0;
  std::memcpy(&size, container.data() + 12, sizeof(size));
  std::uint32_t length = 0;
  std::memcpy(&length, container.data() + 20 + size, sizeof(length));
  return container.substr(28 + size, length);
}

}  // namespace hwffd
