#include "scene.hpp"

#include <cmath>
#include <filesystem>
#include <utility>

#include "hwffd/error.hpp"
#include "hwffd/oracle/oracle.hpp"

namespace hwffd::sim {
namespace {

constexpr double kDegree = 3.14159265358979323846 / 180;

Mesh load_model(const std::string& name) {
  if (!name.empty()) return Mesh::load(find_model(name));
  try {
    return Mesh::load(find_model("cat.3ds"));
  } catch (const Error&) {
    return Mesh::procedural();
  }
}

}  // namespace

Scene make_scene(const std::string& model, const Index3& dims) {
  Mesh mesh = load_model(model);
  const Box box = Box::around(mesh.positions());
  std::vector<Embedded> vertices = box.embed(dims, mesh.positions());
  return {std::move(mesh), box.lattice(dims), std::move(vertices)};
}

Deformed deform(const Scene& scene, const std::string& deformation) {
  Deformed deformed{deformation, Deformation::parse(deformation).apply(scene.lattice), {}};
  deformed.exact.resize(static_cast<Eigen::Index>(scene.vertices.size()), 3);
  const Oracle oracle;
  for (std::size_t v = 0; v < scene.vertices.size(); ++v) {
    const Embedded& vertex = scene.vertices[v];
    deformed.exact.row(static_cast<Eigen::Index>(v)) = oracle.evaluate(
        deformed.lattice.support(vertex.cell), vertex.local[0], vertex.local[1], vertex.local[2]);
  }
  return deformed;
}

double twist_of_cells(double degrees, int points) {
  const auto angle_at = [&](double height) {
    const double x = 1 - height + height * std::cos(degrees * kDegree);
    const double y = height * std::sin(degrees * kDegree);
    return std::atan2(y, x) / kDegree;
  };
  const double margin = 1.0 / (points - 1);
  return angle_at(1 - margin) - angle_at(margin);
}

}  // namespace hwffd::sim
