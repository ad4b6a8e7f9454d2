#include "geometry.hpp"

#include <fmt/format.h>

#include <fstream>
#include <iostream>

#include "hwffd/error.hpp"
#include "outputs.hpp"
#include "points_file.hpp"

namespace hwffd::command {

namespace fs = std::filesystem;

Geometry Geometry::read(const std::string& name) {
  Geometry geometry;
  geometry.name_ = name == "-" ? "standard input" : name;
  if (name == "-") {
    geometry.points_ = read_points(std::cin, geometry.name_);
  } else if (names_points(name)) {
    std::ifstream file(name);
    if (!file || fs::is_directory(name)) {
      throw Error(fmt::format("{}: cannot be read; check the name", name));
    }
    geometry.points_ = read_points(file, name);
  } else {
    geometry.mesh_.emplace(Mesh::load(find_model(name)));
  }
  return geometry;
}

std::vector<Mesh::Triangle> Geometry::triangles() const {
  return is_mesh() ? mesh_->triangles() : std::vector<Mesh::Triangle>{};
}

void Geometry::move(const Points& positions, const std::vector<Eigen::Matrix3d>& gradients) {
  if (is_mesh()) {
    if (gradients.empty()) {
      mesh_->set_positions(positions);
    } else {
      mesh_->set_positions(positions, gradients);
    }
  } else {
    points_ = positions;
  }
}

std::vector<std::string> Geometry::write(const std::string& path) const {
  if (is_mesh()) return mesh_->save(path);
  write_output(path, points_text(points_, path));
  return {};
}

void check_format(const std::string& input, const std::string& output) {
  if (names_points(input)) return check_points_format(output);
  if (output == "-") {
    throw UsageError("--output -: standard output takes points only; name a mesh file");
  }
  Mesh::check_format(output);
}

}  // namespace hwffd::command
