#include <pybind11/eigen.h>
#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

#include <array>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <stdexcept>
#include <tuple>

#include "arguments.hpp"
#include "arrays.hpp"
#include "hwffd/error.hpp"
#include "hwffd/lattice/coordinates.hpp"
#include "hwffd/lattice/few_points.hpp"
#include "hwffd/lattice/fold.hpp"
#include "hwffd/lattice/lattice_file.hpp"
#include "hwffd/lattice/shape.hpp"
#include "lattice.hpp"

namespace hwffd::python {
namespace {

using Holder = std::unique_ptr<PyLattice>;
using Cells = Eigen::Matrix<int, Eigen::Dynamic, 3, Eigen::RowMajor>;

Holder held(const Lattice& rest, const Family& family) {
  return std::make_unique<PyLattice>(DeformableLattice(whole(rest, family), family));
}

constexpr const char* kDims = "(ns, nt, nu)";

Holder from_points(const py::object& numbers, const py::object& points,
                   const std::string& family_name) {
  const Index3 dims = read_integers(numbers, "dims", kDims);
  const Family family = Family::parse(family_name);
  whole_dims(dims, family);
  const Points read = read_control_points(points, dims);
  const Unlocked unlocked;
  return held(Lattice(dims, read), family);
}

Holder of_grid(const py::object& control_points, const std::string& family_name) {
  const Read read = read_points(control_points, "control points");
  const Index3 dims = dims_of_grid(read.shape);
  const Family family = Family::parse(family_name);
  whole_dims(dims, family);
  const Unlocked unlocked;
  return held(Lattice(dims, read.points()), family);
}

Holder read(const std::filesystem::path& path, const std::optional<std::string>& family_name) {
  const Unlocked unlocked;
  std::optional<Family> family;
  if (family_name) family = Family::parse(*family_name);
  return std::make_unique<PyLattice>(DeformableLattice::read(path, family));
}

void write(const PyLattice& lattice, const std::filesystem::path& path, bool rest) {
  lattice.alone([&](const DeformableLattice& of) {
    write_lattice(path, {rest ? of.rest() : of.deformed(), of.rest(), of.family()});
  });
}

/// A copy of control points that NumPy refuses to write to: what was written there would be lost.
py::array control_points(const PyLattice& lattice, bool rest, bool flat) {
  const Lattice points =
      lattice.alone([&](const DeformableLattice& of) { return rest ? of.rest() : of.deformed(); });
  const Shape shape = flat ? Shape{points.points().rows(), 3} : grid_shape(points.dims());
  const py::object kind = py::module_::import("hwffd._control_points").attr("ControlPoints");
  return read_only(new_array(shape, points.points().data()).attr("view")(kind));
}

/// Control points as they come, with 2 or 3 along an axis where the lattice may have been made so.
Points read_moved(const py::object& points, const Index3& dims, const Family& family) {
  const Read read = read_points(points, "control points");
  if (read.shape.size() == 4 && read.shape != grid_shape(dims)) {
    const Index3 few = dims_of_grid(read.shape);
    const bool is_few = std::any_of(few.begin(), few.end(), [](int n) {
      return n >= Lattice::kFewestPoints && n < Lattice::kMinPoints;
    });
    if (family.takes_few() && is_few && whole_dims(few, family) == dims) {
      return whole(Lattice(few, read.points()), family).points();
    }
  }
  return read_control_points(points, dims);
}

void set_control_points(PyLattice& lattice, const py::object& points) {
  const auto [dims, family] = lattice.alone(
      [](const DeformableLattice& of) { return std::pair(of.rest().dims(), of.family()); });
  const Points read = read_moved(points, dims, family);
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
  refuse_masked(numbers, "cells");
  const auto cells = py::array::ensure(numbers);
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
  Target target(out, {cells.rows(), 3}, false);
  return target.take(
      lattice.alone([&](DeformableLattice& of) { return of.evaluate(std::move(vertices)); }));
}

py::array evaluate_grid(PyLattice& lattice, const py::object& first, const py::object& last,
                        const py::object& numbers, const py::object& out) {
  const Index3 counts = read_integers(numbers, "counts", "(cs, ct, cu)");
  const Grid grid = grid_of_places(read_numbers(first, "first", "(s, t, u)"),
                                   read_numbers(last, "last", "(s, t, u)"), counts);
  Target target(out, {counts[2], counts[1], counts[0], 3}, false);
  return target.take(lattice.alone([&](DeformableLattice& of) { return of.evaluate_grid(grid); }));
}

/// Places in a lattice of so many cells, in cells from its first face on.
std::vector<Embedded> places_in(const Points& at, const Index3& cells) {
  std::vector<Embedded> places(static_cast<std::size_t>(at.rows()));
  for (Eigen::Index row = 0; row < at.rows(); ++row) {
    Embedded& place = places[static_cast<std::size_t>(row)];
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const double s = at(row, static_cast<Eigen::Index>(axis));
      if (!(s >= 0 && s <= cells[axis])) {
        throw Error("places: row " + std::to_string(row) + " is not in the lattice; give 0 to (" +
                    std::to_string(cells[0]) + ", " + std::to_string(cells[1]) + ", " +
                    std::to_string(cells[2]) + "), in cells");
      }
      place.cell[axis] = std::min(static_cast<int>(s), cells[axis] - 1);
      place.local[static_cast<Eigen::Index>(axis)] = s - place.cell[axis];
    }
  }
  return places;
}

/// Why the package with the simulated hardware is not used, if it is there.
void check_rtl() {
  if (!device_rows("rtl").empty()) return;
  const auto problem = py::module_::import("hwffd._rtl").attr("PROBLEM").cast<std::string>();
  if (!problem.empty()) throw UsageError("device rtl: " + problem);
}

/// What pulls a gradient back: of (first, last, counts) a grid, else places (..., 3).
py::array pull_back_places(PyLattice& lattice, const py::object& places, const py::object& gradient,
                           const std::optional<std::string>& device) {
  const std::string kind = device.value_or("");
  if (device && kind.empty()) throw UsageError("device: ''; give model, rtl or reference");
  if (kind == "rtl") check_rtl();
  Points pulled;
  if (py::isinstance<py::tuple>(places)) {
    const auto grid_numbers = py::reinterpret_borrow<py::tuple>(places);
    if (grid_numbers.size() != 3) {
      throw UsageError("places: a tuple of " + std::to_string(grid_numbers.size()) +
                       "; give an array (..., 3), or (first, last, counts) of a grid");
    }
    const Index3 counts = read_integers(grid_numbers[2], "counts", "(cs, ct, cu)");
    const Grid grid = grid_of_places(read_numbers(grid_numbers[0], "first", "(s, t, u)"),
                                     read_numbers(grid_numbers[1], "last", "(s, t, u)"), counts);
    const Points read =
        read_rows(gradient, "gradient", static_cast<Eigen::Index>(vertex_count(grid)));
    check_coordinates("gradient", read);
    pulled =
        lattice.alone([&](DeformableLattice& of) { return of.pull_back_grid(grid, read, kind); });
  } else {
    const Points at = read_points(places, "places").points();
    const Points read = read_rows(gradient, "gradient", at.rows());
    check_coordinates("gradient", read);
    pulled = lattice.alone([&](DeformableLattice& of) {
      return of.pull_back(places_in(at, of.family().cells(of.rest().dims())), read, kind);
    });
  }
  const Index3 dims = lattice.alone([](const DeformableLattice& of) { return of.rest().dims(); });
  return new_array(grid_shape(dims), pulled.data());
}

void set_device(PyLattice& lattice, const std::string& device, const std::string& org,
                const std::string& format, int pages, int axis_points) {
  if (device == "rtl") check_rtl();
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

/// Of what __setstate__ has of a pickle.
Holder lattice_from_pickle(const py::tuple& state) {
  Holder lattice = of_grid(state[0], state[2].cast<std::string>());
  set_control_points(*lattice, state[1]);
  set_outside(*lattice, state[3].cast<std::string>());
  set_device(*lattice, state[4].cast<std::string>(), state[5].cast<std::string>(),
             state[6].cast<std::string>(), state[7].cast<int>(), state[8].cast<int>());
  return lattice;
}

/// @param state  that, or a lattice, of which the new one is a copy
Holder lattice_from(const py::tuple& state) {
  if (state.size() == 1 && py::isinstance<PyLattice>(state[0])) {
    return lattice_from_pickle(state_of_lattice(state[0].cast<const PyLattice&>()));
  }
  try {
    if (state.size() == 9) return lattice_from_pickle(state);
  } catch (const py::cast_error&) {
    // A text or a number is something else.
  }
  throw Error("this pickle holds no lattice; pickle one again");
}

template <typename Get>
auto getter(const Get& get) {
  return [get](const PyLattice& lattice) { return lattice.alone(get); };
}

void bind_making(py::class_<PyLattice>& type) {
  type.def(py::init(&from_points), py::arg("dims"), py::arg("points"), py::kw_only(),
           py::arg("family") = "bspline",
           "A lattice from control points.\n\ndims: (ns, nt, nu), 4 to 64 each, and 2 or 3 in the "
           "families bernstein, catmull-rom and linear, of which four points and more are made. "
           "points: (ns, nt, nu, 3) or (ns*nt*nu, 3), point (i, j, k) in row (i*nt + j)*nu + k.")
      .def_static("of", &of_grid, py::arg("control_points"), py::kw_only(),
                  py::arg("family") = "bspline", "A lattice from control points (ns, nt, nu, 3).")
      .def_static("read", &read, py::arg("path"), py::kw_only(), py::arg("family") = py::none(),
                  "A lattice file (docs/lattice.md section 3), with its points at rest if it has "
                  "some. family: None, that which the file names, or bspline.")
      .def("write", &write, py::arg("path"), py::kw_only(), py::arg("rest") = false,
           "Writes a lattice file that read() makes the same lattice of: control points, those at "
           "rest if they differ, and the family; rest=True: of the lattice at rest.")
      .def(py::pickle(&state_of_lattice, &lattice_from));
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

void check_constructed(const py::handle& object, const char* kind, const char* cure) {
  auto* const instance = reinterpret_cast<py::detail::instance*>(object.ptr());
  for (auto& value : py::detail::values_and_holders(instance)) {
    if (value.holder_constructed()) return;
  }
  throw UsageError(std::string(kind) + ": an object that __new__ alone has made; make it by " +
                   cure);
}

void bind_lattice(py::module_& module) {
  py::class_<PyLattice> type(
      module, "Lattice",
      "Control points at rest and deformed, and the device that evaluates them. Several threads "
      "may use one: they wait for each other.");
  bind_making(type);
  bind_around(type);
  bind_space(type);
  bind_refine(type);
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
      .def("set_device", &set_device, py::arg("device"), py::arg("org") = "",
           py::arg("format") = "", py::arg("pages") = 0, py::arg("axis_points") = kAxisPoints,
           "model, rtl, reference, or a board, serial:/dev/ttyUSB0, uio:0 or socket:PATH; pages "
           "and axis_points "
           "are those of a model's core: lattices "
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
           "on. Coordinates in a cell have 24 bits, as the grids of a core do.")
      .def("pull_back", &pull_back_places, py::arg("places"), py::arg("gradient"), py::kw_only(),
           py::arg("device") = py::none(),
           "(ns, nt, nu, 3): of a gradient (..., 3) with respect to the points of the deformed "
           "lattice at places that with respect to its control points, the same bits in any order "
           "of the places.\n\nplaces: (..., 3), (s, t, u) in cells from the first face on, or a "
           "tuple (first, last, counts) as evaluate_grid() takes them, with a gradient for each "
           "vertex, (cu, ct, cs, 3). device: reference, model for that of affine in fx17, or rtl "
           "for the simulated core with the same bits; None, that of the lattice.");
}

}  // namespace hwffd::python
