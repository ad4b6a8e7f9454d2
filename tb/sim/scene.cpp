#include "scene.hpp"

#include <cmath>
#include <utility>

#include "hwffd/error.hpp"
#include "hwffd/lattice/lattice_evaluator.hpp"

namespace hwffd::sim {
namespace {

constexpr double kDegree = 3.14159265358979323846 / 180;

}  // namespace

Scene make_scene(const std::string& model, const Index3& dims) {
  Mesh mesh = load_model(model);
  const Box box = Box::around(mesh.positions());
  std::vector<Embedded> vertices = box.embed(dims, mesh.positions());
  return {std::move(mesh), box.lattice(dims), std::move(vertices)};
}

Deformed deform(const Scene& scene, const std::string& deformation) {
  Deformed deformed{deformation, Deformation::parse(deformation).apply(scene.lattice), {}};
  const Oracle::Coefficients bspline = Oracle::uniform_bspline();
  deformed.exact = evaluate_in(deformed.lattice, scene.vertices, {bspline, bspline, bspline});
  if (!deformed.exact.allFinite()) {
    throw Error(deformation + ": a position is not finite; move the lattice less far");
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
