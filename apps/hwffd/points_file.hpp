#pragma once

#include <filesystem>
#include <istream>
#include <string>
#include <vector>

#include "hwffd/points.hpp"

namespace hwffd::command {

/// Whether a name stands for bare points, not for a mesh: "-", standard input, or a file that ends
/// in .xyz, in capitals or not.
bool names_points(const std::string& name);

/// Points as text, one "x y z" a line. Blank lines, what follows a #, the mark with which some
/// programs begin UTF-8, a first line of names of columns, and columns behind the third are passed
/// over; commas and semicolons count as blanks.
class PointsFile {
 public:
  /// @param name  of the text, for messages
  /// @throws Error for a line that does not begin with three finite numbers, and for no points
  PointsFile(std::istream& in, std::string name);

  const Points& points() const { return points_; }
  /// Whether there are columns behind the third.
  bool has_more() const { return has_more_; }

  /// The text with points in other places, as many: what did not change is as it was.
  std::string edited(const Points& points) const;

 private:
  std::string name_;
  std::string text_;
  Points points_;
  bool has_more_ = false;
};

/// A number a line, with comments and blank lines likewise.
/// @throws Error for a line that is not one finite number, and for none
std::vector<double> read_column(std::istream& in, const std::string& name);

/// Points as a file of that name holds them: ply where it ends so, else text.
std::string points_text(const Points& points, const std::filesystem::path& path);

/// @throws UsageError for a name whose extension is of a format that holds meshes only
void check_points_format(const std::filesystem::path& path);

}  // namespace hwffd::command
