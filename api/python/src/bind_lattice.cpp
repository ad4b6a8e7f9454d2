#include <pybind11/eigen.h>
#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

#include <array>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <stdexcept>
#include <tuple>

#include "arrays.hpp"
#include "hwffd/error.hpp"
#include "hwffd/lattice/around.hpp"
#include "hwffd/lattice/fold.hpp"
#include "hwffd/lattice/lattice_file.hpp"
#include "hwffd/lattice/shape.hpp"
#include "lattice.hpp"

namespace hwffd::python {
namespace {

using Holder = std::unique_ptr<PyLattice>;
using Cells = Eigen::Matrix<int, Eigen::Dynamic, 3, Eigen::RowMajor>;

Holder made(const Lattice& rest, const Family& family) {
  return std::make_unique<PyLattice>(DeformableLattice(rest, family));
}

Holder from_points(const Index3& dims, const py::object& points, const std::string& family) {
  Lattice::check_dims(dims);
  const Points read = read_control_points(points, dims);
  const Unlocked unlocked;
  return made(Lattice(dims, read), Family::parse(family));
}

Holder of_grid(const py::object& control_points, const std::string& family) {
  const Read read = read_points(control_points, "control points");
  const Index3 dims = dims_of_grid(read.shape);
  const Unlocked unlocked;
  return made(Lattice(dims, read.points()), Family::parse(family));
}

Holder around(const std::string& shape, const py::object& points, const std::optional<Index3>& dims,
              const std::string& family_name) {
  const Points read = read_points(points, "points").points();
  const Unlocked unlocked;
  const Family family = Family::parse(family_name);
  return made(lattice_around(shape, read, dims, family), family);
}

Holder read(const std::filesystem::path& path, const std::string& family) {
  const Unlocked unlocked;
  return made(read_lattice(path), Family::parse(family));
}

void write(const PyLattice& lattice, const std::filesystem::path& path, bool rest) {
  lattice.alone(
      [&](const DeformableLattice& of) { write_lattice(path, rest ? of.rest() : of.deformed()); });
}

/// A copy of control points that NumPy refuses to write to: what was written there would be lost.
py::array control_points(const PyLattice& lattice, bool rest, bool flat) {
  const Lattice points =
      lattice.alone([&](const DeformableLattice& of) { return rest ? of.rest() : of.deformed(); });
  const Shape shape = flat ? Shape{points.points().rows(), 3} : grid_shape(points.dims());
  return read_only(new_array(shape, points.points().data()));
}

void set_control_points(PyLattice& lattice, const py::object& points) {
  const Index3 dims = lattice.alone([](const DeformableLattice& of) { return of.rest().dims(); });
  const Points read = read_control_points(points, dims);
  lattice.alone([&](DeformableLattice& of) { of.move(read); });
}

/// @throws UsageError for numbers that no grid has
Grid grid_of_places(const std::array<double, 3>& first, const std::array<double, 3>& last,
                    const std::array<int, 3>& counts) {
  try {
    return grid_between(first, last, counts);
  } catch (const std::invalid_argument& error) {
    throw UsageError(std::string("grid: ") + error.what() + "; give places in cells, from 0 on");
  }
}

/// Numbers of cells, n x 3, of any kind of integer: NumPy's own conversion cuts off fractions and
/// high bits without a word.
Cells whole_numbers(const py::object& numbers) {
  const auto cells = py::array::ensure(numbers);
  if (!cells) PyErr_Clear();
  const char kind = cells ? cells.dtype().kind() : '-';
  if ((kind != 'i' && kind != 'u') || cells.ndim() != 2 || cells.shape(1) != 3) {
    throw UsageError("cells: no integers, n x 3; give them as embed() does");
  }
  Cells result(cells.shape(0), 3);
  const auto wide = py::array_t<std::int64_t>::ensure(cells);
  for (Eigen::Index i = 0; i < result.rows(); ++i) {
    for (Eigen::Index axis = 0; axis < 3; ++axis) {
      const std::int64_t number = wide.at(i, axis);
      if (number < 0 || number >= Lattice::kMaxPoints) {
        throw Error("cells: " + std::to_string(number) + " in row " + std::to_string(i) +
                    "; give 0 to " + std::to_string(Lattice::kMaxPoints - 4));
      }
      result(i, axis) = static_cast<int>(number);
    }
  }
  return result;
}

py::array evaluate(PyLattice& lattice, const py::object& numbers, const py::object& local,
                   const py::object& out) {
  const Cells cells = whole_numbers(numbers);
  const Points places = read_rows(local, "local", cells.rows());
  std::vector<Embedded> vertices(static_cast<std::size_t>(cells.rows()));
  for (Eigen::Index i = 0; i < cells.rows(); ++i) {
    Embedded& vertex = vertices[static_cast<std::size_t>(i)];
    vertex.cell = {cells(i, 0), cells(i, 1), cells(i, 2)};
    vertex.local = places.row(i);
  }
  const Target target(out, {cells.rows(), 3}, false);
  return target.take(
      lattice.alone([&](DeformableLattice& of) { return of.evaluate(std::move(vertices)); }));
}

py::array evaluate_grid(PyLattice& lattice, const std::array<double, 3>& first,
                        const std::array<double, 3>& last, const std::array<int, 3>& counts,
                        const py::object& out) {
  const Grid grid = grid_of_places(first, last, counts);
  const Target target(out, {counts[2], counts[1], counts[0], 3}, false);
  return target.take(lattice.alone([&](DeformableLattice& of) { return of.evaluate_grid(grid); }));
}

void set_device(PyLattice& lattice, const std::string& device, const std::string& org,
                const std::string& format, int pages, int axis_points) {
  lattice.alone([&](DeformableLattice& of) {
    of.set_device({device, org, format, pages, axis_points});
  });
}

void set_outside(PyLattice& lattice, const std::string& outside) {
  lattice.alone([&](DeformableLattice& of) {
    of.set_outside(outside);
    lattice.outside = outside;
  });
}

/// All that a lattice is, for pickle and copy.
py::tuple state_of_lattice(const PyLattice& lattice) {
  const auto [rest, deformed, family, outside,
              choice] = lattice.alone([&](const DeformableLattice& of) {
    return std::tuple(of.rest(), of.deformed(), of.family().name(), lattice.outside, of.choice());
  });
  const Shape shape = grid_shape(rest.dims());
  return py::make_tuple(new_array(shape, rest.points().data()),
                        new_array(shape, deformed.points().data()), family, outside, choice.device,
                        choice.org, choice.format, choice.pages, choice.axis_points);
}

Holder lattice_from(const py::tuple& state) {
  if (state.size() != 9) throw Error("this pickle holds no lattice; pickle one again");
  Holder lattice = of_grid(state[0], state[2].cast<std::string>());
  set_control_points(*lattice, state[1]);
  set_outside(*lattice, state[3].cast<std::string>());
  set_device(*lattice, state[4].cast<std::string>(), state[5].cast<std::string>(),
             state[6].cast<std::string>(), state[7].cast<int>(), state[8].cast<int>());
  return lattice;
}

template <typename Get>
auto getter(const Get& get) {
  return [get](const PyLattice& lattice) { return lattice.alone(get); };
}

void bind_making(py::class_<PyLattice>& type) {
  type.def(py::init(&from_points), py::arg("dims"), py::arg("points"), py::kw_only(),
           py::arg("family") = "bspline",
           "A lattice from control points.\n\ndims: (ns, nt, nu), 4 to 64 each. points: (ns, nt, "
           "nu, 3) or (ns*nt*nu, 3), point (i, j, k) in row (i*nt + j)*nu + k.")
      .def_static("of", &of_grid, py::arg("control_points"), py::kw_only(),
                  py::arg("family") = "bspline", "A lattice from control points (ns, nt, nu, 3).")
      .def_static("around", &around, py::arg("shape"), py::arg("points"),
                  py::arg("dims") = py::none(), py::kw_only(), py::arg("family") = "bspline",
                  (shape_list(" or ") +
                   " that holds points (..., 3), also as float32. dims: (ns, nt, nu); None: what "
                   "suits the shape.")
                      .c_str())
      .def_static("read", &read, py::arg("path"), py::kw_only(), py::arg("family") = "bspline",
                  "A lattice file (docs/lattice.md section 3).")
      .def("write", &write, py::arg("path"), py::kw_only(), py::arg("rest") = false,
           "Writes the control points, as deformed or at rest, as a lattice file.")
      .def(py::pickle(&state_of_lattice, &lattice_from))
      .def("__copy__",
           [](const PyLattice& lattice) { return lattice_from(state_of_lattice(lattice)); })
      .def(
          "__deepcopy__",
          [](const PyLattice& lattice, const py::dict&) {
            return lattice_from(state_of_lattice(lattice));
          },
          py::arg("memo"));
}

void bind_properties(py::class_<PyLattice>& type) {
  type.def_property_readonly("dims",
                             getter([](const DeformableLattice& of) { return of.rest().dims(); }),
                             "[ns, nt, nu], control points an axis")
      .def_property_readonly("cells", getter([](const DeformableLattice& of) {
                               return of.family().cells(of.rest().dims());
                             }),
                             "cells an axis")
      .def_property(
          "control_points",
          [](const PyLattice& lattice) { return control_points(lattice, false, false); },
          &set_control_points,
          "(ns, nt, nu, 3), as deformed: a copy that cannot be written to. Set all of them.")
      .def_property_readonly(
          "rest_points",
          [](const PyLattice& lattice) { return control_points(lattice, true, false); },
          "(ns, nt, nu, 3), at rest: a copy that cannot be written to")
      .def_property(
          "points", [](const PyLattice& lattice) { return control_points(lattice, false, true); },
          &set_control_points, "control_points as (ns*nt*nu, 3)")
      .def_property_readonly(
          "rest", [](const PyLattice& lattice) { return control_points(lattice, true, true); },
          "rest_points as (ns*nt*nu, 3)")
      .def_property_readonly("family",
                             getter([](const DeformableLattice& of) { return of.family().name(); }),
                             "the name of its blending functions")
      .def_property_readonly("device",
                             getter([](const DeformableLattice& of) { return of.device().name(); }),
                             "what evaluates, as \"model basic-fp32-overlapped\"")
      .def_property_readonly(
          "outside", getter([](const DeformableLattice& of) { return of.summary().outside; }),
          "how many points of the last deform() lay outside the cells")
      .def("__repr__", [](const PyLattice& lattice) {
        const auto [dims, family, device] = lattice.alone([](const DeformableLattice& of) {
          return std::tuple(of.rest().dims(), of.family().name(), of.device().name());
        });
        return "<hwffd.Lattice " + std::to_string(dims[0]) + " x " + std::to_string(dims[1]) +
               " x " + std::to_string(dims[2]) + " " + family + ", " + device + ">";
      });
}

}  // namespace

void bind_lattice(py::module_& module) {
  py::class_<PyLattice> type(
      module, "Lattice",
      "Control points at rest and deformed, and the device that evaluates them. Several threads "
      "may use one: they wait for each other.");
  bind_making(type);
  bind_properties(type);
  type.def(
          "deform",
          [](PyLattice& lattice, const std::string& deformation) {
            lattice.alone([&](DeformableLattice& of) { of.deform(deformation); });
          },
          py::arg("deformation"), "Moves the control points further, as \"twist:90\" says.")
      .def("folds", getter([](const DeformableLattice& of) {
             return check_folds(of.deformed(), kFoldDepth, of.family()).text();
           }),
           "Whether the deformed lattice folds space: \"proved\" not to, or where.")
      .def("set_device", &set_device, py::arg("device"), py::arg("org") = "basic",
           py::arg("format") = "", py::arg("pages") = 0, py::arg("axis_points") = kAxisPoints,
           "model, rtl or reference; pages and axis_points are those of a model's core: lattices "
           "that it keeps, and most points of one along an axis")
      .def("set_outside", &set_outside, py::arg("outside"),
           "What points outside do: keep, clamp or fade:WIDTH.")
      .def("embed", &embed, py::arg("points"),
           "Points (..., 3), embedded in the lattice at rest: an Embedding, to be deformed again "
           "and again.")
      .def("evaluate", &evaluate, py::arg("cells"), py::arg("local"), py::kw_only(),
           py::arg("out") = py::none(),
           "Points (n, 3) of the deformed lattice at cells (n, 3), integers, and local coordinates "
           "(n, 3), which are clamped to [0, 1].")
      .def("evaluate_grid", &evaluate_grid, py::arg("first"), py::arg("last"), py::arg("counts"),
           py::kw_only(), py::arg("out") = py::none(),
           "Points (cu, ct, cs, 3) of the deformed lattice on the regular grid of counts (cs, ct, "
           "cu) vertices from place first to place last, (s, t, u) in cells from the first face "
           "on. Coordinates in a cell have 24 bits, as the grids of a core do.");
}

}  // namespace hwffd::python
