#pragma once

#include <filesystem>
#include <istream>
#include <optional>
#include <string>
#include <vector>

#include "hwffd/atomic_file.hpp"
#include "hwffd/mesh/mesh.hpp"

namespace hwffd::command {

/// Points as text, one "x y z" a line, n x 3. Blank lines and what follows a # are skipped; commas
/// and semicolons count as blanks.
/// @param name  of the text, for messages
/// @throws Error for a line that is not three finite numbers, and for no points
Points read_points(std::istream& in, const std::string& name);

/// What a command moves: a mesh, or bare points.
class Geometry {
 public:
  /// @param name  a mesh file or a name in glmark2's models (find_model); a file that ends in .xyz,
  ///              or "-" for standard input: read_points
  /// @throws Error for what is no mesh or no points
  static Geometry read(const std::string& name);

  const std::string& name() const { return name_; }
  bool is_mesh() const { return mesh_.has_value(); }
  const Mesh& mesh() const { return *mesh_; }
  const Points& positions() const { return is_mesh() ? mesh_->positions() : points_; }
  /// Of the mesh; none for points.
  std::vector<Mesh::Triangle> triangles() const;

  /// Moves a mesh's vertices and turns its normals, or the points (Mesh::set_positions).
  void move(const Points& positions, const std::vector<Eigen::Matrix3d>& gradients);

  /// Writes the mesh in the format of the extension, or the points as text; "-" is standard output,
  /// for points only. Whole or not at all.
  /// @throws UsageError for a mesh to standard output, Error for what cannot be written
  void write(const std::filesystem::path& path) const;

 private:
  std::string name_;
  std::optional<Mesh> mesh_;
  Points points_;
};

}  // namespace hwffd::command
