#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "mesh/format/document.hpp"
#include "mesh/format/text.hpp"

namespace hwffd {

/// Lines of an obj file.
inline constexpr auto kObjLines = LineReader::Continuation::kBackslash;

/// @throws Error that names the line
[[noreturn]] void refuse_line(const LineReader& lines, const std::string& what);

/// The coordinates of a vertex or a normal.
struct ObjVector {
  std::array<std::string_view, 3> words;
  std::array<TextNumber, 3> numbers;
  double weight = 1;  ///< that they are divided by

  double value(std::size_t axis) const { return numbers[axis].value / weight; }
};

/// Of the line of a normal.
/// @throws Error as refuse_line(), here and below
ObjVector obj_normal(const LineReader& lines);

/// Of the line of a vertex, which may have a weight or a colour behind its coordinates.
ObjVector obj_vertex(const LineReader& lines);

/// A corner of a face as it is written: numbers from 1, or from the last backwards; 0: none.
struct ObjCorner {
  std::array<std::int64_t, 3> numbers{0, 0, 0};  ///< of vertex, texture coordinates, normal
  std::string_view normal;                       ///< the word of the last
};

ObjCorner obj_corner(const LineReader& lines, std::string_view word);

/// Whether a line that begins so has corners: a face, a line or points.
bool is_obj_element(std::string_view keyword);

/// Corners in the content of such a line with so many words behind the first: lines are cut.
std::size_t corners_of_obj_element(std::string_view keyword, std::size_t words);

/// What the file and its libraries hold.
/// @param companions  the libraries
/// @throws Error, without the file's name, for what is no such file
void read_obj_content(const std::filesystem::path& path, const std::string& bytes, Content& content,
                      std::vector<std::filesystem::path>& companions);

/// The file with what changed.
/// @param is_single  whether its coordinates are (Content)
/// @param normals    rows of normals that were read
/// @param folder     that names of libraries start from, and
/// @param path       where the file will be
std::string edit_obj(const std::string& bytes, bool is_single, std::size_t normals,
                     const Edit& edit, const std::filesystem::path& folder,
                     const std::filesystem::path& path);

}  // namespace hwffd
