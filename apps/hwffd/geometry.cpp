#include "geometry.hpp"

#include <fmt/format.h>

#include <charconv>
#include <cmath>
#include <cstdio>
#include <fstream>
#include <iostream>
#include <string_view>

#include "hwffd/error.hpp"

namespace hwffd::command {
namespace {

namespace fs = std::filesystem;

bool is_blank(char c) { return c == ' ' || c == '\t' || c == '\r' || c == ',' || c == ';'; }

/// The numbers of a line; false where something else stands there.
bool read_numbers(std::string_view line, std::vector<double>& numbers) {
  numbers.clear();
  line = line.substr(0, line.find('#'));
  while (true) {
    while (!line.empty() && is_blank(line.front())) line.remove_prefix(1);
    if (line.empty()) return true;
    if (line.front() == '+') line.remove_prefix(1);
    double value = 0;
    const auto [next, error] = std::from_chars(line.data(), line.data() + line.size(), value);
    if (error != std::errc() || !std::isfinite(value)) return false;
    line.remove_prefix(static_cast<std::size_t>(next - line.data()));
    if (!line.empty() && !is_blank(line.front())) return false;
    numbers.push_back(value);
  }
}

std::string points_text(const Points& points) {
  std::string text;
  for (Eigen::Index i = 0; i < points.rows(); ++i) {
    text += fmt::format("{} {} {}\n", points(i, 0), points(i, 1), points(i, 2));
  }
  return text;
}

}  // namespace

Points read_points(std::istream& in, const std::string& name) {
  std::vector<double> values;
  std::vector<double> numbers;
  std::string line;
  for (std::size_t number = 1; std::getline(in, line); ++number) {
    const bool good = read_numbers(line, numbers);
    if (good && numbers.empty()) continue;
    if (!good || numbers.size() != 3) {
      throw Error(
          fmt::format("{}: line {} is not x y z, three finite numbers; mend it", name, number));
    }
    values.insert(values.end(), numbers.begin(), numbers.end());
  }
  if (in.bad()) throw Error(fmt::format("{}: cannot be read to its end", name));
  if (values.empty()) throw Error(fmt::format("{}: no points; give lines of x y z", name));
  return Eigen::Map<const Points>(values.data(), static_cast<Eigen::Index>(values.size() / 3), 3);
}

Geometry Geometry::read(const std::string& name) {
  Geometry geometry;
  geometry.name_ = name == "-" ? "standard input" : name;
  if (name == "-") {
    geometry.points_ = read_points(std::cin, geometry.name_);
  } else if (fs::path(name).extension() == ".xyz") {
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
    mesh_->set_positions(positions, gradients);
  } else {
    points_ = positions;
  }
}

void Geometry::write(const fs::path& path) const {
  if (path == "-") {
    if (is_mesh()) {
      throw UsageError("--output -: standard output takes points only; name a mesh file");
    }
    const std::string text = points_text(points_);
    if (std::fwrite(text.data(), 1, text.size(), stdout) != text.size() ||
        std::fflush(stdout) != 0) {
      throw Error("standard output: cannot be written");
    }
  } else if (is_mesh()) {
    mesh_->save(path);
  } else {
    write_files({{path, points_text(points_)}});
  }
}

}  // namespace hwffd::command
