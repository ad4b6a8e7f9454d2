#include <assimp/material.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <utility>

#include "hwffd/mesh/extension.hpp"
#include "mesh/format/document.hpp"
#include "mesh/format/text.hpp"
#include "mesh/read_scene.hpp"
#include "mesh/weld.hpp"

namespace hwffd {
namespace {

namespace fs = std::filesystem;

using Vectors = std::array<Eigen::RowVector3d, 4>;  ///< of a facet: normal and corners

/// Goes over the facets of a text, whose words may stand in any lines.
class StlText {
 public:
  explicit StlText(const std::string& bytes) : lines_(bytes, LineReader::Continuation::kNone) {}

  /// @param solid  takes the name of a solid
  /// @param facet  takes the twelve words of a facet: normal and corners
  template <typename Solid, typename Facet>
  void walk(Solid solid, Facet facet) {
    std::array<std::string_view, 12> words;
    while (next()) {
      const std::string keyword = lower_case(word_);
      if (keyword == "solid") {
        solid(rest());
      } else if (keyword == "endsolid") {
        rest();
      } else if (keyword == "facet") {
        std::size_t w = 0;
        expect("normal");
        for (; w < 3; ++w) words[w] = number();
        expect("outer");
        expect("loop");
        while (w < words.size()) {
          expect("vertex");
          for (std::size_t axis = 0; axis < 3; ++axis) words[w++] = number();
        }
        expect("endloop");
        expect("endfacet");
        facet(words);
      } else {
        throw not_a_mesh(in_quotes(word_) + " where a facet should begin");
      }
    }
  }

 private:
  bool next() {
    while (at_ == lines_.words().size()) {
      if (!lines_.next()) return false;
      at_ = 0;
    }
    word_ = lines_.words()[at_++];
    return true;
  }

  std::string_view rest() {
    const std::string_view text = lines_.from(at_);
    at_ = lines_.words().size();
    return text;
  }

  std::string_view number() {
    if (!next()) throw not_a_mesh("the file ends in a facet");
    return word_;
  }

  void expect(const char* keyword) {
    if (!next()) throw not_a_mesh("the file ends in a facet");
    if (lower_case(word_) == keyword) return;
    throw not_a_mesh(in_quotes(word_) + " where '" + keyword + "' should stand");
  }

  LineReader lines_;
  std::size_t at_ = 0;
  std::string_view word_;
};

constexpr std::size_t kHeader = 80;
constexpr std::size_t kFirst = kHeader + sizeof(std::uint32_t);
constexpr std::size_t kFacet = 50;

std::uint32_t facets_in(const std::string& bytes) {
  std::uint32_t count = 0;
  if (bytes.size() >= kFirst) std::memcpy(&count, bytes.data() + kHeader, sizeof(count));
  return count;
}

/// Programs begin binary files with "solid", too: the size decides, and then the word "facet".
bool is_text(const std::string& bytes) {
  const bool fits = bytes.size() == kFirst + std::uint64_t{kFacet} * facets_in(bytes);
  if (bytes.size() >= kFirst && fits) return false;
  LineReader lines(bytes, LineReader::Continuation::kNone);
  bool is_solid = false;
  while (lines.next()) {
    if (lines.words().empty()) continue;
    const std::string word = lower_case(lines.words()[0]);
    const bool ends = word == "facet" || word == "endsolid";
    if (is_solid) return ends;
    if (word != "solid") return false;
    is_solid = true;
    for (const std::string_view further : lines.words()) {
      if (lower_case(further) == "facet" || lower_case(further) == "endsolid") return true;
    }
  }
  return is_solid && bytes.find('\0') == bytes.npos;
}

Eigen::RowVector3d vector_at(const char* bytes) {
  std::array<float, 3> values{};
  std::memcpy(values.data(), bytes, sizeof(values));
  return {values[0], values[1], values[2]};
}

std::unique_ptr<aiMaterial> material() {
  auto result = std::make_unique<aiMaterial>();
  const aiString name(AI_DEFAULT_MATERIAL_NAME);
  const aiColor4D grey(0.6f, 0.6f, 0.6f, 1.0f);
  const aiColor4D dark(0.05f, 0.05f, 0.05f, 1.0f);
  result->AddProperty(&name, AI_MATKEY_NAME);
  result->AddProperty(&grey, 1, AI_MATKEY_COLOR_DIFFUSE);
  result->AddProperty(&grey, 1, AI_MATKEY_COLOR_SPECULAR);
  result->AddProperty(&dark, 1, AI_MATKEY_COLOR_AMBIENT);
  return result;
}

/// The direction of a facet; zero if it has none.
Eigen::RowVector3d direction(const Vectors& facet) {
  return (facet[2] - facet[1]).cross(facet[3] - facet[1]).stableNormalized();
}

class StlDocument : public Document {
 public:
  explicit StlDocument(std::string bytes) : bytes_(std::move(bytes)), is_text_(is_text(bytes_)) {
    content_.nodes.push_back({"", 0, {}});
    if (is_text_) {
      read_text();
    } else {
      read_binary();
    }
    content_.parts.back().faces = normals_.size() / 3 - content_.parts.back().first_face;
    join();
    is_single_ = content_.is_single;
    content_.is_numbered = false;
    content_.materials.push_back(material());
  }

  bool is_of(const fs::path& path) const override { return extension_of(path) == ".stl"; }

  Files edited(const Edit& edit, const fs::path& path) const override {
    return {{path.filename().string(), is_text_ ? edited_text(edit) : edited_binary(edit)}};
  }

 private:
  void begin_part(const std::string& name, std::uint32_t node) {
    const std::size_t first = normals_.size() / 3;
    if (!content_.parts.empty()) {
      content_.parts.back().faces = first - content_.parts.back().first_face;
    }
    content_.nodes[node].parts.push_back(static_cast<std::uint32_t>(content_.parts.size()));
    content_.parts.push_back({name, 0, first, 0});
  }

  void read_text() {
    StlText(bytes_).walk(
        [&](std::string_view name) {
          const auto node = static_cast<std::uint32_t>(content_.nodes.size());
          content_.nodes.push_back({std::string(name), 0, {}});
          begin_part(std::string(name), node);
        },
        [&](const std::array<std::string_view, 12>& words) {
          for (std::size_t w = 0; w < words.size(); ++w) {
            const TextNumber number = number_in(words[w]);
            if (w < 3) {
              normals_.push_back(static_cast<float>(number.value));
            } else {
              corners_.push_back(number.value);
              content_.is_single = content_.is_single && number.is_single();
            }
          }
        });
    if (!content_.is_single) return;
    for (double& value : corners_) value = static_cast<float>(value);
  }

  void read_binary() {
    const std::uint64_t facets = facets_in(bytes_);
    if (bytes_.size() < kFirst) throw not_a_mesh("neither text nor long enough for its header");
    if (bytes_.size() < kFirst + kFacet * facets) throw not_a_mesh("the file ends before its data");
    begin_part("", 0);
    corners_.reserve(9 * facets);
    normals_.reserve(3 * facets);
    for (std::uint64_t f = 0; f < facets; ++f) {
      const char* const at = bytes_.data() + kFirst + kFacet * f;
      for (int axis = 0; axis < 3; ++axis) {
        normals_.push_back(static_cast<float>(vector_at(at)[axis]));
      }
      for (std::size_t v = 1; v < 4; ++v) {
        const Eigen::RowVector3d corner = vector_at(at + 12 * v);
        corners_.insert(corners_.end(), corner.data(), corner.data() + 3);
      }
      read_colour(at + 48);
    }
  }

  /// Two programs keep a colour of 5 bits a part in the last bytes of a facet.
  void read_colour(const char* at) {
    std::uint16_t bits = 0;
    std::memcpy(&bits, at, sizeof(bits));
    if (bits != 0 && colours_.empty() && (bits & 0x8000) == 0 && content_.extras.empty()) {
      content_.extras.emplace_back("attributes of facets");
    }
    if ((bits & 0x8000) == 0 && colours_.empty()) return;
    const std::size_t facet = corners_.size() / 9;
    colours_.resize(4 * (facet - 1), 1.0f);
    const bool is_red_first = bytes_.substr(0, kHeader).find("COLOR=") != bytes_.npos;
    for (int part = 0; part < 3; ++part) {
      const int shift = 5 * (is_red_first ? part : 2 - part);
      const float value = static_cast<float>(bits >> shift & 31) / 31.0f;
      colours_.push_back((bits & 0x8000) != 0 ? value : 1.0f);
    }
    colours_.push_back(1.0f);
  }

  /// Corners that agree in place, normal and colour are one vertex of a solid.
  void join() {
    const std::size_t facets = normals_.size() / 3;
    const Welded places =
        weld(Eigen::Map<const Points>(corners_.data(), static_cast<Eigen::Index>(3 * facets), 3));
    std::vector<std::uint32_t> last(static_cast<std::size_t>(places.positions.rows()), kNone);
    std::vector<std::uint32_t> before;
    std::vector<std::uint32_t> facet_of;  // of a vertex
    std::vector<std::size_t> part_of;
    std::size_t part = 0;
    for (std::uint32_t c = 0; c < 3 * facets; ++c) {
      const std::uint32_t facet = c / 3;
      while (part + 1 < content_.parts.size() && content_.parts[part + 1].first_face <= facet) {
        ++part;
      }
      const std::uint32_t place = places.vertices[c];
      std::uint32_t vertex = last[place];
      const auto agrees = [&](std::uint32_t v) {
        return part_of[v] == part && same(facet_of[v], facet);
      };
      unsigned searched = 0;
      while (vertex != kNone && searched < kMostSearched && !agrees(vertex)) {
        vertex = before[vertex];
        ++searched;
      }
      if (vertex == kNone || searched == kMostSearched) {
        vertex = static_cast<std::uint32_t>(before.size());
        before.push_back(last[place]);
        facet_of.push_back(facet);
        part_of.push_back(part);
        last[place] = vertex;
        place_of_.push_back(place);
      }
      content_.corners.push_back(vertex);
    }
    put_vertices(places.positions, facet_of);
    vertex_of_corner_ = content_.corners;
    corners_ = {};
    normals_ = {};
    colours_ = {};
  }

  bool same(std::uint32_t a, std::uint32_t b) const {
    if (a == b) return true;
    const auto equal = [&](const std::vector<float>& list, std::size_t n) {
      return list.empty() || std::equal(list.begin() + static_cast<std::ptrdiff_t>(n * a),
                                        list.begin() + static_cast<std::ptrdiff_t>(n * a + n),
                                        list.begin() + static_cast<std::ptrdiff_t>(n * b));
    };
    return equal(normals_, 3) && equal(colours_, 4);
  }

  void put_vertices(const Points& places, const std::vector<std::uint32_t>& facet_of) {
    const auto rows = static_cast<Eigen::Index>(place_of_.size());
    content_.positions.resize(rows, 3);
    content_.normals.rows.resize(rows, 3);
    Values<4> colours;
    if (!colours_.empty()) colours.rows.resize(rows, 4);
    colours_.resize(colours_.empty() ? 0 : normals_.size() / 3 * 4, 1.0f);
    for (Eigen::Index v = 0; v < rows; ++v) {
      const auto vertex = static_cast<std::size_t>(v);
      content_.positions.row(v) = places.row(place_of_[vertex]);
      for (int c = 0; c < 4; ++c) {
        const auto at = static_cast<std::size_t>(c);
        if (c < 3) content_.normals.rows(v, c) = normals_[3 * facet_of[vertex] + at];
        if (!colours_.empty()) colours.rows(v, c) = colours_[4 * facet_of[vertex] + at];
      }
    }
    if (!colours.empty()) content_.colours.push_back(std::move(colours));
    place_of_ = {};
  }

  /// Where a facet is now. Its normal is that of its corners if these moved and it had one.
  Vectors moved(const Vectors& read, std::size_t facet, const Edit& edit) const {
    Vectors now = read;
    bool moves = edit.turned;
    for (std::size_t c = 0; c < 3; ++c) {
      const std::size_t from = edit.turned && c > 0 ? 3 - c : c;
      now[1 + c] = edit.position(vertex_of_corner_[3 * facet + from]);
      moves = moves || now[1 + c] != read[1 + c];
    }
    const Eigen::RowVector3d direction_now = direction(now);
    const bool has_normal = read[0].allFinite() && !read[0].isZero();
    if (!moves || !has_normal || direction_now.isZero()) return now;
    const double side = read[0].dot(direction(read)) < 0 ? -1.0 : 1.0;
    const Eigen::RowVector3d normal = side * direction_now;
    constexpr double kRounding = 0x1p-22;  // a change that is no more stays away
    for (int axis = 0; axis < 3; ++axis) {
      if (std::abs(normal[axis] - read[0][axis]) > kRounding) now[0][axis] = normal[axis];
    }
    return now;
  }

  std::string edited_text(const Edit& edit) const {
    Replacement text(bytes_);
    std::size_t facet = 0;
    StlText(bytes_).walk([](std::string_view) {},
                         [&](const std::array<std::string_view, 12>& words) {
                           Vectors read;
                           for (std::size_t w = 0; w < words.size(); ++w) {
                             const double value = number_in(words[w]).value;
                             const bool is_single = w < 3 || is_single_;
                             read[w / 3][static_cast<Eigen::Index>(w % 3)] =
                                 is_single ? static_cast<float>(value) : value;
                           }
                           const Vectors now = moved(read, facet++, edit);
                           for (std::size_t w = 0; w < words.size(); ++w) {
                             const auto axis = static_cast<Eigen::Index>(w % 3);
                             text.replace_number(words[w], read[w / 3][axis], now[w / 3][axis],
                                                 w < 3 || is_single_);
                           }
                         });
    return text.take();
  }

  std::string edited_binary(const Edit& edit) const {
    std::string bytes = bytes_;
    for (std::size_t facet = 0; 3 * facet < vertex_of_corner_.size(); ++facet) {
      char* const at = bytes.data() + kFirst + kFacet * facet;
      Vectors read;
      for (std::size_t v = 0; v < 4; ++v) read[v] = vector_at(at + 12 * v);
      const Vectors now = moved(read, facet, edit);
      for (std::size_t v = 0; v < 4; ++v) {
        for (std::size_t axis = 0; axis < 3; ++axis) {
          const auto a = static_cast<Eigen::Index>(axis);
          if (now[v][a] == read[v][a] || std::isnan(now[v][a])) continue;
          const auto value = static_cast<float>(now[v][a]);
          std::memcpy(at + 12 * v + 4 * axis, &value, sizeof(value));
        }
      }
    }
    return bytes;
  }

  static constexpr unsigned kMostSearched = 256;  // of one place: a hostile file has any number

  std::string bytes_;
  bool is_text_;
  bool is_single_ = true;
  std::vector<double> corners_;  ///< of facets, until they are joined, as what follows
  std::vector<float> normals_;
  std::vector<float> colours_;
  std::vector<std::uint32_t> place_of_;
  std::vector<std::uint32_t> vertex_of_corner_;
};

}  // namespace

std::unique_ptr<Document> read_stl(const fs::path& /*path*/, std::string bytes) {
  return std::make_unique<StlDocument>(std::move(bytes));
}

}  // namespace hwffd
