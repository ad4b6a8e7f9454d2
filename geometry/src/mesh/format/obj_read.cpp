#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <limits>
#include <map>
#include <optional>
#include <set>
#include <system_error>
#include <utility>

#include "hwffd/excerpt.hpp"
#include "mesh/format/mtl.hpp"
#include "mesh/format/obj_syntax.hpp"
#include "read_file.hpp"

namespace hwffd {
namespace {

namespace fs = std::filesystem;

class ObjReader {
 public:
  ObjReader(const fs::path& path, const std::string& bytes)
      : folder_(path.parent_path()), stem_(path.stem().string()), bytes_(bytes) {
    content_.nodes.push_back({path.filename().string(), 0, {}});
  }

  void read(Content& content, std::vector<fs::path>& companions) {
    LineReader lines(bytes_, kObjLines);
    while (lines.next()) {
      if (!lines.words().empty()) take(lines);
    }
    finish();
    content = std::move(content_);
    companions = std::move(companions_);
  }

 private:
  void take(const LineReader& lines) {
    const std::string_view keyword = lines.words()[0];
    if (keyword == "v") return take_vertex(lines);
    if (keyword == "vt") return take_texture(lines);
    if (keyword == "vn") {
      const ObjVector normal = obj_normal(lines);
      for (std::size_t axis = 0; axis < 3; ++axis) {
        normals_.push_back(static_cast<float>(normal.value(axis)));
      }
      return;
    }
    if (is_obj_element(keyword)) return take_element(lines);
    if (keyword == "o" || keyword == "g") return begin_node(std::string(lines.from(1)));
    if (keyword == "usemtl") return use_material(std::string(lines.from(1)));
    if (keyword == "mtllib") return take_library(lines);
    if (keyword == "s") {
      const bool is_off =
          lines.words().size() < 2 || lines.words()[1] == "off" || lines.words()[1] == "0";
      if (!is_off) extras_.insert("smoothing groups");
      return;
    }
    extras_.insert("statement " + excerpt(keyword, kNamed));
  }

  void take_vertex(const LineReader& lines) {
    const ObjVector vertex = obj_vertex(lines);
    for (std::size_t axis = 0; axis < 3; ++axis) {
      positions_.push_back(vertex.value(axis));
      content_.is_single = content_.is_single && vertex.numbers[axis].is_single();
    }
    constexpr std::size_t kColoured = 7;
    const std::vector<std::string_view>& words = lines.words();
    std::array<float, 4> colour{kNoNumber, kNoNumber, kNoNumber, 1};
    for (std::size_t c = 0; c < 3 && words.size() >= kColoured; ++c) {
      TextNumber number;
      if (!read_number(words[4 + c], number)) refuse_line(lines, "a vertex is not three numbers");
      colour[c] = static_cast<float>(number.value);
      has_colours_ = true;
      most_colour_ = std::max(most_colour_, colour[c]);
    }
    if (has_colours_) {
      colours_.resize(positions_.size() / 3 * 4 - 4, kNoNumber);
      colours_.insert(colours_.end(), colour.begin(), colour.end());
    }
  }

  void take_texture(const LineReader& lines) {
    std::array<float, 3> value{0, 0, 0};
    const std::size_t count = std::min<std::size_t>(lines.words().size() - 1, 3);
    for (std::size_t c = 0; c < count; ++c) {
      TextNumber number;
      if (!read_number(lines.words()[1 + c], number)) {
        refuse_line(lines, "texture coordinates are no numbers");
      }
      value[c] = static_cast<float>(number.value);
    }
    if (count == 0) refuse_line(lines, "texture coordinates are no numbers");
    texture_size_ = std::max(texture_size_, static_cast<unsigned>(std::max<std::size_t>(count, 2)));
    textures_.insert(textures_.end(), value.begin(), value.end());
  }

  /// The row that a number means: from 1, or from the last one backwards.
  static std::uint32_t row_of(const LineReader& lines, std::int64_t number, std::size_t count) {
    if (number == 0) return kNone;
    const std::int64_t row = number > 0 ? number - 1 : static_cast<std::int64_t>(count) + number;
    if (row < 0 || row >= std::int64_t{kNone}) {
      refuse_line(lines, fmt::format("a face refers to number {} of {}", number, count));
    }
    return static_cast<std::uint32_t>(row);
  }

  void take_element(const LineReader& lines) {
    const std::vector<std::string_view>& words = lines.words();
    if (words.size() < 2) refuse_line(lines, "a face without corners");
    begin_part();
    std::vector<std::array<std::uint32_t, 3>>& corners = element_;
    corners.clear();
    for (std::size_t w = 1; w < words.size(); ++w) {
      const ObjCorner corner = obj_corner(lines, words[w]);
      corners.push_back({row_of(lines, corner.numbers[0], positions_.size() / 3),
                         row_of(lines, corner.numbers[1], textures_.size() / 3),
                         row_of(lines, corner.numbers[2], normals_.size() / 3)});
    }
    if (words[0] == "f") {
      add_face(0, corners.size());
    } else if (words[0] == "p" || corners.size() == 1) {
      for (std::size_t c = 0; c < corners.size(); ++c) add_face(c, c + 1);
    } else {
      for (std::size_t c = 1; c < corners.size(); ++c) add_face(c - 1, c + 1);
    }
  }

  void add_face(std::size_t begin, std::size_t end) {
    for (std::size_t c = begin; c < end; ++c) {
      content_.corners.push_back(element_[c][0]);
      texture_of_corner_.push_back(element_[c][1]);
      normal_of_corner_.push_back(element_[c][2]);
    }
    content_.face_ends.push_back(content_.corners.size());
    ++content_.parts.back().faces;
  }

  void begin_part() {
    if (!node_) begin_node("defaultobject");
    if (!is_new_part_ && content_.parts.back().material == material_) return;
    content_.nodes[*node_].parts.push_back(static_cast<std::uint32_t>(content_.parts.size()));
    content_.parts.push_back(
        {content_.nodes[*node_].name, material_, content_.face_ends.size(), 0});
    is_new_part_ = false;
  }

  /// A group or object; its faces may come in several places.
  void begin_node(std::string name) {
    if (name.empty()) name = "default";
    const auto next = static_cast<std::uint32_t>(content_.nodes.size());
    const auto [entry, is_new] = node_of_.emplace(name, next);
    if (is_new) content_.nodes.push_back({std::move(name), 0, {}});
    is_new_part_ = is_new_part_ || entry->second != node_;
    node_ = entry->second;
  }

  void use_material(const std::string& name) {
    const auto next = static_cast<std::uint32_t>(used_.size() + 1);
    const auto [entry, is_new] = used_numbers_.emplace(name, next);
    if (is_new) used_.push_back(name);
    material_ = entry->second;
  }

  /// The rest of the line is a name, which may have blanks, or several.
  void take_library(const LineReader& lines) {
    if (read_library(lines.from(1))) return;
    bool some = false;
    for (std::size_t w = 1; w < lines.words().size(); ++w) {
      some = read_library(lines.words()[w]) || some;
    }
    if (!some) read_library(stem_ + ".mtl");
  }

  bool read_library(std::string_view name) {
    const fs::path path = folder_ / name;
    std::error_code ignored;
    if (name.empty() || !fs::is_regular_file(path, ignored)) return false;
    if (std::find(companions_.begin(), companions_.end(), path) != companions_.end()) return true;
    companions_.push_back(path);
    for (MtlMaterial& material : read_mtl(read_file(path))) {
      for (const std::string& extra : material.extras) {
        extras_.insert("statement " + excerpt(extra, kNamed) + " of materials");
      }
      library_.push_back(std::move(material));
    }
    return true;
  }

  void finish() {
    const auto vertices = static_cast<Eigen::Index>(positions_.size() / 3);
    content_.positions = Eigen::Map<const Points>(positions_.data(), vertices, 3);
    if (content_.is_single) {
      content_.positions = content_.positions.cast<float>().cast<double>().eval();
    }
    put_rows(normals_, std::move(normal_of_corner_), content_.normals);
    Values<3> textures;
    put_rows(textures_, std::move(texture_of_corner_), textures);
    if (!textures.empty()) {
      content_.textures.push_back(std::move(textures));
      content_.texture_sizes.push_back(texture_size_);
    }
    if (has_colours_) put_colours(vertices);
    if (content_.parts.empty()) add_cloud();
    put_materials();
    content_.extras.assign(extras_.begin(), extras_.end());
  }

  /// Values that no corner has are none.
  static void put_rows(const std::vector<float>& numbers, std::vector<std::uint32_t> of_corner,
                       Values<3>& values) {
    const bool some = std::any_of(of_corner.begin(), of_corner.end(),
                                  [](std::uint32_t row) { return row != kNone; });
    if (!some) return;
    values.rows = Eigen::Map<const decltype(values.rows)>(
        numbers.data(), static_cast<Eigen::Index>(numbers.size() / 3), 3);
    values.of_corner = std::move(of_corner);
  }

  /// Up to 1, or, where any number is larger, up to 255.
  void put_colours(Eigen::Index vertices) {
    Values<4>& colours = content_.colours.emplace_back();
    colours.rows = Eigen::Map<const decltype(colours.rows)>(colours_.data(), vertices, 4);
    if (most_colour_ > 1) colours.rows.leftCols<3>() /= 255.0f;
  }

  /// Points alone, in the group that the file names, if any.
  void add_cloud() {
    const std::uint32_t node = content_.nodes.size() > 1 ? 1 : 0;
    content_.nodes[node].parts.push_back(0);
    content_.parts.push_back({node == 0 ? "" : content_.nodes[node].name, 0, 0, 0});
  }

  /// The default, those of the libraries, and those that none of them has.
  void put_materials() {
    std::map<std::string, std::uint32_t> numbers;
    content_.materials.push_back(default_material());
    const auto add = [&](const std::string& name, std::unique_ptr<aiMaterial> material) {
      if (!numbers.emplace(name, content_.materials.size()).second) return;
      content_.materials.push_back(std::move(material));
    };
    for (MtlMaterial& material : library_) add(material.name, std::move(material.material));
    for (const std::string& name : used_) {
      if (numbers.count(name) == 0) add(name, named_material(name));
    }
    for (ContentPart& part : content_.parts) {
      if (part.material != 0) part.material = numbers.at(used_[part.material - 1]);
    }
  }

  static constexpr std::size_t kNamed = 30;  // characters of a statement in a warning
  static constexpr float kNoNumber = std::numeric_limits<float>::quiet_NaN();

  fs::path folder_;
  std::string stem_;
  const std::string& bytes_;
  Content content_;
  std::vector<double> positions_;
  std::vector<float> normals_;
  std::vector<float> textures_;
  std::vector<float> colours_;
  bool has_colours_ = false;
  float most_colour_ = 0;
  unsigned texture_size_ = 2;
  std::vector<std::array<std::uint32_t, 3>> element_;
  std::vector<std::uint32_t> texture_of_corner_;
  std::vector<std::uint32_t> normal_of_corner_;
  std::map<std::string, std::uint32_t> node_of_;
  std::optional<std::uint32_t> node_;
  bool is_new_part_ = true;
  std::uint32_t material_ = 0;  ///< 0, or one more than in used_
  std::vector<std::string> used_;
  std::map<std::string, std::uint32_t> used_numbers_;
  std::vector<MtlMaterial> library_;
  std::vector<fs::path> companions_;
  std::set<std::string> extras_;
};

}  // namespace

void read_obj_content(const fs::path& path, const std::string& bytes, Content& content,
                      std::vector<fs::path>& companions) {
  ObjReader(path, bytes).read(content, companions);
}

}  // namespace hwffd
