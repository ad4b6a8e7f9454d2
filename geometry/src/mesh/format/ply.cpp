#include "mesh/format/ply.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "hwffd/error.hpp"
#include "hwffd/mesh/extension.hpp"
#include "mesh/format/text.hpp"
#include "mesh/relocated.hpp"

namespace hwffd {
namespace {

namespace fs = std::filesystem;

/// A copy of the data in which values are replaced, in their order: words of a text, or numbers,
/// whose size stays.
class PlyCopy {
 public:
  PlyCopy(const std::string& bytes, bool is_text) : bytes_(bytes) {
    if (is_text) {
      text_ = std::make_unique<Replacement>(bytes);
    } else {
      copy_ = bytes;
    }
  }

  void replace(std::string_view value, std::string_view with) {
    if (value == with) return;
    if (text_) {
      text_->replace(value, with);
    } else {
      std::copy(with.begin(), with.end(), copy_.begin() + (value.data() - bytes_.data()));
    }
  }

  std::string take() { return text_ ? text_->take() : std::move(copy_); }

 private:
  const std::string& bytes_;
  std::unique_ptr<Replacement> text_;
  std::string copy_;
};

/// The place, among so many corners, of the one that comes to place c when a face is turned round.
std::size_t turned(std::size_t c, std::size_t corners) { return c == 0 ? 0 : corners - c; }

/// Goes over the file once more and puts in what changed.
class PlyEditor {
 public:
  PlyEditor(const std::string& bytes, const PlyHeader& header, const Edit& edit)
      : header_(header),
        edit_(edit),
        cursor_(bytes, header),
        copy_(bytes, header.format == PlyHeader::Format::kText) {}

  std::string edited() {
    bool has_vertices = false;
    for (const PlyElement& element : header_.elements) {
      if (has_vertices && !edit_.turned) break;
      const bool is_vertex = element.name == "vertex" && !has_vertices;
      const PlyVertex vertex(element);
      for (std::uint64_t row = 0; row < element.rows; ++row) {
        if (is_vertex) {
          edit_vertex(element, vertex, row);
        } else {
          for (const PlyProperty& property : element.properties) edit_face(element, property);
        }
      }
      has_vertices = has_vertices || is_vertex;
    }
    return copy_.take();
  }

 private:
  void edit_vertex(const PlyElement& element, const PlyVertex& vertex, std::size_t row) {
    const Eigen::RowVector3d position = edit_.position(row);
    const bool has_normals = !edit_.normals.empty();
    for (std::size_t p = 0; p < element.properties.size(); ++p) {
      const PlyProperty& property = element.properties[p];
      const std::size_t place = vertex.places()[p];
      if (place < PlyVertex::kNormal) {
        put(property.value, position[static_cast<Eigen::Index>(place)]);
      } else if (place < PlyVertex::kTexture && has_normals) {
        put_normal(property.value, row, place - PlyVertex::kNormal);
      } else {
        cursor_.skip(property);
      }
    }
  }

  void put(const PlyType& type, double now) {
    const std::string_view value = cursor_.take(type);
    const double read = cursor_.number(value, type);
    const bool is_single = !type.is_integer() && type.size == sizeof(float);
    const double to = is_single ? static_cast<double>(static_cast<float>(now)) : now;
    if (read != to) copy_.replace(value, cursor_.bytes_of(to, type));
  }

  void put_normal(const PlyType& type, std::size_t row, std::size_t axis) {
    const std::string_view value = cursor_.take(type);
    const float now =
        edit_.normals.rows(static_cast<Eigen::Index>(row), static_cast<Eigen::Index>(axis));
    if (static_cast<float>(cursor_.number(value, type)) == now || std::isnan(now)) return;
    copy_.replace(value, cursor_.bytes_of(now, type));
  }

  /// A property of an element that is no vertex: corners are turned round, if they are to be.
  void edit_face(const PlyElement& element, const PlyProperty& property) {
    const bool is_face = element.name == "face" && is_ply_corners(property);
    const bool is_texture = element.name == "face" && is_ply_textures(property);
    const bool is_strip = element.name == "tristrips" && is_ply_corners(property);
    if (!edit_.turned || !(is_face || is_texture || is_strip)) return cursor_.skip(property);
    values_.clear();
    for (std::uint64_t count = cursor_.take_count(property); count > 0; --count) {
      values_.push_back(cursor_.take(property.value));
    }
    if (is_strip) return turn_strips(property);
    const std::size_t each = is_texture ? 2 : 1;
    const std::size_t corners = values_.size() / each;
    for (std::size_t v = 0; corners > 2 && v < corners * each; ++v) {
      copy_.replace(values_[v], values_[turned(v / each, corners) * each + v % each]);
    }
  }

  /// Backwards a strip of an odd number of vertices has the same triangles, turned round.
  void turn_strips(const PlyProperty& property) {
    std::size_t first = 0;
    for (std::size_t end = 0; end <= values_.size(); ++end) {
      const bool ends = end == values_.size() || cursor_.number(values_[end], property.value) < 0;
      if (!ends) continue;
      const std::size_t vertices = end - first;
      if (vertices > 2 && vertices % 2 == 0) {
        throw Error(fmt::format(
            "a strip of {} vertices cannot be turned round, as a mirror wants it; write another "
            "format",
            vertices));
      }
      for (std::size_t v = 0; vertices > 2 && v < vertices; ++v) {
        copy_.replace(values_[first + v], values_[end - 1 - v]);
      }
      first = end + 1;
    }
  }

  const PlyHeader& header_;
  const Edit& edit_;
  PlyCursor cursor_;
  PlyCopy copy_;
  std::vector<std::string_view> values_;
};

class PlyDocument : public Document {
 public:
  PlyDocument(const fs::path& path, std::string bytes)
      : folder_(fs::absolute(path).parent_path()),
        bytes_(std::move(bytes)),
        header_(ply_header(bytes_)) {
    read_ply_content(bytes_, header_, content_);
  }

  bool is_of(const fs::path& path) const override { return extension_of(path) == ".ply"; }

  Files edited(const Edit& edit, const fs::path& path) const override {
    std::string bytes = edit_ply(bytes_, header_, edit);
    if (!header_.textures.empty()) bytes = with_textures_found(bytes, path);
    Files files;
    files.emplace(path.filename().string(), std::move(bytes));
    return files;
  }

 private:
  /// The file with names of textures that are found from the folder of `path`.
  std::string with_textures_found(const std::string& bytes, const fs::path& path) const {
    Replacement text(bytes);
    for (const PlyHeader::Texture& texture : header_.textures) {
      const std::string_view name = std::string_view(bytes).substr(texture.at, texture.name.size());
      const std::string now = relocated(texture.name, folder_, path);
      if (now != name) text.replace(name, now);
    }
    return text.take();
  }

  fs::path folder_;
  std::string bytes_;
  PlyHeader header_;
};

}  // namespace

std::string edit_ply(const std::string& bytes, const PlyHeader& header, const Edit& edit) {
  return PlyEditor(bytes, header, edit).edited();
}

std::unique_ptr<Document> read_ply(const fs::path& path, std::string bytes) {
  return std::make_unique<PlyDocument>(path, std::move(bytes));
}

}  // namespace hwffd
