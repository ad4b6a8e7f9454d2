#include <assimp/material.h>
#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <set>

#include "hwffd/mesh/extension.hpp"
#include "mesh/mesh_writers.hpp"
#include "mesh/scene.hpp"

namespace hwffd {
namespace {

enum class Feature {
  kNumbers,  ///< order and number of the vertices read
  kNormals,
  kTextureCoordinates,
  kMoreTextureCoordinates,  ///< than the first
  kColours,
  kMoreColours,
  kMaterials,
  kTexturesInside,
  kNames,
  kEmptyNodes,
  kPolygons,
  kLines,
  kPoints,
  kLooseVertices,
};

const char* text_of(Feature feature) {
  static const std::map<Feature, const char*> kTexts = {
      {Feature::kNumbers, "order of vertices"},
      {Feature::kNormals, "smooth normals"},
      {Feature::kTextureCoordinates, "texture coordinates"},
      {Feature::kMoreTextureCoordinates, "further texture coordinates"},
      {Feature::kColours, "colours"},
      {Feature::kMoreColours, "further colours"},
      {Feature::kMaterials, "materials"},
      {Feature::kTexturesInside, "textures inside the file"},
      {Feature::kNames, "part names"},
      {Feature::kEmptyNodes, "names of empty objects"},
      {Feature::kPolygons, "polygons (cut into triangles)"},
      {Feature::kLines, "lines"},
      {Feature::kPoints, "points"},
      {Feature::kLooseVertices, "unused vertices"}};
  return kTexts.at(feature);
}

/// What each format does not hold, or its writer does not write.
const std::set<Feature>& not_held_by(const std::string& extension) {
  using F = Feature;
  static const std::set<F> kGltf{F::kPolygons};
  static const std::map<std::string, std::set<F>> kNotHeld = {
      {".obj", {F::kMoreTextureCoordinates, F::kMoreColours, F::kTexturesInside, F::kEmptyNodes}},
      {".ply",
       {F::kMoreTextureCoordinates, F::kMoreColours, F::kMaterials, F::kTexturesInside, F::kNames,
        F::kEmptyNodes}},
      {".off",
       {F::kNormals, F::kTextureCoordinates, F::kColours, F::kMaterials, F::kTexturesInside,
        F::kNames, F::kEmptyNodes}},
      {".stl",
       {F::kNumbers, F::kNormals, F::kTextureCoordinates, F::kColours, F::kMaterials,
        F::kTexturesInside, F::kNames, F::kEmptyNodes, F::kPolygons, F::kLines, F::kPoints,
        F::kLooseVertices}},
      {".glb", kGltf},
      {".gltf", kGltf},
      {".dae", {F::kPoints}}};
  return kNotHeld.at(extension);
}

/// One normal or texture coordinate a vertex.
bool repeats_in_format(const std::string& extension) {
  return extension == ".ply" || extension == ".glb" || extension == ".gltf" || extension == ".dae";
}

bool is_flat(const aiMesh& part, const aiFace& face) {
  for (unsigned c = 1; c < face.mNumIndices; ++c) {
    if (part.mNormals[face.mIndices[c]] != part.mNormals[face.mIndices[0]]) return false;
  }
  return true;
}

void find_in_part(const aiMesh& part, std::set<Feature>& found) {
  std::vector<bool> used(part.mNumVertices, false);
  const auto add = [&](Feature feature, bool holds) {
    if (holds) found.insert(feature);
  };
  for (unsigned f = 0; f < part.mNumFaces; ++f) {
    const aiFace& face = part.mFaces[f];
    for (unsigned c = 0; c < face.mNumIndices; ++c) used[face.mIndices[c]] = true;
    add(Feature::kPolygons, face.mNumIndices > 3);
    add(Feature::kLines, face.mNumIndices == 2);
    add(Feature::kPoints, face.mNumIndices == 1);
    add(Feature::kNormals, part.HasNormals() && !is_flat(part, face));
  }
  add(Feature::kPoints, part.mNumFaces == 0);
  add(Feature::kLooseVertices,
      part.mNumFaces > 0 && std::find(used.begin(), used.end(), false) != used.end());
  add(Feature::kTextureCoordinates, part.HasTextureCoords(0));
  add(Feature::kMoreTextureCoordinates, part.HasTextureCoords(1));
  add(Feature::kColours, part.HasVertexColors(0));
  add(Feature::kMoreColours, part.HasVertexColors(1));
}

void find_names(const aiNode& node, std::set<Feature>& found) {
  for (unsigned c = 0; c < node.mNumChildren; ++c) {
    const aiNode& child = *node.mChildren[c];
    const bool is_empty = child.mNumMeshes == 0 && child.mNumChildren == 0;
    // Assimp's reader of obj files gives this name where the file has none.
    const bool is_named = child.mName.length > 0 && child.mName != aiString("defaultobject");
    if (is_named) found.insert(is_empty ? Feature::kEmptyNodes : Feature::kNames);
    find_names(child, found);
  }
}

std::set<Feature> features_of(const aiScene& scene) {
  std::set<Feature> found;
  each_part(scene, [&](const aiMesh& part, std::size_t) { find_in_part(part, found); });
  find_names(*scene.mRootNode, found);
  for (unsigned m = 0; m < scene.mNumMaterials; ++m) {
    aiString name;
    scene.mMaterials[m]->Get(AI_MATKEY_NAME, name);
    if (name.length > 0 && name != aiString(AI_DEFAULT_MATERIAL_NAME)) {
      found.insert(Feature::kMaterials);
    }
  }
  if (scene.mNumTextures > 0) found.insert(Feature::kTexturesInside);
  return found;
}

}  // namespace

std::vector<std::string> losses_of(const Output& output, bool is_numbered) {
  const std::string extension = extension_of(output.path);
  const std::set<Feature>& not_held = not_held_by(extension);
  std::set<Feature> found = features_of(output.scene);
  if (is_numbered) found.insert(Feature::kNumbers);
  std::vector<std::string> losses;
  for (const Feature feature : found) {
    const bool is_repeated =
        feature == Feature::kNumbers && repeats_in_format(extension) && repeats_vertices(output);
    if (is_repeated || not_held.count(feature) != 0) losses.emplace_back(text_of(feature));
  }
  return losses;
}

}  // namespace hwffd
