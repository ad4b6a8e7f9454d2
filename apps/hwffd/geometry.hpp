#pragma once

#include <optional>
#include <string>
#include <vector>

#include "hwffd/mesh/mesh.hpp"
#include "points_file.hpp"

namespace hwffd::command {

/// What a command moves: a mesh, or bare points.
class Geometry {
 public:
  /// @param name  points where names_points(), else a mesh file or a name in glmark2's models
  ///              (find_model)
  /// @throws Error for what is no mesh or no points
  static Geometry read(const std::string& name);

  const std::string& name() const { return name_; }
  bool is_mesh() const { return mesh_.has_value(); }
  const Mesh& mesh() const { return *mesh_; }
  const Points& positions() const { return is_mesh() ? mesh_->positions() : points_; }
  /// Of the mesh; none for points.
  const std::vector<Mesh::Triangle>& triangles() const;

  /// Moves a mesh's vertices and turns its normals, or the points (Mesh::set_positions).
  /// @param gradients  of a mesh; if empty normals come from its faces
  void move(const Points& positions, const std::vector<Eigen::Matrix3d>& gradients);

  /// Writes the mesh in the format of the extension, or the points: an .xyz that stays one is
  /// edited, else they are bare (points_text). "-" is standard output, for points only. Whole or
  /// not at all.
  /// @param path  in a format that check_format() passes
  /// @return what of the mesh (Mesh::save) or the points is lost
  /// @throws Error for what cannot be written
  std::vector<std::string> write(const std::string& path) const;

 private:
  std::string name_;
  std::optional<Mesh> mesh_;
  std::optional<PointsFile> file_;  ///< of points
  Points points_;
};

/// Whether what Geometry::read makes of one name can be written under another, before it is read.
/// @throws UsageError for a format that is unknown or does not hold it, and for a mesh to "-"
void check_format(const std::string& input, const std::string& output);

}  // namespace hwffd::command
