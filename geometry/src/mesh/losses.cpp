#include <assimp/material.h>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <set>
#include <utility>

#include "hwffd/error.hpp"
#include "hwffd/mesh/mesh.hpp"
#include "mesh/format/mtl.hpp"
#include "mesh/scene.hpp"

// What a translation did not keep: what was read is compared with what was written, read again.

namespace hwffd {
namespace {

enum class Feature {
  kNormals,
  kTextureCoordinates,
  kMoreTextureCoordinates,  ///< than the first
  kColours,
  kAlpha,  ///< of the first colours, below 1
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

/// A feature, how it is called, and another one that holds the same.
struct Loss {
  Feature feature;
  const char* text;
  Feature also;
};

constexpr Loss kLosses[] = {
    {Feature::kNormals, "smooth normals", Feature::kNormals},
    {Feature::kTextureCoordinates, "texture coordinates", Feature::kTextureCoordinates},
    {Feature::kMoreTextureCoordinates, "further texture coordinates",
     Feature::kMoreTextureCoordinates},
    {Feature::kColours, "colours", Feature::kColours},
    {Feature::kAlpha, "alpha of colours", Feature::kAlpha},
    {Feature::kMoreColours, "further colours", Feature::kMoreColours},
    {Feature::kMaterials, "materials", Feature::kMaterials},
    {Feature::kTexturesInside, "textures inside the file", Feature::kTexturesInside},
    {Feature::kNames, "part names", Feature::kNames},
    {Feature::kEmptyNodes, "names of empty objects", Feature::kEmptyNodes},
    {Feature::kPolygons, "polygons (cut into triangles)", Feature::kPolygons},
    {Feature::kLines, "lines", Feature::kLines},
    {Feature::kPoints, "points", Feature::kLooseVertices},
    {Feature::kLooseVertices, "unused vertices", Feature::kPoints}};

bool is_flat(const aiMesh& part, const aiFace& face) {
  for (unsigned c = 1; c < face.mNumIndices; ++c) {
    if (part.mNormals[face.mIndices[c]] != part.mNormals[face.mIndices[0]]) return false;
  }
  return true;
}

bool has_alpha(const aiMesh& part) {
  constexpr float kOpaque = 254.5f / 255;  // what formats with a byte for it round to 1
  if (!part.HasVertexColors(0)) return false;
  return std::any_of(part.mColors[0], part.mColors[0] + part.mNumVertices,
                     [](const aiColor4D& colour) { return colour.a < kOpaque; });
}

void find_in_part(const aiMesh& part, std::set<Feature>& features) {
  std::vector<bool> used(part.mNumVertices, false);
  const auto add = [&](Feature feature, bool holds) {
    if (holds) features.insert(feature);
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
  add(Feature::kAlpha, has_alpha(part));
  add(Feature::kMoreColours, part.HasVertexColors(1));
}

void find_names(const aiNode& node, std::set<Feature>& features) {
  for (unsigned c = 0; c < node.mNumChildren; ++c) {
    const aiNode& child = *node.mChildren[c];
    const bool is_empty = child.mNumMeshes == 0 && child.mNumChildren == 0;
    // Assimp's reader of obj files gives this name where the file has none.
    const bool is_named = child.mName.length > 0 && child.mName != aiString("defaultobject");
    if (is_named) features.insert(is_empty ? Feature::kEmptyNodes : Feature::kNames);
    find_names(child, features);
  }
}

std::string name_of(const aiMaterial& material) {
  aiString name;
  material.Get(AI_MATKEY_NAME, name);
  return name == aiString(AI_DEFAULT_MATERIAL_NAME) ? "" : name.C_Str();
}

std::set<Feature> features_of(const aiScene& scene) {
  std::set<Feature> features;
  each_part(scene, [&](const aiMesh& part, std::size_t) { find_in_part(part, features); });
  find_names(*scene.mRootNode, features);
  for (unsigned m = 0; m < scene.mNumMaterials; ++m) {
    if (!name_of(*scene.mMaterials[m]).empty()) features.insert(Feature::kMaterials);
  }
  if (scene.mNumTextures > 0) features.insert(Feature::kTexturesInside);
  return features;
}

/// Whether a material of the one name may have been written as that of the other: where several
/// have a name, a writer puts a number behind it.
bool may_be(const std::string& written, const std::string& name) {
  if (written.compare(0, name.size(), name) != 0) return false;
  const std::string rest = written.substr(name.size());
  return rest.empty() || (rest.size() > 1 && (rest[0] == '_' || rest[0] == ' ') &&
                          rest.find_first_not_of("0123456789", 1) == rest.npos);
}

/// Statements of materials that parts use and that the other scene has not, by name, or otherwise.
void find_statements(const aiScene& read, const aiScene& written, std::set<std::string>& lost) {
  std::set<unsigned> used;
  each_part(read, [&](const aiMesh& part, std::size_t) {
    if (part.mMaterialIndex < read.mNumMaterials) used.insert(part.mMaterialIndex);
  });
  for (const unsigned m : used) {
    const aiMaterial& material = *read.mMaterials[m];
    const std::string name = name_of(material);
    if (name.empty()) continue;
    std::optional<std::vector<std::string>> fewest;
    for (unsigned w = 0; w < written.mNumMaterials; ++w) {
      const aiMaterial& other = *written.mMaterials[w];
      if (!may_be(name_of(other), name)) continue;
      std::vector<std::string> differences = mtl_differences(material, other);
      if (!fewest || differences.size() < fewest->size()) fewest = std::move(differences);
    }
    if (!fewest) continue;
    for (const std::string& statement : *fewest) {
      lost.insert("statement " + statement + " of materials");
    }
  }
}

/// Whether each vertex of a file stands where it stood.
bool same_order(const Mesh& read, const Mesh& written) {
  if (read.vertex_count_read() != written.vertex_count_read()) return false;
  Eigen::Matrix<float, Eigen::Dynamic, 3> places = Eigen::Matrix<float, Eigen::Dynamic, 3>::Zero(
      static_cast<Eigen::Index>(read.vertex_count_read()), 3);
  for (std::size_t v = 0; v < read.numbers().size(); ++v) {
    places.row(read.numbers()[v]) = read.positions().row(read.welded()[v]).cast<float>();
  }
  for (std::size_t v = 0; v < written.numbers().size(); ++v) {
    const Eigen::RowVector3f place = written.positions().row(written.welded()[v]).cast<float>();
    if (places.row(written.numbers()[v]) != place) return false;
  }
  return true;
}

/// Whether rounding to binary32 moves a vertex by more than a millionth of the mesh's size.
bool loses_digits(const Mesh& read, const Mesh& written) {
  const Points& points = read.positions();
  if (read.is_single() || !written.is_single() || points.rows() == 0) return false;
  const double size = (points.colwise().maxCoeff() - points.colwise().minCoeff()).maxCoeff();
  const Points rounded = points.cast<float>().cast<double>();
  return (points - rounded).cwiseAbs().maxCoeff() > 1e-6 * size;
}

}  // namespace

std::vector<std::string> Mesh::lost_in(const Mesh& written) const {
  std::vector<std::string> losses;
  if (is_numbered_ && !(written.is_numbered_ && same_order(*this, written))) {
    losses.emplace_back("order of vertices");
  }
  if (loses_digits(*this, written)) losses.emplace_back("digits of coordinates");
  const std::set<Feature> here = features_of(scene());
  const std::set<Feature> there = features_of(written.scene());
  for (const Loss& loss : kLosses) {
    const bool is_lost = here.count(loss.feature) != 0 && there.count(loss.feature) == 0 &&
                         there.count(loss.also) == 0;
    if (is_lost) losses.emplace_back(loss.text);
  }
  std::set<std::string> statements;
  find_statements(scene(), written.scene(), statements);
  losses.insert(losses.end(), statements.begin(), statements.end());
  return losses;
}

}  // namespace hwffd
