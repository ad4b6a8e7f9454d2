#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <map>
#include <nlohmann/json.hpp>
#include <string_view>
#include <utility>

#include "hwffd/mesh/extension.hpp"
#include "mesh/assimp_export.hpp"
#include "mesh/gltf/uri.hpp"
#include "mesh/polygon.hpp"
#include "mesh/scene.hpp"
#include "mesh/utf8.hpp"

namespace hwffd {
namespace {

using Json = nlohmann::ordered_json;

// Numbers of the standard.
constexpr int kFloat = 5126;
constexpr int kUint = 5125;
constexpr int kVertices = 34962;
constexpr int kIndices = 34963;
enum Mode { kPoints = 0, kLines = 1, kTriangles = 4 };

/// The geometry of a file: nodes, meshes, and the buffer that they refer to. Assimp's exporter
/// would merge and renumber vertices.
class Geometry {
 public:
  explicit Geometry(const Output& output) : scene_(output.scene) {
    for (unsigned m = 0; m < scene_.mNumMeshes; ++m) add_part(*scene_.mMeshes[m]);
    add_node(*scene_.mRootNode);
    put_space(output.space);
  }

  /// Adds its lists to the file.
  void put_into(Json& file) const {
    file["scene"] = 0;
    file["scenes"] = {{{"nodes", {0}}}};
    file["nodes"] = nodes_;
    if (!meshes_.empty()) file["meshes"] = meshes_;
    file["accessors"] = accessors_;
    file["bufferViews"] = views_;
  }

  const std::string& buffer() const { return buffer_; }

 private:
  /// Lengths are in metres, and y points up, by definition (glTF 2.0, section 3.4). Matrices are
  /// written column by column.
  void put_space(const Space& space) {
    const double u = space.unit;
    Json& root = nodes_[0];
    if (space.up == 1 && u != 1) root["scale"] = {u, u, u};
    if (space.up == 0) root["matrix"] = {0, u, 0, 0, -u, 0, 0, 0, 0, 0, u, 0, 0, 0, 0, 1};
    if (space.up == 2) root["matrix"] = {u, 0, 0, 0, 0, 0, -u, 0, 0, u, 0, 0, 0, 0, 0, 1};
  }

  /// The number of an array; equal arrays are stored once.
  template <typename T>
  int accessor(const std::vector<T>& values, std::size_t components, int target) {
    const std::string_view bytes(reinterpret_cast<const char*>(values.data()),
                                 values.size() * sizeof(T));
    const auto key = std::make_pair(std::hash<std::string_view>{}(bytes), components);
    for (auto [at, end] = stored_.equal_range(key); at != end; ++at) {
      const Json& view = views_[at->second];
      const std::size_t offset = view["byteOffset"];
      if (view["target"] == target &&
          std::string_view(buffer_).substr(offset, view["byteLength"]) == bytes) {
        return static_cast<int>(at->second);
      }
    }
    const std::size_t number = accessors_.size();
    stored_.emplace(key, number);
    static const std::map<std::size_t, const char*> kTypes = {
        {1, "SCALAR"}, {2, "VEC2"}, {3, "VEC3"}, {4, "VEC4"}};
    accessors_.push_back({{"bufferView", number},
                          {"componentType", target == kIndices ? kUint : kFloat},
                          {"count", values.size() / components},
                          {"type", kTypes.at(components)}});
    views_.push_back({{"buffer", 0},
                      {"byteOffset", buffer_.size()},
                      {"byteLength", bytes.size()},
                      {"target", target}});
    buffer_.append(bytes);
    return static_cast<int>(number);
  }

  int positions_of(const aiMesh& part) {
    std::vector<float> values;
    std::vector<float> low(3, std::numeric_limits<float>::infinity());
    std::vector<float> high(3, -std::numeric_limits<float>::infinity());
    for (unsigned v = 0; v < part.mNumVertices; ++v) {
      for (unsigned axis = 0; axis < 3; ++axis) {
        values.push_back(part.mVertices[v][axis]);
        low[axis] = std::min(low[axis], values.back());
        high[axis] = std::max(high[axis], values.back());
      }
    }
    const int number = accessor(values, 3, kVertices);
    accessors_[static_cast<std::size_t>(number)]["min"] = low;
    accessors_[static_cast<std::size_t>(number)]["max"] = high;
    return number;
  }

  Json attributes_of(const aiMesh& part) {
    Json attributes{{"POSITION", positions_of(part)}};
    const auto add = [&](const std::string& name, std::size_t components, auto value_of) {
      std::vector<float> values;
      values.reserve(components * part.mNumVertices);
      for (unsigned v = 0; v < part.mNumVertices; ++v) {
        for (unsigned c = 0; c < components; ++c) values.push_back(value_of(v, c));
      }
      attributes[name] = accessor(values, components, kVertices);
    };
    if (part.HasNormals()) {
      add("NORMAL", 3, [&](unsigned v, unsigned c) { return part.mNormals[v][c]; });
    }
    for (unsigned t = 0; part.HasTextureCoords(t); ++t) {
      // The origin is the picture's upper corner.
      add(fmt::format("TEXCOORD_{}", t), 2, [&](unsigned v, unsigned c) {
        const float value = part.mTextureCoords[t][v][c];
        return c == 0 ? value : 1.0f - value;
      });
    }
    for (unsigned s = 0; part.HasVertexColors(s); ++s) {
      add(fmt::format("COLOR_{}", s), 4,
          [&](unsigned v, unsigned c) { return part.mColors[s][v][c]; });
    }
    return attributes;
  }

  static std::map<Mode, std::vector<std::uint32_t>> indices_of(const aiMesh& part) {
    std::map<Mode, std::vector<std::uint32_t>> indices;
    for (unsigned f = 0; f < part.mNumFaces; ++f) {
      const aiFace& face = part.mFaces[f];
      if (face.mNumIndices == 1) indices[kPoints].push_back(face.mIndices[0]);
      if (face.mNumIndices == 2) {
        indices[kLines].insert(indices[kLines].end(), face.mIndices, face.mIndices + 2);
      }
      if (face.mNumIndices < 3) continue;
      std::vector<std::uint32_t>& list = indices[kTriangles];
      for (const auto& triangle : triangles_of(part, face)) {
        list.insert(list.end(), triangle.begin(), triangle.end());
      }
    }
    if (indices.empty()) indices[kPoints];  // all vertices
    return indices;
  }

  void add_part(const aiMesh& part) {
    Json& primitives = primitives_.emplace_back(Json::array());
    if (part.mNumVertices == 0) return;
    const Json attributes = attributes_of(part);
    for (const auto& [mode, indices] : indices_of(part)) {
      Json primitive{{"attributes", attributes}, {"mode", static_cast<int>(mode)}};
      if (!indices.empty()) primitive["indices"] = accessor(indices, 1, kIndices);
      if (scene_.mNumMaterials > 0) primitive["material"] = part.mMaterialIndex;
      primitives.push_back(std::move(primitive));
    }
  }

  std::size_t add_node(const aiNode& node) {
    const std::size_t number = nodes_.size();
    Json& entry = nodes_.emplace_back(Json::object());
    if (node.mName.length > 0) entry["name"] = utf8_of(node.mName.C_Str());
    Json primitives = Json::array();
    for (unsigned i = 0; i < node.mNumMeshes; ++i) {
      const Json& list = primitives_[node.mMeshes[i]];
      primitives.insert(primitives.end(), list.begin(), list.end());
    }
    if (!primitives.empty()) {
      const aiString& name = scene_.mMeshes[node.mMeshes[0]]->mName;
      entry["mesh"] = meshes_.size();
      Json mesh{{"primitives", std::move(primitives)}};
      if (name.length > 0) mesh["name"] = utf8_of(name.C_Str());
      meshes_.push_back(std::move(mesh));
    }
    Json children = Json::array();
    for (unsigned c = 0; c < node.mNumChildren; ++c) {
      children.push_back(add_node(*node.mChildren[c]));
    }
    if (!children.empty()) nodes_[number]["children"] = std::move(children);
    return number;
  }

  const aiScene& scene_;
  std::vector<Json> primitives_;  ///< of each part
  Json nodes_ = Json::array();
  Json meshes_ = Json::array();
  Json accessors_ = Json::array();
  Json views_ = Json::array();
  std::multimap<std::pair<std::size_t, std::size_t>, std::size_t> stored_;
  std::string buffer_;
};

/// Names of files as URIs; Assimp's exporter takes them for such.
void encode_names(Json& images) {
  for (Json& image : images) {
    const std::string name = image.value("uri", "");
    if (!gltf::is_absolute_uri(name)) image["uri"] = gltf::percent_encoded(name);
  }
}

/// Says the opacity in both models of a material; Assimp's exporter does in one.
void spread_alpha(Json& materials) {
  const Json::json_pointer gloss("/extensions/KHR_materials_pbrSpecularGlossiness");
  const Json::json_pointer alpha("/pbrMetallicRoughness/baseColorFactor/3");
  for (Json& material : materials) {
    if (!material.contains(gloss) || !material.contains(alpha)) continue;
    Json& factor = material[gloss]["diffuseFactor"];
    if (factor.is_null()) factor = {1, 1, 1, 1};
    factor[3] = material[alpha];
  }
}

/// What Assimp's exporter makes of the materials.
Json materials_file(const Output& output) {
  const std::string name = "materials.gltf";
  const Files files = assimp_export(*materials_of(output, true), "gltf2", name);
  const Json all = Json::parse(files.at(name));
  Json file{{"asset", {{"version", "2.0"}, {"generator", "hwffd"}}}};
  for (const char* key :
       {"extensionsUsed", "extensionsRequired", "materials", "textures", "images", "samplers"}) {
    if (all.contains(key)) file[key] = all[key];
  }
  if (file.contains("images")) encode_names(file["images"]);
  if (file.contains("materials")) spread_alpha(file["materials"]);
  if (!file.contains("extensionsUsed")) return file;
  Json& extensions = file["extensionsUsed"];  // of which this one is about faces
  extensions.erase(std::remove(extensions.begin(), extensions.end(), "FB_ngon_encoding"),
                   extensions.end());
  if (extensions.empty()) file.erase("extensionsUsed");
  return file;
}

void append_word(std::string& bytes, std::size_t word) {
  for (int shift = 0; shift < 32; shift += 8) bytes += static_cast<char>(word >> shift & 0xff);
}

std::string binary_file(std::string text, const std::string& buffer) {
  constexpr std::size_t kHeader = 12;
  constexpr std::size_t kChunk = 8;
  text.resize((text.size() + 3) / 4 * 4, ' ');
  std::string bytes = "glTF";
  append_word(bytes, 2);
  append_word(bytes, kHeader + kChunk + text.size() + kChunk + buffer.size());
  append_word(bytes, text.size());
  bytes += "JSON" + text;
  append_word(bytes, buffer.size());
  return bytes + std::string("BIN\0", 4) + buffer;
}

}  // namespace

Files write_gltf(const Output& output) {
  const Geometry geometry(output);
  const std::string name = output.path.filename().string();
  Json file = materials_file(output);
  geometry.put_into(file);
  file["buffers"] = {{{"byteLength", geometry.buffer().size()}}};
  if (extension_of(output.path) == ".glb") {
    return {{name, binary_file(file.dump(), geometry.buffer())}};
  }
  const std::string buffer = output.path.stem().string() + ".bin";
  file["buffers"][0]["uri"] = gltf::percent_encoded(utf8_of(buffer));
  return {{name, file.dump(2) + "\n"}, {buffer, geometry.buffer()}};
}

}  // namespace hwffd
