#include "mesh/assimp_export.hpp"

#include <assimp/SceneCombiner.h>
#include <assimp/cexport.h>
#include <assimp/config.h>
#include <assimp/material.h>
#include <fmt/format.h>

#include <assimp/Exporter.hpp>
#include <cstring>

#include "hwffd/error.hpp"
#include "mesh/relocated.hpp"
#include "mesh/scene.hpp"
#include "mesh/utf8.hpp"

namespace hwffd {
namespace {

namespace fs = std::filesystem;

/// As aiString, which drops what does not fit, but cut, between two characters of UTF-8.
void set(aiString& text, std::string value) {
  std::size_t end = MAXLEN - 1;
  if (value.size() > end) {
    while (end > 0 && (static_cast<unsigned char>(value[end]) & 0xc0) == 0x80) --end;
    value.resize(end);
  }
  text.Set(value);
}

/// Takes alpha out of the colours of a material that has an opacity, too: it is one number, and
/// exporters multiply the two.
void take_alpha(aiMaterial& material) {
  float opacity = 1;
  if (material.Get(AI_MATKEY_OPACITY, opacity) != aiReturn_SUCCESS) return;
  const auto take = [&](const char* key, unsigned semantic, unsigned index) {
    aiColor4D colour;
    if (material.Get(key, semantic, index, colour) != aiReturn_SUCCESS || !(colour.a < 1)) return;
    colour.a = 1;
    material.AddProperty(&colour, 1, key, semantic, index);
  };
  take(AI_MATKEY_COLOR_DIFFUSE);
  take(AI_MATKEY_BASE_COLOR);
}

void adapt(aiMaterial& material, const Output& output, bool is_utf8) {
  take_alpha(material);
  // Without a name each exporter invents another.
  aiString name;
  material.Get(AI_MATKEY_NAME, name);
  if (name.length == 0) name = AI_DEFAULT_MATERIAL_NAME;
  material.AddProperty(&name, AI_MATKEY_NAME);
  struct Text {
    std::string key;
    unsigned semantic;
    unsigned index;
    aiString value;
  };
  std::vector<Text> texts;
  for (unsigned p = 0; p < material.mNumProperties; ++p) {
    const aiMaterialProperty& property = *material.mProperties[p];
    aiString value;
    if (property.mType != aiPTI_String) continue;
    if (material.Get(property.mKey.C_Str(), property.mSemantic, property.mIndex, value) !=
        aiReturn_SUCCESS) {
      continue;
    }
    const bool is_texture = std::strcmp(property.mKey.C_Str(), _AI_MATKEY_TEXTURE_BASE) == 0;
    std::string text(value.C_Str());
    if (is_texture) text = relocated(text, output.texture_folder, output.path);
    if (is_utf8) text = utf8_of(text);
    set(value, text);
    texts.push_back({property.mKey.C_Str(), property.mSemantic, property.mIndex, value});
  }
  for (const Text& text : texts) {
    material.AddProperty(&text.value, text.key.c_str(), text.semantic, text.index);
  }
}

void make_utf8(aiNode& node) {
  set(node.mName, utf8_of(node.mName.C_Str()));
  for (unsigned c = 0; c < node.mNumChildren; ++c) make_utf8(*node.mChildren[c]);
}

aiMesh* one_triangle() {
  auto* mesh = new aiMesh();
  mesh->mPrimitiveTypes = aiPrimitiveType_TRIANGLE;
  mesh->mNumVertices = 3;
  mesh->mVertices = new aiVector3D[3]{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  mesh->mNumFaces = 1;
  mesh->mFaces = new aiFace[1];
  mesh->mFaces[0].mNumIndices = 3;
  mesh->mFaces[0].mIndices = new unsigned[3]{0, 1, 2};
  return mesh;
}

template <typename T>
void copy_all(T**& items, unsigned& count, T* const* from, unsigned number) {
  items = new T* [number] {};
  for (; count < number; ++count) Assimp::SceneCombiner::Copy(&items[count], from[count]);
}

}  // namespace

Files assimp_export(const aiScene& scene, const std::string& exporter_name,
                    const std::string& name) {
  Assimp::Exporter exporter;
  Assimp::ExportProperties properties;
  properties.SetPropertyString(AI_CONFIG_EXPORT_BLOB_NAME, name);
  const aiExportDataBlob* blob = exporter.ExportToBlob(&scene, exporter_name, 0, &properties);
  if (blob == nullptr) {
    throw Error(
        fmt::format("cannot write the mesh ({}); try another format", exporter.GetErrorString()));
  }
  Files files;
  for (; blob != nullptr; blob = blob->next) {
    files[fs::path(blob->name.C_Str()).filename().string()] =
        std::string(static_cast<const char*>(blob->data), blob->size);
  }
  return files;
}

std::unique_ptr<aiScene> materials_of(const Output& output, bool is_utf8) {
  auto result = std::make_unique<aiScene>();
  result->mRootNode = new aiNode("root");
  result->mRootNode->mNumMeshes = 1;
  result->mRootNode->mMeshes = new unsigned[1]{0};
  result->mMeshes = new aiMesh* [1] { one_triangle() };
  result->mNumMeshes = 1;
  const aiScene& scene = output.scene;
  copy_all(result->mMaterials, result->mNumMaterials, scene.mMaterials, scene.mNumMaterials);
  copy_all(result->mTextures, result->mNumTextures, scene.mTextures, scene.mNumTextures);
  for (unsigned m = 0; m < result->mNumMaterials; ++m) {
    adapt(*result->mMaterials[m], output, is_utf8);
  }
  return result;
}

std::unique_ptr<aiScene> copy_of(const Output& output, bool is_utf8) {
  aiScene* copy = nullptr;
  Assimp::SceneCombiner::CopyScene(&copy, &output.scene);
  std::unique_ptr<aiScene> result(copy);
  for (unsigned m = 0; m < result->mNumMaterials; ++m) {
    adapt(*result->mMaterials[m], output, is_utf8);
  }
  if (!is_utf8) return result;
  make_utf8(*result->mRootNode);
  for (unsigned m = 0; m < result->mNumMeshes; ++m) {
    aiString& name = result->mMeshes[m]->mName;
    set(name, utf8_of(name.C_Str()));
  }
  return result;
}

}  // namespace hwffd
