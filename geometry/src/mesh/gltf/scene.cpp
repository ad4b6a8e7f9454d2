#include "mesh/gltf/scene.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>

#include "hwffd/error.hpp"
#include "mesh/read_scene.hpp"

namespace hwffd::gltf {
namespace {

constexpr unsigned kDeepestNode = 1000;  // of nodes; what walks over them recurses
/// Vertices and corners that a scene may show beside one for each byte that is read: meshes that
/// are shown many times.
constexpr std::size_t kMostRepeated = std::size_t{1} << 22;

using Key = std::vector<std::pair<std::string, std::size_t>>;  // attributes and their accessors

/// Column by column, or translation, rotation and scale (section 3.5.3).
Eigen::Affine3d transform_of(const JsonItem& node) {
  Eigen::Affine3d transform = Eigen::Affine3d::Identity();
  if (node.has("matrix")) {
    const std::vector<double> m = node.numbers("matrix", std::vector<double>(16, 0.0));
    transform.matrix() = Eigen::Map<const Eigen::Matrix4d>(m.data());
    transform.makeAffine();
    return transform;
  }
  const std::vector<double> t = node.numbers("translation", {0, 0, 0});
  const std::vector<double> r = node.numbers("rotation", {0, 0, 0, 1});
  const std::vector<double> s = node.numbers("scale", {1, 1, 1});
  transform.translation() = Eigen::Vector3d(t[0], t[1], t[2]);
  const bool is_turned = r[0] != 0 || r[1] != 0 || r[2] != 0;
  if (is_turned) {
    transform.linear() = Eigen::Quaterniond(r[3], r[0], r[1], r[2]).normalized().toRotationMatrix();
  }
  transform.linear() *= Eigen::Vector3d(s[0], s[1], s[2]).asDiagonal();
  return transform;
}

template <int N>
using Rows = Eigen::Matrix<float, Eigen::Dynamic, N, Eigen::RowMajor>;

class SceneReader {
 public:
  SceneReader(const File& file, Content& content)
      : file_(file),
        content_(content),
        nodes_(file.root().list("nodes", "node")),
        meshes_(file.root().list("meshes", "mesh")) {
    scene_.accessors = read_accessors(file);
    scene_.worlds.resize(nodes_.size(), Eigen::Affine3d::Identity());
    scene_.is_shown.resize(nodes_.size(), false);
    most_ = kMostRepeated + file.text().size();
    for (const Buffer& buffer : file.buffers()) most_ += buffer.bytes.size();
  }

  Scene read() {
    const std::vector<std::size_t> roots = roots_of_scene();
    if (roots.size() == 1) {
      visit(roots[0], 0, Eigen::Affine3d::Identity(), 0);
    } else {
      content_.nodes.push_back({"ROOT", 0, {}});
      for (const std::size_t root : roots) visit(root, 0, Eigen::Affine3d::Identity(), 1);
    }
    if (content_.positions.rows() == 0 && vertices_ == 0) {
      throw Error(fmt::format("holds no vertices; {}", kAcceptedMeshes));
    }
    fill();
    return std::move(scene_);
  }

 private:
  std::vector<std::size_t> roots_of_scene() const {
    const std::vector<JsonItem> scenes = file_.root().list("scenes", "scene");
    const std::size_t shown = file_.root().index("scene", scenes.size()).value_or(0);
    if (!scenes.empty()) return scenes[shown].indices("nodes", nodes_.size());
    std::vector<bool> is_child(nodes_.size(), false);
    for (const JsonItem& node : nodes_) {
      for (const std::size_t child : node.indices("children", nodes_.size())) {
        is_child[child] = true;
      }
    }
    std::vector<std::size_t> roots;
    for (std::size_t n = 0; n < nodes_.size(); ++n) {
      if (!is_child[n]) roots.push_back(n);
    }
    return roots;
  }

  void visit(std::size_t number, std::uint32_t parent, const Eigen::Affine3d& above,
             unsigned depth) {
    const JsonItem& node = nodes_[number];
    if (depth > kDeepestNode) {
      throw Error(fmt::format("nodes are nested over {} deep", kDeepestNode));
    }
    if (scene_.is_shown[number]) node.fail("stands twice in the tree of nodes");
    scene_.is_shown[number] = true;
    scene_.worlds[number] = above * transform_of(node);
    const auto own = static_cast<std::uint32_t>(content_.nodes.size());
    content_.nodes.push_back({node.text("name", ""), parent, {}});
    if (content_.nodes.back().name.empty()) {
      content_.nodes.back().name = fmt::format("nodes[{}]", number);
    }
    if (const auto mesh = node.index("mesh", meshes_.size())) add_mesh(number, *mesh, own);
    for (const std::size_t child : node.indices("children", nodes_.size())) {
      visit(child, own, scene_.worlds[number], depth + 1);
    }
  }

  void add_mesh(std::size_t node, std::size_t mesh, std::uint32_t own) {
    const std::vector<JsonItem> primitives =
        meshes_[mesh].list("primitives", meshes_[mesh].name() + ", primitive");
    std::string name = meshes_[mesh].text("name", "");
    if (name.empty()) name = fmt::format("meshes[{}]", mesh);
    std::map<Key, std::size_t> known;  // attributes -> part with these vertices
    for (std::size_t p = 0; p < primitives.size(); ++p) {
      const JsonItem& primitive = primitives[p];
      const JsonItem attributes = primitive.object("attributes");
      // "Client implementations SHOULD skip" it then (section 3.7.2.1).
      if (!attributes.has("POSITION")) continue;
      Part part = part_of(primitive, attributes);
      part.node = node;
      part.mesh = mesh;
      part.primitive = p;
      const auto [other, is_new] = known.emplace(key_of(attributes), scene_.parts.size());
      part.first_vertex = is_new ? vertices_ : scene_.parts[other->second].first_vertex;
      if (is_new) vertices_ += part.vertices;
      corners_ += part.indices ? scene_.accessors[*part.indices].count : part.vertices;
      if (vertices_ + corners_ > most_) {
        throw Error(fmt::format(
            "nodes show over {} vertices; split the file, which repeats its meshes", most_));
      }
      content_.nodes[own].parts.push_back(static_cast<std::uint32_t>(scene_.parts.size()));
      const std::string part_name = primitives.size() > 1 ? fmt::format("{}-{}", name, p) : name;
      content_.parts.push_back({part_name, material_of(primitive), 0, 0});
      is_first_.push_back(is_new);
      attributes_.push_back(is_new ? key_of(attributes) : Key());
      scene_.parts.push_back(part);
    }
  }

  /// Behind the file's own materials stands that of primitives that name none.
  std::uint32_t material_of(const JsonItem& primitive) const {
    const std::size_t own = content_.materials.size() - 1;
    return static_cast<std::uint32_t>(primitive.index("material", own).value_or(own));
  }

  std::optional<std::size_t> accessor_of(const JsonItem& attributes, const char* name,
                                         std::size_t components) const {
    const auto number = attributes.index(name, scene_.accessors.size());
    if (number && scene_.accessors[*number].components != components) {
      attributes.fail(fmt::format("{} is an accessor of {} components, not {}", name,
                                  scene_.accessors[*number].components, components));
    }
    return number;
  }

  Part part_of(const JsonItem& primitive, const JsonItem& attributes) const {
    Part part{};
    const std::size_t mode = primitive.whole("mode", static_cast<std::size_t>(Mode::kTriangles));
    if (mode > static_cast<std::size_t>(Mode::kTriangleFan)) {
      primitive.fail(fmt::format("has a mode that glTF does not know, {}", mode));
    }
    part.mode = static_cast<Mode>(mode);
    part.position = *accessor_of(attributes, "POSITION", 3);
    part.normal = accessor_of(attributes, "NORMAL", 3);
    part.tangent = accessor_of(attributes, "TANGENT", 4);
    part.indices = accessor_of(primitive, "indices", 1);
    part.vertices = scene_.accessors[part.position].count;
    return part;
  }

  /// All attributes; each has an element for each vertex (section 3.7.2.1).
  Key key_of(const JsonItem& attributes) const {
    Key key;
    const std::size_t vertices =
        scene_.accessors[*attributes.index("POSITION", scene_.accessors.size())].count;
    for (const auto& [name, value] : attributes.json().items()) {
      const std::size_t number = *attributes.index(name.c_str(), scene_.accessors.size());
      const std::size_t count = scene_.accessors[number].count;
      if (count != vertices) {
        attributes.fail(fmt::format("{} has {} elements for {} vertices", name, count, vertices));
      }
      key.emplace_back(name, number);
    }
    return key;
  }

  void fill();
  void fill_vertices(const Part& part, const Key& attributes);
  void fill_faces(const Part& part, ContentPart& content);
  std::vector<std::uint32_t> corners_of(const Part& part) const;
  template <int N>
  void fill_values(Rows<N>& rows, const Part& part, std::size_t accessor);

  const File& file_;
  Content& content_;
  std::vector<JsonItem> nodes_;
  std::vector<JsonItem> meshes_;
  Scene scene_;
  std::vector<bool> is_first_;   ///< of each part: whether its vertices are not those of another
  std::vector<Key> attributes_;  ///< of each such part
  std::size_t vertices_ = 0;
  std::size_t corners_ = 0;
  std::size_t most_ = 0;
};

/// A row of values for every vertex; those of vertices that have none are NaN.
template <int N>
void make_rows(Rows<N>& rows, std::size_t vertices) {
  if (rows.rows() == 0) {
    rows = Rows<N>::Constant(static_cast<Eigen::Index>(vertices), N,
                             std::numeric_limits<float>::quiet_NaN());
  }
}

/// "TEXCOORD_3" -> 3; nothing for another name.
std::optional<std::size_t> set_of(const std::string& name, const std::string& kind) {
  constexpr std::size_t kMostSets = 8;  // of aiMesh
  if (name.size() != kind.size() + 1 || name.compare(0, kind.size(), kind) != 0) return {};
  const std::size_t set = static_cast<std::size_t>(name.back() - '0');
  if (set >= kMostSets) return {};
  return set;
}

void SceneReader::fill() {
  content_.positions.resize(static_cast<Eigen::Index>(vertices_), 3);
  content_.corners.reserve(corners_);
  if (scene_.parts.size() > 1) content_.homes.resize(vertices_);
  bool all_triangles = true;
  for (std::size_t p = 0; p < scene_.parts.size(); ++p) {
    const Part& part = scene_.parts[p];
    if (is_first_[p]) {
      fill_vertices(part, attributes_[p]);
      const auto home = content_.homes.begin() + static_cast<std::ptrdiff_t>(part.first_vertex);
      if (!content_.homes.empty()) std::fill_n(home, part.vertices, static_cast<std::uint32_t>(p));
    }
    fill_faces(part, content_.parts[p]);
    all_triangles = all_triangles && part.mode >= Mode::kTriangles;
  }
  if (all_triangles) content_.face_ends.clear();
  content_.texture_sizes.resize(content_.textures.size(), 2);
}

template <int N>
void SceneReader::fill_values(Rows<N>& rows, const Part& part, std::size_t accessor) {
  make_rows(rows, vertices_);
  const std::vector<double> values = values_of(file_, scene_.accessors[accessor]);
  const std::size_t components = scene_.accessors[accessor].components;
  for (std::size_t v = 0; v < part.vertices; ++v) {
    for (std::size_t c = 0; c < std::size_t{N}; ++c) {
      const bool is_there = c < components;
      rows(static_cast<Eigen::Index>(part.first_vertex + v), static_cast<Eigen::Index>(c)) =
          is_there ? static_cast<float>(values[v * components + c])
          : c == 3 ? 1.0f
                   : 0.0f;
    }
  }
}

void SceneReader::fill_vertices(const Part& part, const Key& attributes) {
  const Eigen::Affine3d& world = scene_.worlds[part.node];
  const bool is_moved = world.matrix() != Eigen::Matrix4d::Identity();
  const Accessor& accessor = scene_.accessors[part.position];
  content_.is_single = content_.is_single && !is_moved && accessor.type == ComponentType::kFloat;
  const auto first = static_cast<Eigen::Index>(part.first_vertex);
  const auto count = static_cast<Eigen::Index>(part.vertices);
  const std::vector<double> values = values_of(file_, accessor);
  content_.positions.middleRows(first, count) = Eigen::Map<const Points>(values.data(), count, 3);
  for (Eigen::Index v = first; v < first + count && is_moved; ++v) {
    content_.positions.row(v) = (world * content_.positions.row(v).transpose()).transpose();
  }
  const Eigen::Matrix3d to_normals = world.linear().inverse().transpose();
  const float side = world.linear().determinant() < 0 ? -1.0f : 1.0f;
  const auto turned = [](const Eigen::Matrix3d& matrix, const Eigen::RowVector3f& value) {
    return Eigen::RowVector3f(
        (matrix * value.cast<double>().transpose()).normalized().transpose().cast<float>());
  };
  if (part.normal) {
    fill_values<3>(content_.normals.rows, part, *part.normal);
    for (Eigen::Index v = first; v < first + count && is_moved; ++v) {
      content_.normals.rows.row(v) = turned(to_normals, content_.normals.rows.row(v));
    }
  }
  if (part.tangent) {
    fill_values<4>(content_.tangents, part, *part.tangent);
    for (Eigen::Index v = first; v < first + count && is_moved; ++v) {
      auto row = content_.tangents.row(v);
      row.head<3>() = turned(world.linear(), row.head<3>());
      row[3] *= side;
    }
  }
  for (const auto& [name, number] : attributes) {
    if (const auto set = set_of(name, "TEXCOORD_")) {
      if (content_.textures.size() <= *set) content_.textures.resize(*set + 1);
      fill_values<3>(content_.textures[*set].rows, part, number);
      // The origin is the picture's upper corner (section 3.8.3).
      auto v = content_.textures[*set].rows.col(1).segment(first, count);
      v = 1.0f - v.array();
    }
    if (const auto set = set_of(name, "COLOR_")) {
      if (content_.colours.size() <= *set) content_.colours.resize(*set + 1);
      fill_values<4>(content_.colours[*set].rows, part, number);
    }
  }
}

std::vector<std::uint32_t> SceneReader::corners_of(const Part& part) const {
  std::vector<std::uint32_t> corners;
  if (part.indices) {
    corners = integers_of(file_, scene_.accessors[*part.indices]);
    for (std::size_t c = 0; c < corners.size(); ++c) {
      if (corners[c] < part.vertices) continue;
      throw Error(fmt::format(
          "corner {} of mesh {}, primitive {} refers to vertex {} of {}; repair the mesh", c,
          part.mesh, part.primitive, corners[c], part.vertices));
    }
  } else {
    corners.resize(part.vertices);
    for (std::size_t v = 0; v < corners.size(); ++v) corners[v] = static_cast<std::uint32_t>(v);
  }
  return corners;
}

/// Faces by section 3.7.2.1; corners at the end that make no whole face are left out.
void SceneReader::fill_faces(const Part& part, ContentPart& content) {
  const std::vector<std::uint32_t> corners = corners_of(part);
  const std::size_t n = corners.size();
  const bool is_mirrored = scene_.worlds[part.node].linear().determinant() < 0;
  content.first_face = content_.face_ends.size();
  const auto add = [&](std::initializer_list<std::size_t> face) {
    for (const std::size_t c : face) {
      content_.corners.push_back(static_cast<std::uint32_t>(part.first_vertex) + corners[c]);
    }
    content_.face_ends.push_back(content_.corners.size());
  };
  const auto triangle = [&](std::size_t a, std::size_t b, std::size_t c) {
    if (is_mirrored) {
      add({a, c, b});
    } else {
      add({a, b, c});
    }
  };
  switch (part.mode) {
    case Mode::kPoints:
      for (std::size_t i = 0; i < n; ++i) add({i});
      break;
    case Mode::kLines:
      for (std::size_t i = 0; i + 1 < n; i += 2) add({i, i + 1});
      break;
    case Mode::kLineLoop:
    case Mode::kLineStrip:
      for (std::size_t i = 0; i + 1 < n; ++i) add({i, i + 1});
      if (part.mode == Mode::kLineLoop && n > 1) add({n - 1, 0});
      break;
    case Mode::kTriangles:
      for (std::size_t i = 0; i + 2 < n; i += 3) triangle(i, i + 1, i + 2);
      break;
    case Mode::kTriangleStrip:
      for (std::size_t i = 0; i + 2 < n; ++i) triangle(i, i + 1 + i % 2, i + 2 - i % 2);
      break;
    case Mode::kTriangleFan:
      for (std::size_t i = 1; i + 1 < n; ++i) triangle(i, i + 1, 0);
      break;
  }
  content.faces = content_.face_ends.size() - content.first_face;
}

}  // namespace

Scene read_scene(const File& file, Content& content) { return SceneReader(file, content).read(); }

}  // namespace hwffd::gltf
