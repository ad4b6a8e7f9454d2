#include <assimp/material.h>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

#include "hwffd/excerpt.hpp"
#include "mesh/format/ply.hpp"
#include "mesh/format/text.hpp"
#include "mesh/read_scene.hpp"

namespace hwffd {
namespace {

std::size_t place_of(const std::string& name) {
  static const std::map<std::string, std::size_t> kPlaceOf = {{"x", 0},
                                                              {"y", 1},
                                                              {"z", 2},
                                                              {"nx", 3},
                                                              {"ny", 4},
                                                              {"nz", 5},
                                                              {"s", 6},
                                                              {"t", 7},
                                                              {"u", 6},
                                                              {"v", 7},
                                                              {"tx", 6},
                                                              {"ty", 7},
                                                              {"texture_u", 6},
                                                              {"texture_v", 7},
                                                              {"red", 8},
                                                              {"green", 9},
                                                              {"blue", 10},
                                                              {"alpha", 11},
                                                              {"r", 8},
                                                              {"g", 9},
                                                              {"b", 10},
                                                              {"a", 11},
                                                              {"diffuse_red", 8},
                                                              {"diffuse_green", 9},
                                                              {"diffuse_blue", 10},
                                                              {"diffuse_alpha", 11}};
  const auto it = kPlaceOf.find(name);
  return it == kPlaceOf.end() ? PlyVertex::kUnknown : it->second;
}

/// What a colour is divided by: a type of integers says it itself, but wide ones and numbers beyond
/// 1 go to 255.
float largest_colour(const PlyType& type, float most) {
  if (type.is_integer() && type.size <= 2) {
    const double values = std::ldexp(1.0, static_cast<int>(8 * type.size));
    return static_cast<float>(type.kind == PlyType::Kind::kSigned ? values / 2 - 1 : values - 1);
  }
  return most > 1 ? 255.0f : 1.0f;
}

std::unique_ptr<aiMaterial> material_of(const std::string& texture) {
  auto material = std::make_unique<aiMaterial>();
  const int shading = aiShadingMode_Gouraud;
  const int two_sided = 1;
  const aiColor4D grey(0.6f, 0.6f, 0.6f, 1.0f);
  const aiColor4D dark(0.05f, 0.05f, 0.05f, 1.0f);
  material->AddProperty(&shading, 1, AI_MATKEY_SHADING_MODEL);
  material->AddProperty(&grey, 1, AI_MATKEY_COLOR_DIFFUSE);
  material->AddProperty(&grey, 1, AI_MATKEY_COLOR_SPECULAR);
  material->AddProperty(&dark, 1, AI_MATKEY_COLOR_AMBIENT);
  material->AddProperty(&two_sided, 1, AI_MATKEY_TWOSIDED);
  if (texture.empty()) return material;
  const aiString name(texture);
  material->AddProperty(&name, AI_MATKEY_TEXTURE_DIFFUSE(0));
  return material;
}

class PlyReader {
 public:
  PlyReader(const std::string& bytes, const PlyHeader& header, Content& content)
      : size_(bytes.size()), header_(header), cursor_(bytes, header), content_(content) {}

  void read() {
    bool has_vertices = false;
    for (const PlyElement& element : header_.elements) {
      if (element.properties.empty() && element.rows > 0) {
        throw not_a_mesh("element " + in_quotes(element.name) + " has no properties");
      }
      if (element.name == "vertex" && !has_vertices) {
        read_vertices(element);
        has_vertices = true;
      } else if (element.name == "face") {
        read_faces(element);
      } else if (element.name == "tristrips") {
        read_strips(element);
      } else {
        content_.extras.push_back("element " + excerpt(element.name, kQuoted));
        read_rows(
            element, [&](const PlyProperty& property) { cursor_.skip(property); }, [] {});
      }
    }
    finish();
  }

 private:
  template <typename TakeProperty, typename EndRow>
  void read_rows(const PlyElement& element, TakeProperty take, EndRow end) {
    for (std::uint64_t row = 0; row < element.rows; ++row) {
      for (const PlyProperty& property : element.properties) take(property);
      end();
    }
  }

  void add_extra(const PlyProperty& property, const PlyElement& element) {
    content_.extras.push_back(
        fmt::format("property {} of {}", excerpt(property.name, kQuoted), element.name));
  }

  void read_vertices(const PlyElement& element) {
    const PlyVertex vertex(element);
    if (!vertex.has(PlyVertex::kPosition, 3)) throw not_a_mesh("no x, y and z of vertices");
    for (std::size_t p = 0; p < element.properties.size(); ++p) {
      if (vertex.places()[p] == PlyVertex::kUnknown) add_extra(element.properties[p], element);
    }
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const PlyType& type = vertex.type(axis);
      const bool is_short = type.is_integer() ? type.size <= 2 : type.size <= sizeof(float);
      content_.is_single = content_.is_single && is_short;
    }
    // Each row has three values, of a byte or more.
    if (element.rows > size_ / 3) throw not_a_mesh("the file ends before its data");
    const auto rows = static_cast<Eigen::Index>(element.rows);
    content_.positions.resize(rows, 3);
    const bool has_normals = vertex.has(PlyVertex::kNormal, 3);
    const bool has_textures = vertex.has(PlyVertex::kTexture, 2);
    const bool has_colours = vertex.has(PlyVertex::kColour, 3);
    if (has_normals) content_.normals.rows.resize(rows, 3);
    Values<3> textures;
    if (has_textures) textures.rows.setZero(rows, 3);
    Values<4> colours;
    if (has_colours) colours.rows.setOnes(rows, 4);
    std::array<double, PlyVertex::kPlaces> numbers{};
    for (Eigen::Index row = 0; row < rows; ++row) {
      read_vertex(element, vertex, numbers);
      for (int axis = 0; axis < 3; ++axis) {
        const auto c = static_cast<std::size_t>(axis);
        content_.positions(row, axis) = numbers[c];
        if (has_normals) {
          content_.normals.rows(row, axis) = static_cast<float>(numbers[PlyVertex::kNormal + c]);
        }
        if (has_textures && axis < 2) {
          textures.rows(row, axis) = static_cast<float>(numbers[PlyVertex::kTexture + c]);
        }
      }
      for (int c = 0; has_colours && c < 4; ++c) {
        colours.rows(row, c) =
            static_cast<float>(numbers[PlyVertex::kColour + static_cast<std::size_t>(c)]);
      }
    }
    if (has_textures) add_textures(std::move(textures));
    if (has_colours) add_colours(vertex, std::move(colours));
  }

  void read_vertex(const PlyElement& element, const PlyVertex& vertex,
                   std::array<double, PlyVertex::kPlaces>& numbers) {
    for (std::size_t p = 0; p < element.properties.size(); ++p) {
      const PlyProperty& property = element.properties[p];
      const std::size_t place = vertex.places()[p];
      if (place == PlyVertex::kUnknown) {
        cursor_.skip(property);
      } else {
        numbers[place] = cursor_.number(cursor_.take(property.value), property.value);
      }
    }
  }

  void add_textures(Values<3> textures) {
    content_.textures.push_back(std::move(textures));
    content_.texture_sizes.push_back(2);
  }

  void add_colours(const PlyVertex& vertex, Values<4> colours) {
    const float most = colours.rows.rows() == 0 ? 0 : colours.rows.maxCoeff();
    for (int c = 0; c < 4; ++c) {
      const PlyType& type = vertex.type(PlyVertex::kColour + static_cast<std::size_t>(c));
      if (type.size == 0) {
        colours.rows.col(c).setOnes();
      } else {
        colours.rows.col(c) /= largest_colour(type, most);
      }
    }
    content_.colours.push_back(std::move(colours));
  }

  void add_corner(double vertex) {
    const bool is_good = vertex >= 0 && vertex < kNone && vertex == std::floor(vertex);
    content_.corners.push_back(is_good ? static_cast<std::uint32_t>(vertex) : kNone);
  }

  void read_list(const PlyProperty& list, std::vector<double>& values) {
    values.clear();
    for (std::uint64_t count = cursor_.take_count(list); count > 0; --count) {
      values.push_back(cursor_.number(cursor_.take(list.value), list.value));
    }
  }

  void read_faces(const PlyElement& element) {
    for (const PlyProperty& property : element.properties) {
      if (!is_ply_corners(property) && !is_ply_textures(property)) add_extra(property, element);
    }
    constexpr std::uint64_t kTriangle = 3;
    content_.corners.reserve(std::min<std::uint64_t>(kTriangle * element.rows, size_));
    std::vector<double> corners;
    std::vector<double> textures;
    read_rows(
        element,
        [&](const PlyProperty& property) {
          if (is_ply_corners(property)) {
            read_list(property, corners);
          } else if (is_ply_textures(property)) {
            read_list(property, textures);
          } else {
            cursor_.skip(property);
          }
        },
        [&] {
          add_face(corners, textures);
          corners.clear();
          textures.clear();
        });
  }

  void add_face(const std::vector<double>& corners, const std::vector<double>& textures) {
    if (corners.empty()) return;
    const std::size_t begin = content_.corners.size();
    for (const double corner : corners) add_corner(corner);
    content_.end_face(begin);
    if (textures.size() != 2 * corners.size()) return;
    texture_of_corner_.resize(begin, kNone);
    for (std::size_t c = 0; c < corners.size(); ++c) {
      texture_of_corner_.push_back(static_cast<std::uint32_t>(face_textures_.size() / 3));
      const auto value = [&](std::size_t n) { return static_cast<float>(textures[2 * c + n]); };
      face_textures_.insert(face_textures_.end(), {value(0), value(1), 0.0f});
    }
  }

  /// Strips of triangles, which turn about; a negative number begins another.
  void read_strips(const PlyElement& element) {
    for (const PlyProperty& property : element.properties) {
      if (!is_ply_corners(property)) add_extra(property, element);
    }
    std::vector<double> corners;
    read_rows(
        element,
        [&](const PlyProperty& property) {
          if (is_ply_corners(property)) {
            read_list(property, corners);
          } else {
            cursor_.skip(property);
          }
        },
        [&] {
          std::size_t first = 0;
          for (std::size_t c = 0; c < corners.size(); ++c) {
            if (corners[c] < 0) first = c + 1;
            if (c < first + 2) continue;
            const std::size_t begin = content_.corners.size();
            const std::size_t odd = (c - first) % 2;
            for (const std::size_t n : {c - 2 + odd, c - 1 - odd, c}) add_corner(corners[n]);
            content_.end_face(begin);
          }
          corners.clear();
        });
  }

  void finish() {
    if (!texture_of_corner_.empty()) {
      if (!content_.textures.empty()) content_.extras.emplace_back("second texture coordinates");
      content_.textures.clear();
      content_.texture_sizes.clear();
      texture_of_corner_.resize(content_.corners.size(), kNone);
      Values<3> textures;
      textures.rows = Eigen::Map<const decltype(textures.rows)>(
          face_textures_.data(), static_cast<Eigen::Index>(face_textures_.size() / 3), 3);
      textures.of_corner = std::move(texture_of_corner_);
      add_textures(std::move(textures));
    }
    content_.parts.push_back({"", 0, 0, content_.face_count()});
    content_.nodes.push_back({"", 0, {0}});
    content_.materials.push_back(
        material_of(header_.textures.empty() ? "" : header_.textures.front().name));
  }

  std::size_t size_;
  const PlyHeader& header_;
  PlyCursor cursor_;
  Content& content_;
  std::vector<float> face_textures_;
  std::vector<std::uint32_t> texture_of_corner_;
};

}  // namespace

PlyVertex::PlyVertex(const PlyElement& element) {
  for (const PlyProperty& property : element.properties) {
    std::size_t place = property.is_list ? kUnknown : place_of(property.name);
    if (place != kUnknown && types_[place].size != 0) place = kUnknown;  // there already
    if (place != kUnknown) types_[place] = property.value;
    places_.push_back(place);
  }
}

bool PlyVertex::has(std::size_t first, std::size_t count) const {
  return std::all_of(types_.begin() + static_cast<std::ptrdiff_t>(first),
                     types_.begin() + static_cast<std::ptrdiff_t>(first + count),
                     [](const PlyType& type) { return type.size != 0; });
}

bool is_ply_corners(const PlyProperty& property) {
  return property.is_list && (property.name == "vertex_indices" || property.name == "vertex_index");
}

bool is_ply_textures(const PlyProperty& property) {
  return property.is_list && property.name == "texcoord";
}

void read_ply_content(const std::string& bytes, const PlyHeader& header, Content& content) {
  PlyReader(bytes, header, content).read();
}

}  // namespace hwffd
