#include <assimp/GltfMaterial.h>
#include <assimp/material.h>
#include <assimp/texture.h>
#include <fmt/format.h>

#include <algorithm>
#include <cstring>
#include <map>

#include "mesh/gltf/scene.hpp"
#include "mesh/gltf/uri.hpp"

namespace hwffd::gltf {
namespace {

constexpr double kShiniest = 1000;  // of materials that have no roughness

/// A picture inside the file, as Assimp has compressed ones: its bytes, and no height.
std::unique_ptr<aiTexture> picture_of(const std::string& name, const std::string& type,
                                      std::string_view bytes) {
  auto picture = std::make_unique<aiTexture>();
  picture->mFilename = name;
  const bool is_jpeg = type == "image/jpeg" || bytes.substr(0, 2) == "\xff\xd8";
  std::strcpy(picture->achFormatHint, is_jpeg ? "jpg" : "png");
  picture->mWidth = static_cast<unsigned>(bytes.size());
  picture->pcData = new aiTexel[bytes.size() / sizeof(aiTexel) + 1];
  std::memcpy(static_cast<void*>(picture->pcData), bytes.data(), bytes.size());
  return picture;
}

class MaterialReader {
 public:
  MaterialReader(const File& file, Content& content)
      : file_(file), textures_(file.root().list("textures", "texture")) {
    room_ = file.text().size();
    for (const Buffer& buffer : file.buffers()) room_ += buffer.bytes.size();
    const std::vector<JsonItem> views = file.root().list("bufferViews", "bufferView");
    for (const JsonItem& image : file.root().list("images", "image")) {
      std::string name = image.text("uri", "");
      std::optional<std::string> data = data_of(name);
      std::string_view bytes = data ? std::string_view(*data) : std::string_view();
      const auto view = image.index("bufferView", views.size());
      if (view) bytes = bytes_of(views[*view]);
      if (view || data) {
        // Views may overlap; so many bytes cannot be all different.
        if (bytes.size() > room_) image.fail("is one of pictures that are larger than the file");
        room_ -= bytes.size();
        const std::string type = image.text("mimeType", data ? name.substr(5, 10) : "");
        name = fmt::format("*{}", content.pictures.size());
        content.pictures.push_back(picture_of(image.text("name", ""), type, bytes));
      } else {
        name = percent_decoded(name);
      }
      images_.push_back(std::move(name));
    }
  }

  std::unique_ptr<aiMaterial> read(const JsonItem& item) const {
    auto material = std::make_unique<aiMaterial>();
    if (item.has("name")) {
      const aiString name(item.text("name", ""));
      material->AddProperty(&name, AI_MATKEY_NAME);
    }
    read_surface(item.object("pbrMetallicRoughness"), *material);
    const JsonItem extensions = item.object("extensions");
    if (extensions.has("KHR_materials_pbrSpecularGlossiness")) {
      read_gloss(extensions.object("KHR_materials_pbrSpecularGlossiness"), *material);
    }
    add_texture(item, "normalTexture", {aiTextureType_NORMALS}, *material);
    add_texture(item, "occlusionTexture", {aiTextureType_LIGHTMAP}, *material);
    add_texture(item, "emissiveTexture", {aiTextureType_EMISSIVE}, *material);
    add_colour(item.numbers("emissiveFactor", {0, 0, 0}), AI_MATKEY_COLOR_EMISSIVE, *material);
    const int is_two_sided = item.truth("doubleSided") ? 1 : 0;
    material->AddProperty(&is_two_sided, 1, AI_MATKEY_TWOSIDED);
    const aiString mode(item.text("alphaMode", "OPAQUE"));
    material->AddProperty(&mode, AI_MATKEY_GLTF_ALPHAMODE);
    add_number(item.number("alphaCutoff", 0.5), AI_MATKEY_GLTF_ALPHACUTOFF, *material);
    return material;
  }

 private:
  void read_surface(const JsonItem& surface, aiMaterial& material) const {
    const std::vector<double> colour = surface.numbers("baseColorFactor", {1, 1, 1, 1});
    add_colour(colour, AI_MATKEY_COLOR_DIFFUSE, material);
    add_colour(colour, AI_MATKEY_BASE_COLOR, material);
    // Once: who writes multiplies it by the alpha of colours.
    add_number(colour[3], AI_MATKEY_OPACITY, material);
    const double roughness = surface.number("roughnessFactor", 1);
    add_number(surface.number("metallicFactor", 1), AI_MATKEY_METALLIC_FACTOR, material);
    add_number(roughness, AI_MATKEY_ROUGHNESS_FACTOR, material);
    add_number((1 - roughness) * (1 - roughness) * kShiniest, AI_MATKEY_SHININESS, material);
    add_texture(surface, "baseColorTexture", {aiTextureType_DIFFUSE, aiTextureType_BASE_COLOR},
                material);
    add_texture(surface, "metallicRoughnessTexture",
                {aiTextureType_UNKNOWN, aiTextureType_METALNESS, aiTextureType_DIFFUSE_ROUGHNESS},
                material);
  }

  void read_gloss(const JsonItem& gloss, aiMaterial& material) const {
    const std::vector<double> colour = gloss.numbers("diffuseFactor", {1, 1, 1, 1});
    add_colour(colour, AI_MATKEY_COLOR_DIFFUSE, material);
    float opacity = 1;  // of the other model; some writers say it only there
    material.Get(AI_MATKEY_OPACITY, opacity);
    add_number(std::min(static_cast<double>(opacity), colour[3]), AI_MATKEY_OPACITY, material);
    add_colour(gloss.numbers("specularFactor", {1, 1, 1}), AI_MATKEY_COLOR_SPECULAR, material);
    const double glossiness = gloss.number("glossinessFactor", 1);
    add_number(glossiness * kShiniest, AI_MATKEY_SHININESS, material);
    add_number(glossiness, AI_MATKEY_GLOSSINESS_FACTOR, material);
    add_texture(gloss, "diffuseTexture", {aiTextureType_DIFFUSE}, material);
    add_texture(gloss, "specularGlossinessTexture", {aiTextureType_SPECULAR}, material);
  }

  std::string_view bytes_of(const JsonItem& view) const {
    if (!view.has("buffer")) view.fail("has no buffer");
    const std::string_view all =
        file_.buffers()[*view.index("buffer", file_.buffers().size())].bytes;
    const std::size_t begin = view.whole("byteOffset", 0);
    const std::size_t length = view.whole("byteLength");
    if (begin > all.size() || length > all.size() - begin) view.fail("ends behind its buffer");
    return all.substr(begin, length);
  }

  static void add_colour(const std::vector<double>& values, const char* key, unsigned semantic,
                         unsigned index, aiMaterial& material) {
    const aiColor4D colour(static_cast<float>(values[0]), static_cast<float>(values[1]),
                           static_cast<float>(values[2]), 1);
    material.AddProperty(&colour, 1, key, semantic, index);
  }

  static void add_number(double value, const char* key, unsigned semantic, unsigned index,
                         aiMaterial& material) {
    const auto number = static_cast<float>(value);
    material.AddProperty(&number, 1, key, semantic, index);
  }

  void add_texture(const JsonItem& item, const char* key,
                   std::initializer_list<aiTextureType> types, aiMaterial& material) const {
    if (!item.has(key)) return;
    const JsonItem reference = item.object(key);
    const auto texture = reference.index("index", textures_.size());
    if (!texture) return;
    const auto image = textures_[*texture].index("source", images_.size());
    if (!image || images_[*image].empty()) return;
    const aiString name(images_[*image]);
    const auto coordinates = static_cast<int>(
        std::min<std::size_t>(reference.whole("texCoord", 0), AI_MAX_NUMBER_OF_TEXTURECOORDS - 1));
    for (const aiTextureType type : types) {
      material.AddProperty(&name, AI_MATKEY_TEXTURE(type, 0));
      material.AddProperty(&coordinates, 1, AI_MATKEY_UVWSRC(type, 0));
    }
  }

  const File& file_;
  std::vector<JsonItem> textures_;
  std::size_t room_ = 0;
  std::vector<std::string> images_;  ///< file, or "*0" for the first picture inside
};

}  // namespace

void read_materials(const File& file, Content& content) {
  const MaterialReader reader(file, content);
  for (const JsonItem& item : file.root().list("materials", "material")) {
    content.materials.push_back(reader.read(item));
  }
  static const nlohmann::json kDefault = nlohmann::json::object();
  content.materials.push_back(reader.read({kDefault, "the default material"}));
}

}  // namespace hwffd::gltf
