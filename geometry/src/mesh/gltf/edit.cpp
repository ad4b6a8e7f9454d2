#include "mesh/gltf/edit.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

#include "hwffd/error.hpp"
#include "mesh/gltf/accessor_edit.hpp"

namespace hwffd::gltf {
namespace {

using Json = nlohmann::json;

constexpr double kRounding = 0x1p-44;  // of the largest coordinate, on its way through a lattice

/// What a primitive refers to: attribute, or "indices", -> accessor.
using References = std::map<std::string, std::size_t>;
/// Of the primitives of a mesh that a node shows, by number.
using MeshReferences = std::map<std::size_t, References>;

/// Puts them into the text of a mesh.
void put_references(JsonText& json, JsonText::Span mesh, const MeshReferences& all) {
  const std::vector<JsonText::Span> primitives = json.items(json.members(mesh).at("primitives"));
  for (const auto& [p, references] : all) {
    const JsonText::Members members = json.members(primitives[p]);
    const JsonText::Members attributes = json.members(members.at("attributes"));
    for (const auto& [name, number] : references) {
      const JsonText::Members& where = name == "indices" ? members : attributes;
      const auto there = where.find(name);
      const std::string text = std::to_string(number);
      if (there == where.end()) {
        json.add_member(primitives[p], name, text);
      } else if (Json::parse(json.at(there->second)) != number) {
        json.replace(there->second, text);
      }
    }
  }
}

/// The same triangles seen from the other side; the first corner of each stays first, but in a
/// strip.
std::vector<std::uint32_t> turned(std::vector<std::uint32_t> corners, Mode mode) {
  const auto begin = corners.begin();
  switch (mode) {
    case Mode::kTriangles:
      for (std::size_t i = 0; i + 2 < corners.size(); i += 3)
        std::swap(corners[i + 1], corners[i + 2]);
      break;
    case Mode::kTriangleFan:
      if (!corners.empty()) std::reverse(begin + 1, corners.end());
      break;
    case Mode::kTriangleStrip:
      // Backwards, an odd strip has all sides changed. An even one has not, but with one more
      // corner in front, which makes a triangle without area.
      if (corners.size() % 2 == 1) {
        std::reverse(begin, corners.end());
      } else if (!corners.empty()) {
        corners.insert(begin, corners.front());
      }
      break;
    default:
      break;
  }
  return corners;
}

class Editor {
 public:
  Editor(const File& file, const Scene& scene, const Rest& rest, const Edit& edit)
      : file_(file),
        scene_(scene),
        rest_(rest),
        edit_(edit),
        noise_(kRounding * rest.positions.cwiseAbs().maxCoeff()),
        json_(file.text()),
        accessors_(file, scene.accessors),
        meshes_(json_.items(json_.members(json_.root())["meshes"])),
        nodes_(json_.items(json_.members(json_.root())["nodes"])),
        claims_(meshes_.size()) {}

  Files files(const std::filesystem::path& path) {
    hold_what_stays();
    for (std::size_t p = 0; p < scene_.parts.size();) {
      const std::size_t node = scene_.parts[p].node;
      const std::size_t mesh = scene_.parts[p].mesh;
      MeshReferences references;
      for (; p < scene_.parts.size() && scene_.parts[p].node == node; ++p) {
        references[scene_.parts[p].primitive] = references_of(scene_.parts[p]);
      }
      claim(node, mesh, references);
    }
    accessors_.put_into(json_);
    if (!new_meshes_.empty()) {
      json_.add_items(json_.members(json_.root())["meshes"], new_meshes_);
    }
    return file_.packed(std::move(json_), accessors_.buffers(), path);
  }

 private:
  /// A use of a mesh: what its primitives refer to, and its number.
  struct Claim {
    MeshReferences references;
    std::size_t mesh;
  };

  /// Accessors that are used for anything but places and directions of what the scene shows, and
  /// meshes that nodes outside of the scene show.
  void hold_what_stays() {
    const std::size_t count = scene_.accessors.size();
    const std::vector<JsonItem> meshes = file_.root().list("meshes", "mesh");
    const std::vector<JsonItem> nodes = file_.root().list("nodes", "node");
    std::vector<bool> is_elsewhere(meshes.size(), false);
    std::vector<bool> is_shown(meshes.size(), false);
    for (std::size_t n = 0; n < nodes.size(); ++n) {
      const auto mesh = nodes[n].index("mesh", meshes.size());
      if (mesh) (scene_.is_shown[n] ? is_shown : is_elsewhere)[*mesh] = true;
    }
    for (std::size_t m = 0; m < meshes.size(); ++m) {
      for (const JsonItem& primitive : meshes[m].list("primitives", "primitive")) {
        hold_of_primitive(primitive, is_elsewhere[m] || !is_shown[m]);
      }
      if (is_elsewhere[m]) claims_[m].push_back({original(m), m});
    }
    for (const JsonItem& animation : file_.root().list("animations", "animation")) {
      for (const JsonItem& sampler : animation.list("samplers", "sampler")) {
        for (const char* use : {"input", "output"}) hold(sampler.index(use, count));
      }
    }
    for (const JsonItem& skin : file_.root().list("skins", "skin")) {
      hold(skin.index("inverseBindMatrices", count));
    }
  }

  void hold(std::optional<std::size_t> accessor) {
    if (accessor) accessors_.hold(*accessor);
  }

  void hold_of_primitive(const JsonItem& primitive, bool all) {
    const std::size_t count = scene_.accessors.size();
    const auto hold_all = [&](const JsonItem& attributes, bool moving) {
      for (const auto& [name, number] : attributes.json().items()) {
        const bool moves = name == "POSITION" || name == "NORMAL" || name == "TANGENT";
        if (moving || !moves) hold(attributes.index(name.c_str(), count));
      }
    };
    hold_all(primitive.object("attributes"), all);
    if (all) hold(primitive.index("indices", count));
    for (const JsonItem& target : primitive.list("targets", "target")) hold_all(target, true);
  }

  /// What the primitives of a mesh refer to in the file, as references_of() would say.
  MeshReferences original(std::size_t mesh) const {
    MeshReferences all;
    for (const Part& part : scene_.parts) {
      if (part.mesh != mesh) continue;
      References& references = all[part.primitive];
      references["POSITION"] = part.position;
      if (part.normal) references["NORMAL"] = *part.normal;
      if (part.tangent) references["TANGENT"] = *part.tangent;
      if (part.indices) references["indices"] = *part.indices;
    }
    return all;
  }

  References references_of(const Part& part) {
    References references;
    references["POSITION"] = accessors_.with(part.position, positions_of(part));
    if (part.normal) references["NORMAL"] = accessors_.with(*part.normal, normals_of(part));
    if (part.tangent) references["TANGENT"] = accessors_.with(*part.tangent, tangents_of(part));
    const bool turns = edit_.turned && part.mode >= Mode::kTriangles;
    if (part.indices) {
      references["indices"] = turns ? turned_indices(part) : accessors_.with(*part.indices, {});
    } else if (turns) {
      std::vector<std::uint32_t> corners(part.vertices);
      for (std::size_t v = 0; v < corners.size(); ++v) corners[v] = static_cast<std::uint32_t>(v);
      references["indices"] =
          accessors_.indices(turned(std::move(corners), part.mode), part.position);
    }
    return references;
  }

  std::size_t turned_indices(const Part& part) {
    const Accessor& accessor = scene_.accessors[*part.indices];
    const std::vector<std::uint32_t> corners = turned(integers_of(file_, accessor), part.mode);
    if (corners.size() != accessor.count) return accessors_.indices(corners, *part.indices);
    std::string elements;
    for (const std::uint32_t corner : corners) elements += encoded(corner, accessor);
    return accessors_.with(*part.indices, std::move(elements));
  }

  /// The elements of an accessor with those replaced that have changed.
  /// @param changed  vertex of the part -> its new numbers, or nothing
  template <typename F>
  Elements elements_of(const Part& part, std::size_t number, const char* what, F changed) {
    const Accessor& accessor = scene_.accessors[number];
    Elements elements;
    for (std::size_t v = 0; v < part.vertices; ++v) {
      const auto values = changed(static_cast<Eigen::Index>(part.first_vertex + v));
      if (!values) continue;
      if (!elements) elements = accessors_.elements_of(number);
      std::string bytes;
      for (const double value : *values) {
        const std::string component = encoded(value, accessor);
        if (component.empty()) {
          throw Error(fmt::format(
              "vertex {} of mesh {}, primitive {}: its {} {} does not fit the numbers of accessor "
              "{}; write another format, such as ply",
              v, part.mesh, part.primitive, what, value, number));
        }
        bytes += component;
      }
      elements->replace(v * accessor.size, bytes.size(), bytes);
    }
    // A number may have changed by less than its type can tell.
    if (elements && *elements == accessors_.elements_of(number)) return std::nullopt;
    return elements;
  }

  /// What is stored and the way that the vertex has gone, seen from the node: the place in the
  /// world may be far from it, and would leave its rounding in every number.
  Elements positions_of(const Part& part) {
    const Eigen::Affine3d& world = scene_.worlds[part.node];
    const bool is_placed = world.matrix() != Eigen::Matrix4d::Identity();
    const Eigen::Matrix3d back = world.linear().inverse();
    // A node that has no size cannot show what has moved.
    if (!back.allFinite()) return std::nullopt;
    const Eigen::Vector3d noise = noise_ * back.cwiseAbs().rowwise().sum();
    std::vector<double> stored;
    const auto changed = [&](Eigen::Index v) -> std::optional<std::array<double, 3>> {
      const Eigen::RowVector3d place = edit_.position(static_cast<std::size_t>(v));
      const Eigen::Vector3d way = back * (place - rest_.positions.row(v)).transpose();
      if ((way.cwiseAbs().array() <= noise.array()).all()) return std::nullopt;
      if (stored.empty()) stored = values_of(file_, scene_.accessors[part.position]);
      std::array<double, 3> own{};
      for (Eigen::Index c = 0; c < 3; ++c) {
        double& number = own[static_cast<std::size_t>(c)];
        number = stored[3 * (static_cast<std::size_t>(v) - part.first_vertex) +
                        static_cast<std::size_t>(c)];
        if (std::abs(way[c]) > noise[c]) number = is_placed ? number + way[c] : place[c];
      }
      return own;
    };
    return elements_of(part, part.position, "coordinate", changed);
  }

  Elements normals_of(const Part& part) {
    const Eigen::Matrix3d back = scene_.worlds[part.node].linear().transpose();
    const auto changed = [&](Eigen::Index v) -> std::optional<std::array<double, 3>> {
      const Eigen::RowVector3f normal = edit_.normals.rows.row(v);
      const Eigen::Vector3d own = (back * normal.transpose().cast<double>()).normalized();
      if (normal == rest_.normals.row(v) || !own.allFinite()) return std::nullopt;
      return std::array<double, 3>{own.x(), own.y(), own.z()};
    };
    return elements_of(part, *part.normal, "normal", changed);
  }

  Elements tangents_of(const Part& part) {
    const Eigen::Matrix3d linear = scene_.worlds[part.node].linear();
    const Eigen::Matrix3d back = linear.inverse();
    const double side = linear.determinant() < 0 ? -1 : 1;
    const auto changed = [&](Eigen::Index v) -> std::optional<std::array<double, 4>> {
      const Eigen::RowVector4f tangent = edit_.tangents.row(v);
      const Eigen::Vector3d own =
          (back * tangent.head<3>().transpose().cast<double>()).normalized();
      if (tangent == rest_.tangents.row(v) || !own.allFinite()) return std::nullopt;
      return std::array<double, 4>{own.x(), own.y(), own.z(),
                                   side * static_cast<double>(tangent[3])};
    };
    return elements_of(part, *part.tangent, "tangent", changed);
  }

  /// Makes the node show a mesh with these references: its own if no other needs that otherwise.
  void claim(std::size_t node, std::size_t mesh, const MeshReferences& references) {
    std::vector<Claim>& claims = claims_[mesh];
    auto same = std::find_if(claims.begin(), claims.end(),
                             [&](const Claim& claim) { return claim.references == references; });
    if (same == claims.end() && claims.empty()) {
      claims.push_back({references, mesh});
      put_references(json_, meshes_[mesh], references);
      return;
    }
    if (same == claims.end()) {
      JsonText copy(json_.at(meshes_[mesh]));
      put_references(copy, copy.root(), references);
      claims.push_back({references, meshes_.size() + new_meshes_.size()});
      new_meshes_.push_back(copy.edited());
      same = claims.end() - 1;
    }
    if (same->mesh == mesh) return;
    json_.replace(json_.members(nodes_[node]).at("mesh"), std::to_string(same->mesh));
  }

  const File& file_;
  const Scene& scene_;
  const Rest& rest_;
  const Edit& edit_;
  double noise_;  ///< distances that rounding of doubles makes
  JsonText json_;
  AccessorEdit accessors_;
  std::vector<JsonText::Span> meshes_;
  std::vector<JsonText::Span> nodes_;
  std::vector<std::vector<Claim>> claims_;  ///< of each mesh
  std::vector<std::string> new_meshes_;
};

}  // namespace

Files edited_files(const File& file, const Scene& scene, const Rest& rest, const Edit& edit,
                   const std::filesystem::path& path) {
  return Editor(file, scene, rest, edit).files(path);
}

}  // namespace hwffd::gltf
