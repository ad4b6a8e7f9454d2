#include <pybind11/stl.h>

#include <memory>
#include <optional>
#include <string>

#include "arguments.hpp"
#include "arrays.hpp"
#include "hwffd/error.hpp"
#include "hwffd/lattice/around.hpp"
#include "hwffd/lattice/few_points.hpp"
#include "hwffd/lattice/shape.hpp"
#include "lattice.hpp"

namespace hwffd::python {
namespace {

/// Rows of numbers, as many as a matrix or region has.
Points read_matrix(const py::object& numbers, const char* name, py::ssize_t rows) {
  const py::array array = py::array::ensure(numbers);
  if (array && array.ndim() == 2 && array.shape(0) == rows && array.shape(1) == 3) {
    return read_points(numbers, name).points();
  }
  throw UsageError(std::string(name) + ": give an array of shape (" + std::to_string(rows) +
                   ", 3)");
}

Eigen::Matrix3d read_axis(const py::object& axis) {
  constexpr const char* kGive = "'x', 'y' or 'z', or a direction";
  if (py::isinstance<py::str>(axis)) {
    const auto name = axis.cast<std::string>();
    for (int a = 0; a < 3; ++a) {
      if (name == std::string(1, "xyz"[a])) return frame_with_axis(Eigen::Vector3d::Unit(a));
    }
  }
  const std::array<double, 3> direction = read_numbers(axis, "axis", kGive);
  return frame_with_axis({direction[0], direction[1], direction[2]});
}

Fit read_fit(const py::object& axis, const py::object& rotation, const py::object& padding) {
  Fit fit;
  fit.frame = read_axis(axis);
  if (!rotation.is_none()) fit.frame = read_matrix(rotation, "rotation", 3) * fit.frame;
  const std::array<double, 3> free = read_number_or_three(padding, "padding", "0 or more");
  fit.padding = {free[0], free[1], free[2]};
  return fit;
}

/// What the shape is to hold.
Points read_held(const py::object& points, const py::object& region, Fit& fit) {
  if (region.is_none() && points.is_none()) {
    throw UsageError("points: give those that the shape is to hold, or a region");
  }
  if (region.is_none()) return read_points(points, "points").points();
  if (!points.is_none()) throw UsageError("points: given beside a region; give one of the two");
  fit.room = 0.0;
  const Points corners = read_matrix(region, "region", 2);
  return corners_of(corners.row(0), corners.row(1));
}

std::unique_ptr<PyLattice> around(const std::string& shape, const py::object& points,
                                  const py::object& numbers, const std::string& family_name,
                                  const py::object& axis, const py::object& rotation,
                                  const py::object& padding, const py::object& region) {
  std::optional<Index3> dims;
  if (!numbers.is_none()) dims = read_integers(numbers, "dims", "(ns, nt, nu)");
  Fit fit = read_fit(axis, rotation, padding);
  const Points held = read_held(points, region, fit);
  const Unlocked unlocked;
  const Family family = Family::parse(family_name);
  return std::make_unique<PyLattice>(
      DeformableLattice(whole(lattice_around(shape, held, dims, family, fit), family), family));
}

}  // namespace

void bind_around(py::class_<PyLattice>& type) {
  type.def_static(
      "around", &around, py::arg("shape"), py::arg("points") = py::none(),
      py::arg("dims") = py::none(), py::kw_only(), py::arg("family") = "bspline",
      py::arg("axis") = "y", py::arg("rotation") = py::none(), py::arg("padding") = 0,
      py::arg("region") = py::none(),
      (shape_list(" or ") +
       " that holds points (..., 3), also as float32, or a region, two corners (2, 3).\n\ndims: "
       "(ns, nt, nu); None: what suits the shape. axis: where its own axis, y of an upright one, "
       "points: x, y, z or a direction; rotation: then a matrix (3, 3) that turns it, or any that "
       "spans a volume. padding: left free beyond what it holds, one number or one along each of "
       "its x, y and z before it is turned.")
          .c_str());
}

}  // namespace hwffd::python
