#include "geometry.hpp"

#include <fmt/format.h>

#include <fstream>
#include <iostream>

#include "hwffd/error.hpp"
#include "hwffd/mesh/extension.hpp"
#include "hwffd/mesh/mesh.hpp"
#include "outputs.hpp"

namespace hwffd::command {

namespace fs = std::filesystem;

Geometry Geometry::read(const std::string& name) {
  Geometry geometry;
  geometry.name_ = name == "-" ? "standard input" : name;
  if (name == "-") {
    geometry.file_.emplace(std::cin, geometry.name_);
  } else if (names_points(name)) {
    std::ifstream file(name);
    if (!file || fs::is_directory(name)) {
      throw Error(fmt::format("{}: cannot be read; check the name", name));
    }
    geometry.file_.emplace(file, name);
  } else {
    geometry.mesh_.emplace(Mesh::load(find_model(name)));
  }
  if (geometry.file_) geometry.points_ = geometry.file_->points();
  return geometry;
}

const std::vector<Mesh::Triangle>& Geometry::triangles() const {
  static const std::vector<Mesh::Triangle> none;
  return is_mesh() ? mesh_->triangles() : none;
}

void Geometry::move(const Points& positions, const std::vector<Eigen::Matrix3d>& gradients) {
  if (is_mesh()) {
    if (gradients.empty()) {
      mesh_->set_positions(positions);
    } else {
      mesh_->set_positions(positions, gradients);
    }
  } else {
    points_ = settled(positions, file_->points());
  }
}

std::vector<std::string> Geometry::write(const std::string& path) const {
  if (is_mesh()) return mesh_->save(path);
  const bool is_edit = extension_of(path) == ".xyz" && extension_of(name_) == ".xyz";
  write_output(path, is_edit ? file_->edited(points_) : points_text(points_, path));
  if (is_edit || !file_->has_more()) return {};
  return {"columns behind x y z"};
}

void check_format(const std::string& input, const std::string& output) {
  if (names_points(input)) return check_points_format(output);
  if (output == "-") {
    throw UsageError("--output -: standard output takes points only; name a mesh file");
  }
  Mesh::check_format(output);
}

}  // namespace hwffd::command
