#include <fmt/format.h>

#include <algorithm>
#include <set>
#include <utility>

#include "hwffd/mesh/extension.hpp"
#include "mesh/format/document.hpp"
#include "mesh/gltf/edit.hpp"

namespace hwffd::gltf {
namespace {

/// What Content has no room for, of extensions that stand for themselves.
bool is_read(const std::string& extension) {
  return extension == "KHR_mesh_quantization" || extension == "KHR_lights_punctual" ||
         extension == "KHR_materials_pbrSpecularGlossiness";
}

void add(std::vector<std::string>& list, std::size_t count, const char* what) {
  if (count > 0) list.push_back(fmt::format("{} {}{}", count, what, count == 1 ? "" : "s"));
}

/// Whether a material says how its textures are to be taken: from other coordinates than the first,
/// or stronger or weaker.
bool has_texture_settings(const JsonItem& material) {
  const JsonItem surface = material.object("pbrMetallicRoughness");
  for (const auto& [item, key] :
       {std::pair(&surface, "baseColorTexture"), std::pair(&surface, "metallicRoughnessTexture"),
        std::pair(&material, "normalTexture"), std::pair(&material, "occlusionTexture"),
        std::pair(&material, "emissiveTexture")}) {
    const JsonItem texture = item->object(key);
    if (texture.number("texCoord", 0) != 0 || texture.number("scale", 1) != 1 ||
        texture.number("strength", 1) != 1) {
      return true;
    }
  }
  return false;
}

/// Fills the content's lists of what is not in it.
void list_extras(const File& file, const Scene& scene, Content& content) {
  std::vector<std::string>& extras = content.extras;
  const JsonItem& root = file.root();
  std::size_t bones = 0;
  for (const JsonItem& skin : root.list("skins", "skin")) {
    bones += skin.value("joints").size();
  }
  const std::vector<JsonItem> nodes = root.list("nodes", "node");
  std::set<std::size_t> skins;
  std::set<std::size_t> shown;
  for (const Part& part : scene.parts) {
    shown.insert(part.mesh);
    const auto skin = nodes[part.node].index("skin", root.value("skins").size());
    if (skin) skins.insert(*skin);
  }
  std::size_t targets = 0;
  std::set<std::string> attributes;
  const std::vector<JsonItem> meshes = root.list("meshes", "mesh");
  for (const std::size_t mesh : shown) {
    for (const JsonItem& primitive : meshes[mesh].list("primitives", "primitive")) {
      targets += primitive.list("targets", "target").size();
      for (const auto& [name, number] : primitive.object("attributes").json().items()) {
        if (name[0] == '_') attributes.insert(name);
      }
    }
  }
  add(content.unfollowed, skins.size(), "skin");
  add(content.unfollowed, targets, "morph target");
  add(extras, root.list("animations", "animation").size(), "animation");
  add(extras, bones, "bone");
  add(extras, targets, "morph target");
  add(extras, root.list("cameras", "camera").size(), "camera");
  add(extras,
      root.object("extensions").object("KHR_lights_punctual").list("lights", "light").size(),
      "light");
  if (content.tangents.rows() > 0) extras.emplace_back("tangents");
  const std::vector<JsonItem> materials = root.list("materials", "material");
  if (std::any_of(materials.begin(), materials.end(), has_texture_settings)) {
    extras.emplace_back("settings of textures");
  }
  for (const std::string& name : attributes) extras.push_back("attribute " + name);
  for (const std::string& name : root.texts("extensionsUsed")) {
    if (!is_read(name)) extras.push_back("extension " + name);
  }
  if (file.text().find("\"extras\"") != std::string::npos) extras.emplace_back("extras");
}

/// A .gltf or .glb file. Both are one format in two containers: each is edited into the other, too.
class Gltf : public Document {
 public:
  Gltf(const std::filesystem::path& path, const std::string& bytes) : file_(path, bytes) {
    read_materials(file_, content_);
    scene_ = read_scene(file_, content_);
    list_extras(file_, scene_, content_);
    companions_ = file_.companions();
    rest_ = {content_.positions, content_.normals.rows, content_.tangents};
  }

  bool is_of(const std::filesystem::path& path) const override {
    const std::string extension = extension_of(path);
    return extension == ".gltf" || extension == ".glb";
  }

  Files edited(const Edit& edit, const std::filesystem::path& path) const override {
    return edited_files(file_, scene_, rest_, edit, path);
  }

 private:
  File file_;
  Scene scene_;
  Rest rest_;
};

}  // namespace
}  // namespace hwffd::gltf

namespace hwffd {

std::unique_ptr<Document> read_gltf(const std::filesystem::path& path, std::string bytes) {
  return std::make_unique<gltf::Gltf>(path, bytes);
}

}  // namespace hwffd
