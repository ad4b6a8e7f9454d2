// The Python module hwffd._core: lattices, embeddings and exceptions, over NumPy arrays.

#include <pybind11/pybind11.h>
#include <pybind11/stl.h>

#include "hwffd/error.hpp"
#include "hwffd/lattice/family.hpp"
#include "hwffd/lattice/shape.hpp"
#include "hwffd/on_threads.hpp"
#include "hwffd/version.h"
#include "lattice.hpp"

namespace py = pybind11;
using namespace hwffd;

PYBIND11_MODULE(_core, module) {
  module.attr("__version__") = HWFFD_VERSION;
  // The one registered last is tried first.
  const py::object error = py::register_exception<Error>(module, "Error", PyExc_RuntimeError);
  py::register_exception<UsageError>(module, "UsageError",
                                     py::make_tuple(error, py::handle(PyExc_ValueError)));
  python::bind_lattice(module);
  python::bind_embedding(module);
  module.def("set_threads", &set_thread_count, py::arg("count"),
             "How many threads embed and evaluate; 0: as many as there are cores. No result "
             "depends on it.");
  module.def("threads", &thread_count, "How many threads embed and evaluate.");
  module.def("families", &Family::names, "The names that family= takes.");
  module.def("shapes", &shape_names, "The names that Lattice.around takes.");
  module.def("devices", &device_rows, py::arg("kind"),
             "The rows that set_device takes for a kind, model or rtl.");
}
