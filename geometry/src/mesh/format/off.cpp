#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <utility>

#include "hwffd/mesh/extension.hpp"
#include "mesh/format/document.hpp"
#include "mesh/format/mtl.hpp"
#include "mesh/format/text.hpp"
#include "mesh/read_scene.hpp"

namespace hwffd {
namespace {

namespace fs = std::filesystem;

/// What the first word of a file says of its vertices.
struct OffHeader {
  bool has_textures = false;
  bool has_colours = false;
  bool has_normals = false;
  std::size_t vertices = 0;
  std::size_t faces = 0;
};

using OffWords = std::vector<std::string_view>;

/// Goes over a file: vertices, then faces. Both who reads it and who edits it are called back.
class OffFile {
 public:
  explicit OffFile(const std::string& bytes)
      : size_(bytes.size()), lines_(bytes, LineReader::Continuation::kNone) {
    read_header();
  }

  const OffHeader& header() const { return header_; }

  /// @param vertex  takes the words of a vertex: place, normal, colour, texture coordinates
  /// @param face    takes the corners of a face, and how many words follow on the line
  template <typename Vertex, typename Face>
  void walk(Vertex vertex, Face face) {
    OffWords words;
    for (std::size_t v = 0; v < header_.vertices; ++v) {
      words.clear();
      const std::size_t before = 3 + (header_.has_normals ? 3 : 0);
      const std::size_t behind = header_.has_textures ? 2 : 0;
      for (std::size_t w = 0; w < before; ++w) words.push_back(next());
      if (header_.has_colours) {
        // Three or four numbers, or one: what the line has.
        for (std::size_t w = left(); w > behind; --w) words.push_back(next());
      }
      for (std::size_t w = 0; w < behind; ++w) words.push_back(next());
      vertex(words);
    }
    for (std::size_t f = 0; f < header_.faces; ++f) {
      const std::uint64_t corners = whole(next());
      // A corner has at least one character and a blank.
      if (corners > size_) throw not_a_mesh("the file ends in a face");
      words.clear();
      for (std::uint64_t c = 0; c < corners; ++c) words.push_back(next());
      face(words, left());
      word_ = lines_.words().size();
    }
  }

  static std::uint64_t whole(std::string_view word) {
    std::uint64_t value = 0;
    if (!read_whole(word, value)) {
      throw not_a_mesh(in_quotes(word) + " is not a number of vertices or faces");
    }
    return value;
  }

 private:
  std::string_view next() {
    while (word_ == lines_.words().size()) {
      if (!lines_.next()) throw not_a_mesh("the file ends before its data");
      word_ = 0;
    }
    return lines_.words()[word_++];
  }

  /// Words of the line that are still to come.
  std::size_t left() const { return lines_.words().size() - word_; }

  /// The keyword may be missing; letters in front of it say what a vertex has.
  void read_header() {
    std::string_view word = next();
    constexpr std::string_view kKeyword = "OFF";
    if (word.size() >= kKeyword.size() && word.substr(word.size() - kKeyword.size()) == kKeyword) {
      std::string_view prefix = word.substr(0, word.size() - kKeyword.size());
      const auto take = [&](std::string_view letters) {
        const bool is_there = prefix.substr(0, letters.size()) == letters;
        if (is_there) prefix.remove_prefix(letters.size());
        return is_there;
      };
      header_.has_textures = take("ST");
      header_.has_colours = take("C");
      header_.has_normals = take("N");
      if (!prefix.empty()) throw not_a_mesh("OFF with vertices that are not x y z");
      word = next();
      if (word == "BINARY") throw not_a_mesh("binary OFF");
    }
    header_.vertices = whole(word);
    header_.faces = whole(next());
    if (left() > 0) next();  // of edges, which nobody counts
    // A vertex has three numbers and the blanks between them.
    if (header_.vertices > size_ / 5) throw not_a_mesh("the file ends before its data");
  }

  std::size_t size_;
  LineReader lines_;
  std::size_t word_ = 0;
  OffHeader header_;
};

class OffDocument : public Document {
 public:
  explicit OffDocument(std::string bytes) : bytes_(std::move(bytes)) {
    read();
    is_single_ = content_.is_single;
  }

  bool is_of(const fs::path& path) const override { return extension_of(path) == ".off"; }

  Files edited(const Edit& edit, const fs::path& path) const override {
    Replacement text(bytes_);
    std::size_t row = 0;
    OffFile file(bytes_);
    const auto put = [&](std::string_view word, double now, bool is_single) {
      const double number = number_in(word).value;
      text.replace_number(word, is_single ? static_cast<float>(number) : number, now, is_single);
    };
    file.walk(
        [&](const OffWords& words) {
          const Eigen::RowVector3d position = edit.position(row);
          for (int axis = 0; axis < 3; ++axis) {
            put(words[static_cast<std::size_t>(axis)], position[axis], is_single_);
          }
          for (int axis = 0; axis < 3 && file.header().has_normals; ++axis) {
            put(words[3 + static_cast<std::size_t>(axis)],
                edit.normals.rows(static_cast<Eigen::Index>(row), axis), true);
          }
          ++row;
        },
        [&](const OffWords& corners, std::size_t) {
          for (std::size_t c = 1; edit.turned && corners.size() > 2 && c < corners.size(); ++c) {
            text.replace(corners[c], corners[corners.size() - c]);
          }
        });
    return {{path.filename().string(), text.take()}};
  }

 private:
  void read() {
    OffFile file(bytes_);
    const OffHeader& header = file.header();
    const auto rows = static_cast<Eigen::Index>(header.vertices);
    content_.positions.resize(rows, 3);
    if (header.has_normals) content_.normals.rows.resize(rows, 3);
    Values<4> colours;
    if (header.has_colours) colours.rows.setOnes(rows, 4);
    Values<3> textures;
    if (header.has_textures) textures.rows.setZero(rows, 3);
    bool has_face_colours = false;
    Eigen::Index row = 0;
    file.walk(
        [&](const OffWords& words) {
          read_vertex(words, header, row);
          const std::size_t behind = words.size() - (header.has_textures ? 2 : 0);
          const std::size_t first = header.has_normals ? 6 : 3;
          const std::size_t count = std::min<std::size_t>(behind - first, 4);
          for (std::size_t c = 0; header.has_colours && c < count; ++c) {
            colours.rows(row, static_cast<Eigen::Index>(c)) = single(words[first + c]);
          }
          for (std::size_t c = 0; header.has_textures && c < 2; ++c) {
            textures.rows(row, static_cast<Eigen::Index>(c)) = single(words[behind + c]);
          }
          ++row;
        },
        [&](const OffWords& corners, std::size_t further) {
          has_face_colours = has_face_colours || further > 0;
          const std::size_t begin = content_.corners.size();
          for (const std::string_view corner : corners) {
            const std::uint64_t vertex = OffFile::whole(corner);
            content_.corners.push_back(
                static_cast<std::uint32_t>(std::min<std::uint64_t>(vertex, kNone)));
          }
          if (!corners.empty()) content_.end_face(begin);
        });
    if (content_.is_single) {
      content_.positions = content_.positions.cast<float>().cast<double>().eval();
    }
    if (has_face_colours) content_.extras.emplace_back("colours of faces");
    finish(std::move(colours), std::move(textures));
  }

  static float single(std::string_view word) { return static_cast<float>(number_in(word).value); }

  void read_vertex(const OffWords& words, const OffHeader& header, Eigen::Index row) {
    for (int axis = 0; axis < 3; ++axis) {
      const TextNumber number = number_in(words[static_cast<std::size_t>(axis)]);
      content_.positions(row, axis) = number.value;
      content_.is_single = content_.is_single && number.is_single();
      if (header.has_normals) {
        content_.normals.rows(row, axis) = single(words[3 + static_cast<std::size_t>(axis)]);
      }
    }
  }

  /// Colours go to 1, or, where any number is larger, to 255.
  void finish(Values<4> colours, Values<3> textures) {
    if (!colours.empty()) {
      constexpr float kLargest = 255.0f;
      const float most = colours.rows.leftCols<3>().maxCoeff();
      if (most > 1) colours.rows.leftCols<3>() /= kLargest;
      if (colours.rows.rightCols<1>().maxCoeff() > 1) colours.rows.rightCols<1>() /= kLargest;
      content_.colours.push_back(std::move(colours));
    }
    if (!textures.empty()) {
      content_.textures.push_back(std::move(textures));
      content_.texture_sizes.push_back(2);
    }
    content_.parts.push_back({"", 0, 0, content_.face_count()});
    content_.nodes.push_back({"", 0, {0}});
    content_.materials.push_back(default_material());
  }

  std::string bytes_;
  bool is_single_ = true;
};

}  // namespace

std::unique_ptr<Document> read_off(const fs::path& /*path*/, std::string bytes) {
  return std::make_unique<OffDocument>(std::move(bytes));
}

}  // namespace hwffd
