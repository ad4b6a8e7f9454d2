#include <assimp/material.h>
#include <fmt/format.h>

#include <algorithm>
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

/// A feature, how it is called, and the extensions of formats that do not hold it or whose writers
/// do not write it.
struct Loss {
  Feature feature;
  const char* text;
  const char* formats;
};

constexpr Loss kLosses[] = {
    {Feature::kNumbers, "order of vertices", ".stl"},
    {Feature::kNormals, "smooth normals", ".off .stl"},
    {Feature::kTextureCoordinates, "texture coordinates", ".off .stl"},
    {Feature::kMoreTextureCoordinates, "further texture coordinates", ".obj .ply"},
    {Feature::kColours, "colours", ".off .stl"},
    {Feature::kMoreColours, "further colours", ".obj .ply"},
    {Feature::kMaterials, "materials", ".ply .off .stl"},
    {Feature::kTexturesInside, "textures inside the file", ".obj .ply .off .stl"},
    {Feature::kNames, "part names", ".ply .off .stl"},
    {Feature::kEmptyNodes, "names of empty objects", ".obj .ply .off .stl"},
    {Feature::kPolygons, "polygons (cut into triangles)", ".stl .glb .gltf"},
    {Feature::kLines, "lines", ".stl"},
    {Feature::kPoints, "points", ".stl .dae"},
    {Feature::kLooseVertices, "unused vertices", ".stl"}};

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
  std::set<Feature> found = features_of(output.scene);
  if (is_numbered) found.insert(Feature::kNumbers);
  std::vector<std::string> losses;
  for (const auto& [feature, text, formats] : kLosses) {
    const bool is_repeated =
        feature == Feature::kNumbers && repeats_in_format(extension) && repeats_vertices(output);
    const bool is_held = (std::string(formats) + " ").find(extension + " ") == std::string::npos;
    if (found.count(feature) != 0 && (is_repeated || !is_held)) losses.emplace_back(text);
  }
  return losses;
}

}  // namespace hwffd
