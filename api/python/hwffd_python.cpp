// The Python module hwffd: DeformableLattice over NumPy arrays.

#include <pybind11/eigen.h>
#include <pybind11/pybind11.h>
#include <pybind11/stl.h>

#include <optional>

#include "hwffd/device/deformable_lattice.hpp"
#include "hwffd/error.hpp"
#include "hwffd/lattice/around.hpp"
#include "hwffd/lattice/fold.hpp"
#include "hwffd/lattice/lattice_file.hpp"
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

Points evaluate(DeformableLattice& lattice, const Cells& cells, const Points& local) {
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

void set_device(DeformableLattice& lattice, const std::string& device, const std::string& org,
                const std::string& format) {
  lattice.set_device({device, org, format});
}

}  // namespace

PYBIND11_MODULE(hwffd, module) {
  module.doc() = "Free-form deformation on simulated hardware, its bit-true model or in double";
  module.attr("__version__") = HWFFD_VERSION;
  // The one registered last is tried first.
  py::register_exception<Error>(module, "Error", PyExc_RuntimeError);
  py::register_exception<UsageError>(module, "UsageError", PyExc_ValueError);
  py::class_<DeformableLattice>(module, "Lattice")
      .def(py::init([](const Index3& dims, const Points& points) {
             return DeformableLattice(Lattice(dims, points));
           }),
           py::arg("dims"), py::arg("points"),
           "Control points, n x 3: (i, j, k) is row (i*dims[1] + j)*dims[2] + k")
      .def_static("around", &around, py::arg("shape"), py::arg("points"),
                  py::arg("dims") = py::none(), "box, cylinder or sphere that holds the points")
      .def_static("read",
                  [](const std::string& path) { return DeformableLattice(read_lattice(path)); })
      .def_property_readonly("dims",
                             [](const DeformableLattice& lattice) { return lattice.rest().dims(); })
      .def_property_readonly(
          "rest", [](const DeformableLattice& lattice) { return lattice.rest().points(); })
      .def_property(
          "points", [](const DeformableLattice& lattice) { return lattice.deformed().points(); },
          &DeformableLattice::move, "control points as deformed, n x 3")
      .def("deform", &DeformableLattice::deform, "move the control points, as in \"twist:90\"")
      .def("folds",
           [](const DeformableLattice& lattice) { return check_folds(lattice.deformed()).text(); })
      .def("set_device", &set_device, py::arg("device"), py::arg("org") = "basic",
           py::arg("format") = "fp32", "model, rtl or reference")
      .def("set_outside", &DeformableLattice::set_outside, "keep, clamp or fade:WIDTH")
      .def("embed", &embed, "(cells, local, residual, inside) of points, n x 3")
      .def("evaluate", &evaluate, py::arg("cells"), py::arg("local"));
  module.def(
      "deform",
      [](DeformableLattice& lattice, const Points& points) { return lattice.carry(points); },
      py::arg("lattice"), py::arg("points"), "points, n x 3, as the deformed lattice carries them");
}
