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

/// Points as text, one "x y z" a line, n x 3. Blank lines, what follows a #, and the mark with
/// which some programs begin UTF-8 are skipped; commas and semicolons count as blanks.
/// @param name  of the text, for messages
/// @throws Error for a line that is not three finite numbers, and for no points
Points read_points(std::istream& in, const std::string& name);

/// A number a line, in the same way.
/// @throws Error for a line that is not one finite number, and for none
std::vector<double> read_column(std::istream& in, const std::string& name);

/// Points as a file of that name holds them: ply where it ends so, else text.
std::string points_text(const Points& points, const std::filesystem::path& path);

/// @throws UsageError for a name whose extension is of a format that holds meshes only
void check_points_format(const std::filesystem::path& path);

}  // namespace hwffd::command
