// The Python module hwffd: DeformableLattice over NumPy arrays.

#include <pybind11/eigen.h>
#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>
#include <pybind11/stl.h>

#include <cstdint>
#include <optional>
#include <string>

#include "hwffd/device/deformable_lattice.hpp"
#include "hwffd/error.hpp"
#include "hwffd/lattice/around.hpp"
#include "hwffd/lattice/fold.hpp"
#include "hwffd/lattice/lattice_file.hpp"
#include "hwffd/lattice/shape.hpp"
#include "hwffd/version.h"

namespace py = pybind11;
using namespace hwffd;

namespace {

using Cells = Eigen::Matrix<int, Eigen::Dynamic, 3, Eigen::RowMajor>;

DeformableLattice around(const std::string& shape, const Points& points,
                         const std::optional<Index3>& dims) {
  return DeformableLattice(lattice_around(shape, points, dims ? *dims : usual_dims(shape)));
}

/// (cell n x 3, local n x 3, residual n, inside n), as NumPy arrays.
py::tuple embed(const DeformableLattice& lattice, const Points& points) {
  const std::vector<Embedding> embeddings = lattice.embed(points);
  const auto n = static_cast<Eigen::Index>(embeddings.size());
  Cells cells(n, 3);
  Points local(n, 3);
  Eigen::VectorXd residual(n);
  Eigen::Matrix<bool, Eigen::Dynamic, 1> inside(n);
  for (Eigen::Index i = 0; i < n; ++i) {
    const Embedding& e = embeddings[static_cast<std::size_t>(i)];
    cells.row(i) << e.at.cell[0], e.at.cell[1], e.at.cell[2];
    local.row(i) = e.at.local;
    residual[i] = e.residual;
    inside[i] = e.status == EmbeddingStatus::kInside;
  }
  return py::make_tuple(cells, local, residual, inside);
}

/// Numbers of cells, n x 3, of any kind of integer: NumPy's own conversion cuts off fractions and
/// high bits without a word.
Cells whole_numbers(const py::object& numbers) {
  const auto cells = py::array::ensure(numbers);
  const char kind = cells ? cells.dtype().kind() : '-';
  if ((kind != 'i' && kind != 'u') || cells.ndim() != 2 || cells.shape(1) != 3) {
    throw UsageError("evaluate: cells are integers, n x 3; give them as embed() does");
  }
  Cells result(cells.shape(0), 3);
  const auto wide = py::array_t<std::int64_t>::ensure(cells);
  for (Eigen::Index i = 0; i < result.rows(); ++i) {
    for (Eigen::Index axis = 0; axis < 3; ++axis) {
      const std::int64_t number = wide.at(i, axis);
      if (number < 0 || number >= Lattice::kMaxPoints) {
        throw Error("evaluate: cell " + std::to_string(number) + " in row " + std::to_string(i) +
                    "; no lattice has it");
      }
      result(i, axis) = static_cast<int>(number);
    }
  }
  return result;
}

Points evaluate(DeformableLattice& lattice, const py::object& numbers, const Points& local) {
  const Cells cells = whole_numbers(numbers);
  if (cells.rows() != local.rows()) {
    throw UsageError("evaluate: as many cells as local coordinates; give a row each");
  }
  std::vector<Embedded> vertices(static_cast<std::size_t>(cells.rows()));
  for (Eigen::Index i = 0; i < cells.rows(); ++i) {
    Embedded& vertex = vertices[static_cast<std::size_t>(i)];
    vertex.cell = {cells(i, 0), cells(i, 1), cells(i, 2)};
    vertex.local = local.row(i);
  }
  return lattice.evaluate(std::move(vertices));
}

/// A copy that NumPy refuses to write to: what was written there would be lost.
py::array read_only(const Points& points) {
  py::array array = py::cast(points);
  array.attr("flags").attr("writeable") = false;
  return array;
}

Points deform(DeformableLattice& lattice, const Points& points) {
  Points carried = lattice.carry(points);
  const EmbeddingSummary& summary = lattice.summary();
  if (summary.outside > 0 && lattice.outside().kind() == Outside::Kind::kKeep) {
    const std::string text = std::to_string(summary.outside) + " of " +
                             std::to_string(summary.points) +
                             " points are outside the lattice and stayed; see set_outside";
    if (PyErr_WarnEx(PyExc_UserWarning, text.c_str(), 1) != 0) throw py::error_already_set();
  }
  return carried;
}

void set_device(DeformableLattice& lattice, const std::string& device, const std::string& org,
                const std::string& format, int pages, int axis_points) {
  lattice.set_device({device, org, format, pages, axis_points});
}

}  // namespace

PYBIND11_MODULE(hwffd, module) {
  module.doc() = "Free-form deformation on simulated hardware, its bit-true model or in double";
  module.attr("__version__") = HWFFD_VERSION;
  // The one registered last is tried first.
  const py::object error = py::register_exception<Error>(module, "Error", PyExc_RuntimeError);
  py::register_exception<UsageError>(module, "UsageError",
                                     py::make_tuple(error, py::handle(PyExc_ValueError)));
  py::class_<DeformableLattice>(module, "Lattice")
      .def(py::init([](const Index3& dims, const Points& points) {
             return DeformableLattice(Lattice(dims, points));
           }),
           py::arg("dims"), py::arg("points"),
           "Control points, n x 3: (i, j, k) is row (i*dims[1] + j)*dims[2] + k")
      .def_static("around", &around, py::arg("shape"), py::arg("points"),
                  py::arg("dims") = py::none(),
                  (shape_list(" or ") + " that holds the points").c_str())
      .def_static("read",
                  [](const std::string& path) { return DeformableLattice(read_lattice(path)); })
      .def_property_readonly("dims",
                             [](const DeformableLattice& lattice) { return lattice.rest().dims(); })
      .def_property_readonly(
          "rest",
          [](const DeformableLattice& lattice) { return read_only(lattice.rest().points()); })
      .def_property(
          "points",
          [](const DeformableLattice& lattice) { return read_only(lattice.deformed().points()); },
          &DeformableLattice::move,
          "control points as deformed, n x 3; a copy, not to be written to: set all of them")
      .def("deform", &DeformableLattice::deform, "move the control points, as in \"twist:90\"")
      .def("folds",
           [](const DeformableLattice& lattice) { return check_folds(lattice.deformed()).text(); })
      .def("set_device", &set_device, py::arg("device"), py::arg("org") = "basic",
           py::arg("format") = "", py::arg("pages") = 0, py::arg("axis_points") = kAxisPoints,
           "model, rtl or reference; pages and axis_points are those of a model's core: lattices "
           "that it keeps, and most points of one along an axis")
      .def("set_outside", &DeformableLattice::set_outside, "keep, clamp or fade:WIDTH")
      .def("embed", &embed, "(cells, local, residual, inside) of points, n x 3")
      .def("evaluate", &evaluate, py::arg("cells"), py::arg("local"))
      .def_property_readonly(
          "outside", [](const DeformableLattice& lattice) { return lattice.summary().outside; },
          "how many points of the last deform() lay outside the cells");
  module.def("deform", &deform, py::arg("lattice"), py::arg("points"),
             "points, n x 3, as the deformed lattice carries them");
}
