#include "mesh/format/scene_of.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

#include "mesh/scene.hpp"

namespace hwffd {
namespace {

/// Bits decide: equal values are one vertex, and so are two NaN.
template <int N>
bool same(const Values<N>& values, std::uint32_t a, std::uint32_t b) {
  if (a == b) return true;
  if (a == kNone || b == kNone) return false;
  for (int c = 0; c < N; ++c) {
    const float x = values.rows(a, c);
    const float y = values.rows(b, c);
    if (!(x == y && std::signbit(x) == std::signbit(y)) && !(std::isnan(x) && std::isnan(y))) {
      return false;
    }
  }
  return true;
}

/// A vertex of a part.
struct Wedge {
  std::uint32_t vertex;  ///< of the content
  std::size_t corner;    ///< that has its values, or kLoose
};

constexpr std::size_t kLoose = std::numeric_limits<std::size_t>::max();

/// The row of a wedge's value, or kNone.
template <int N>
std::uint32_t row_of(const Values<N>& values, const Wedge& wedge) {
  std::uint32_t row = kNone;
  if (values.empty()) return row;
  if (values.of_corner.empty()) row = wedge.vertex;
  if (!values.of_corner.empty() && wedge.corner != kLoose) row = values.of_corner[wedge.corner];
  return row == kNone || std::isnan(values.rows(row, 0)) ? kNone : row;
}

/// The vertices and faces of one part after the other.
class PartBuilder {
 public:
  PartBuilder(const Content& content, std::size_t vertices)
      : content_(content), last_(vertices, kNone) {}

  /// @param loose  vertices that no face uses
  void build(const ContentPart& part, const std::vector<std::uint32_t>& loose) {
    wedges_.clear();
    indices_.clear();
    before_.clear();
    for (std::size_t f = part.first_face; f < part.first_face + part.faces; ++f) {
      for (std::size_t c = content_.face_begin(f); c < content_.face_end(f); ++c) add(c);
    }
    for (const Wedge& wedge : wedges_) last_[wedge.vertex] = kNone;
    for (const std::uint32_t vertex : loose) wedges_.push_back({vertex, kLoose});
    sort();
  }

  const std::vector<Wedge>& wedges() const { return wedges_; }
  /// Of all corners of the part's faces.
  const std::vector<std::uint32_t>& indices() const { return indices_; }

 private:
  void add(std::size_t corner) {
    const Wedge wedge{content_.corners[corner], corner};
    std::uint32_t w = last_[wedge.vertex];
    unsigned searched = 0;
    while (w != kNone && searched < kMostSearched && !agree(wedges_[w], wedge)) {
      w = before_[w];
      ++searched;
    }
    if (w == kNone || searched == kMostSearched) {
      w = static_cast<std::uint32_t>(wedges_.size());
      wedges_.push_back(wedge);
      before_.push_back(last_[wedge.vertex]);
      last_[wedge.vertex] = w;
    }
    indices_.push_back(w);
  }

  bool agree(const Wedge& a, const Wedge& b) const {
    const auto equal = [&](const auto& set) { return same(set, row_of(set, a), row_of(set, b)); };
    return equal(content_.normals) &&
           std::all_of(content_.textures.begin(), content_.textures.end(), equal) &&
           std::all_of(content_.colours.begin(), content_.colours.end(), equal);
  }

  void sort() {
    std::vector<std::uint32_t> order(wedges_.size());
    std::iota(order.begin(), order.end(), 0u);
    std::stable_sort(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) {
      return wedges_[a].vertex < wedges_[b].vertex;
    });
    std::vector<std::uint32_t> place(order.size());
    std::vector<Wedge> sorted(order.size());
    for (std::uint32_t i = 0; i < order.size(); ++i) {
      place[order[i]] = i;
      sorted[i] = wedges_[order[i]];
    }
    wedges_ = std::move(sorted);
    for (std::uint32_t& index : indices_) index = place[index];
  }

  static constexpr unsigned kMostSearched = 256;  // of one vertex: a hostile file has any number

  const Content& content_;
  std::vector<Wedge> wedges_;
  std::vector<std::uint32_t> indices_;
  std::vector<std::uint32_t> last_;    ///< vertex -> the wedge of it that was made last
  std::vector<std::uint32_t> before_;  ///< wedge -> the one of its vertex made before it
};

/// The values of a part's vertices; null if none has one.
template <int N, typename T>
T* list_of(const Values<N>& values, const std::vector<Wedge>& wedges, const T& without) {
  const bool some = std::any_of(wedges.begin(), wedges.end(),
                                [&](const Wedge& w) { return row_of(values, w) != kNone; });
  if (!some) return nullptr;
  T* const list = new T[wedges.size()];
  for (std::size_t v = 0; v < wedges.size(); ++v) {
    const std::uint32_t row = row_of(values, wedges[v]);
    list[v] = without;
    for (unsigned c = 0; row != kNone && c < N; ++c) list[v][c] = values.rows(row, c);
  }
  return list;
}

unsigned type_of(unsigned corners) {
  switch (corners) {
    case 1:
      return aiPrimitiveType_POINT;
    case 2:
      return aiPrimitiveType_LINE;
    case 3:
      return aiPrimitiveType_TRIANGLE;
    default:
      return aiPrimitiveType_POLYGON;
  }
}

void add_faces(const Content& content, const ContentPart& part,
               const std::vector<std::uint32_t>& indices, aiMesh& mesh) {
  mesh.mNumFaces = static_cast<unsigned>(part.faces);
  mesh.mFaces = new aiFace[part.faces];
  std::size_t next = 0;
  for (std::size_t f = 0; f < part.faces; ++f) {
    aiFace& face = mesh.mFaces[f];
    const std::size_t number = part.first_face + f;
    face.mNumIndices = static_cast<unsigned>(content.face_end(number) - content.face_begin(number));
    face.mIndices = new unsigned[face.mNumIndices];
    std::copy_n(indices.begin() + static_cast<std::ptrdiff_t>(next), face.mNumIndices,
                face.mIndices);
    next += face.mNumIndices;
    mesh.mPrimitiveTypes |= type_of(face.mNumIndices);
  }
  if (part.faces == 0) mesh.mPrimitiveTypes = aiPrimitiveType_POINT;
}

aiMesh* mesh_of(const Content& content, const ContentPart& part, const PartBuilder& built,
                const std::function<Eigen::RowVector3d(std::uint32_t)>& position) {
  const std::vector<Wedge>& wedges = built.wedges();
  auto* mesh = new aiMesh();
  mesh->mName = part.name;
  mesh->mMaterialIndex = part.material;
  mesh->mNumVertices = static_cast<unsigned>(wedges.size());
  mesh->mVertices = new aiVector3D[wedges.size()];
  for (std::size_t v = 0; v < wedges.size(); ++v) {
    const Eigen::RowVector3f p = position(wedges[v].vertex).cast<float>();
    mesh->mVertices[v] = aiVector3D(p.x(), p.y(), p.z());
  }
  mesh->mNormals = list_of(content.normals, wedges, aiVector3D(0, 1, 0));
  const std::size_t textures =
      std::min<std::size_t>(content.textures.size(), AI_MAX_NUMBER_OF_TEXTURECOORDS);
  unsigned sets = 0;
  for (std::size_t s = 0; s < textures; ++s) {
    mesh->mTextureCoords[sets] = list_of(content.textures[s], wedges, aiVector3D());
    if (mesh->mTextureCoords[sets] != nullptr) {
      mesh->mNumUVComponents[sets++] = content.texture_sizes[s];
    }
  }
  const std::size_t colours =
      std::min<std::size_t>(content.colours.size(), AI_MAX_NUMBER_OF_COLOR_SETS);
  sets = 0;
  for (std::size_t s = 0; s < colours; ++s) {
    mesh->mColors[sets] = list_of(content.colours[s], wedges, aiColor4D(1, 1, 1, 1));
    if (mesh->mColors[sets] != nullptr) ++sets;
  }
  add_faces(content, part, built.indices(), *mesh);
  return mesh;
}

void add_nodes(const Content& content, aiScene& scene) {
  std::vector<aiNode*> nodes;
  std::vector<std::vector<aiNode*>> children(content.nodes.size());
  for (const ContentNode& node : content.nodes) {
    auto* ai_node = new aiNode(node.name);
    ai_node->mNumMeshes = static_cast<unsigned>(node.parts.size());
    if (!node.parts.empty()) ai_node->mMeshes = new unsigned[node.parts.size()];
    std::copy(node.parts.begin(), node.parts.end(), ai_node->mMeshes);
    if (!nodes.empty()) {
      ai_node->mParent = nodes[node.parent];
      children[node.parent].push_back(ai_node);
    }
    nodes.push_back(ai_node);
  }
  for (std::size_t n = 0; n < nodes.size(); ++n) {
    if (children[n].empty()) continue;
    nodes[n]->mNumChildren = static_cast<unsigned>(children[n].size());
    nodes[n]->mChildren = new aiNode*[children[n].size()];
    std::copy(children[n].begin(), children[n].end(), nodes[n]->mChildren);
  }
  scene.mRootNode = nodes.front();
}

/// Of each part the vertices that no face uses.
std::vector<std::vector<std::uint32_t>> loose_of(const Content& content, std::size_t vertices) {
  std::vector<bool> used(vertices, false);
  for (const std::uint32_t vertex : content.corners) used[vertex] = true;
  std::vector<std::vector<std::uint32_t>> loose(content.parts.size());
  for (std::uint32_t vertex = 0; vertex < used.size(); ++vertex) {
    if (!used[vertex]) loose[content.homes.empty() ? 0 : content.homes[vertex]].push_back(vertex);
  }
  return loose;
}

template <typename T>
void give(std::vector<std::unique_ptr<T>>& items, T**& list, unsigned& count) {
  count = static_cast<unsigned>(items.size());
  list = new T* [items.size()] {};
  for (std::size_t i = 0; i < items.size(); ++i) list[i] = items[i].release();
  items.clear();
}

}  // namespace

ContentScene scene_of(Content& content, std::size_t vertices,
                      const std::function<Eigen::RowVector3d(std::uint32_t)>& position) {
  ContentScene result;
  result.scene = std::make_unique<aiScene>();
  aiScene& scene = *result.scene;
  const std::vector<std::vector<std::uint32_t>> loose = loose_of(content, vertices);
  scene.mMeshes = new aiMesh* [content.parts.size()] {};
  PartBuilder builder(content, vertices);
  for (std::size_t p = 0; p < content.parts.size(); ++p) {
    builder.build(content.parts[p], loose[p]);
    scene.mMeshes[scene.mNumMeshes++] = mesh_of(content, content.parts[p], builder, position);
    for (const Wedge& wedge : builder.wedges()) {
      result.vertices.push_back(wedge.vertex);
      result.normals.push_back(row_of(content.normals, wedge));
    }
  }
  add_nodes(content, scene);
  give(content.materials, scene.mMaterials, scene.mNumMaterials);
  give(content.pictures, scene.mTextures, scene.mNumTextures);
  return result;
}

}  // namespace hwffd
