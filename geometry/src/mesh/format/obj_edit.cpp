#include <algorithm>
#include <cmath>
#include <system_error>
#include <utility>

#include "mesh/format/obj_syntax.hpp"
#include "mesh/relocated.hpp"

namespace hwffd {
namespace {

namespace fs = std::filesystem;

/// The normals of an edited file: which stand where, and what they are called.
class ObjNormals {
 public:
  ObjNormals(const Edit& edit, std::size_t rows) : edit_(edit), further_(rows), numbers_(rows) {
    place_of_.reserve(static_cast<std::size_t>(edit.normals.rows.rows()));
    for (std::uint32_t row = 0; row < rows; ++row) place_of_.emplace_back(row, 0);
    for (std::uint32_t extra = 0; extra < edit.normal_origins.size(); ++extra) {
      place_of_.push_back(
          place(edit.normal_origins[extra], static_cast<std::uint32_t>(rows) + extra));
    }
    std::size_t number = 0;
    for (std::size_t row = 0; row < rows; ++row) {
      numbers_[row] = number;
      number += 1 + further_[row].size();
    }
    is_as_read_ = number == rows;
  }

  /// Whether each row stands where it stood, and corners refer to it as they did.
  bool is_as_read() const { return is_as_read_; }

  /// Rows that stand behind this one, in lines of their own.
  const std::vector<std::uint32_t>& further(std::size_t row) const { return further_[row]; }

  /// The number, from 0, of a row of the edit.
  std::size_t number(std::uint32_t row) const {
    const auto& [origin, step] = place_of_[row];
    return numbers_[origin] + step;
  }

  /// How many there are in front of a row that was read.
  std::size_t before(std::size_t row) const {
    return row < numbers_.size() ? numbers_[row] : numbers_.back() + 1 + further_.back().size();
  }

 private:
  std::pair<std::uint32_t, std::uint32_t> place(std::uint32_t origin, std::uint32_t row) {
    const auto same = [&](std::uint32_t other) {
      const bool are_none =
          std::isnan(edit_.normals.rows(other, 0)) && std::isnan(edit_.normals.rows(row, 0));
      return are_none || edit_.normals.rows.row(other) == edit_.normals.rows.row(row);
    };
    if (same(origin)) return {origin, 0};
    std::vector<std::uint32_t>& further = further_[origin];
    // Few differ as a rule; where many do, a search among all of them would take too long.
    constexpr std::size_t kSearched = 16;
    const std::size_t first = further.size() > kSearched ? further.size() - kSearched : 0;
    std::size_t step = first;
    while (step < further.size() && !same(further[step])) ++step;
    if (step == further.size()) further.push_back(row);
    return {origin, static_cast<std::uint32_t>(step + 1)};
  }

  const Edit& edit_;
  std::vector<std::vector<std::uint32_t>> further_;
  std::vector<std::size_t> numbers_;                               ///< of rows that were read
  std::vector<std::pair<std::uint32_t, std::uint32_t>> place_of_;  ///< origin, and steps behind it
  bool is_as_read_ = true;
};

/// Goes over the file once more and puts in what changed.
class ObjEditor {
 public:
  ObjEditor(const std::string& bytes, bool is_single, std::size_t normals, const Edit& edit)
      : bytes_(bytes), is_single_(is_single), edit_(edit), normals_(edit, normals), text_(bytes) {}

  /// @param folder  that names of libraries start from, and
  /// @param path    where the file will be
  std::string edited(const fs::path& folder, const fs::path& path) {
    LineReader lines(bytes_, kObjLines);
    while (lines.next()) {
      if (lines.words().empty()) continue;
      const std::string_view keyword = lines.words()[0];
      if (keyword == "v") edit_vertex(lines);
      if (keyword == "vn") edit_normal(lines);
      if (keyword == "mtllib") edit_libraries(lines, folder, path);
      if (is_obj_element(keyword)) edit_element(lines);
    }
    return text_.take();
  }

 private:
  void edit_vertex(const LineReader& lines) {
    const ObjVector vertex = obj_vertex(lines);
    const Eigen::RowVector3d now = edit_.position(vertices_++);
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const double read = is_single_ ? static_cast<float>(vertex.value(axis)) : vertex.value(axis);
      const double to = now[static_cast<Eigen::Index>(axis)];
      if (read == to) continue;
      std::string number;
      append_number(number, to * vertex.weight, is_single_ && vertex.weight == 1);
      text_.replace(vertex.words[axis], number);
    }
  }

  void edit_normal(const LineReader& lines) {
    const ObjVector normal = obj_normal(lines);
    const std::size_t row = row_++;
    if (edit_.normals.empty()) return;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      text_.replace_number(normal.words[axis], static_cast<float>(normal.value(axis)),
                           value(row, axis), true);
    }
    for (const std::uint32_t further : normals_.further(row)) {
      std::string line = lines.ending().empty() ? "\n" : "";
      line += "vn";
      for (std::size_t axis = 0; axis < 3; ++axis) {
        line += ' ';
        append_number(line, value(further, axis), true);
      }
      text_.insert(lines.end(), line.append(lines.ending()));
    }
  }

  double value(std::size_t row, std::size_t axis) const {
    return edit_.normals.rows(static_cast<Eigen::Index>(row), static_cast<Eigen::Index>(axis));
  }

  /// The corners of a face, turned round if they are to be, with the numbers of their normals.
  void edit_element(const LineReader& lines) {
    const std::vector<std::string_view>& words = lines.words();
    const std::size_t first = corner_;
    const std::size_t count = words.size() - 1;
    corner_ += corners_of_obj_element(words[0], count);
    const bool is_turned = edit_.turned && words[0] == "f" && count > 2;
    const bool is_renumbered = !normals_.is_as_read() && words[0] == "f";
    if (!is_turned && !is_renumbered) return;
    for (std::size_t c = 0; c < count; ++c) {
      const std::size_t from = is_turned && c > 0 ? count - c : c;
      const std::string word = is_renumbered ? renumbered(lines, words[1 + from], first + from)
                                             : std::string(words[1 + from]);
      if (word != words[1 + c]) text_.replace(words[1 + c], word);
    }
  }

  std::string renumbered(const LineReader& lines, std::string_view word, std::size_t corner) const {
    const ObjCorner read = obj_corner(lines, word);
    if (read.numbers[2] == 0) return std::string(word);
    const std::size_t number = normals_.number(edit_.normals.of_corner[corner]);
    const auto written = read.numbers[2] > 0 ? static_cast<std::int64_t>(number) + 1
                                             : static_cast<std::int64_t>(number) -
                                                   static_cast<std::int64_t>(normals_.before(row_));
    std::string text(word.substr(0, static_cast<std::size_t>(read.normal.data() - word.data())));
    return text + std::to_string(written);
  }

  /// Libraries are found from the file's new folder, too. Of several names each gets a line of its
  /// own, since folders on the way may have blanks.
  void edit_libraries(const LineReader& lines, const fs::path& folder, const fs::path& path) {
    const auto is_file = [&](std::string_view name) {
      std::error_code ignored;
      return !name.empty() && fs::is_regular_file(folder / name, ignored);
    };
    const std::vector<std::string_view>& words = lines.words();
    std::vector<std::string_view> names{lines.from(1)};
    if (!is_file(names[0])) names.assign(words.begin() + 1, words.end());
    std::vector<std::string> now;
    for (const std::string_view name : names) {
      now.push_back(is_file(name) ? relocated(std::string(name), folder, path) : std::string(name));
    }
    if (std::equal(names.begin(), names.end(), now.begin(), now.end())) return;
    const std::string ending(lines.ending().empty() ? "\n" : lines.ending());
    for (std::size_t n = 0; n < names.size(); ++n) {
      text_.replace(names[n], n == 0 ? now[n] : ending + "mtllib " + now[n]);
    }
  }

  const std::string& bytes_;
  bool is_single_;
  const Edit& edit_;
  ObjNormals normals_;
  Replacement text_;
  std::size_t vertices_ = 0;
  std::size_t row_ = 0;     ///< of normals
  std::size_t corner_ = 0;  ///< of the content
};

}  // namespace

std::string edit_obj(const std::string& bytes, bool is_single, std::size_t normals,
                     const Edit& edit, const fs::path& folder, const fs::path& path) {
  return ObjEditor(bytes, is_single, normals, edit).edited(folder, path);
}

}  // namespace hwffd
