// The Python module hwffd._core: lattices, embeddings and exceptions, over NumPy arrays.

#include <pybind11/pybind11.h>
#include <pybind11/stl.h>

#include <new>

#include "arguments.hpp"
#include "hwffd/error.hpp"
#include "hwffd/lattice/family.hpp"
#include "hwffd/lattice/shape.hpp"
#include "hwffd/on_threads.hpp"
#include "hwffd/version.h"
#include "lattice.hpp"

namespace py = pybind11;
using namespace hwffd;

namespace {

constexpr long long kMostThreads = 4096;

void set_threads(const py::object& count) {
  set_thread_count(static_cast<std::size_t>(python::read_integer(count, "count", 0, kMostThreads)));
}

/// What the library throws that is not its own, such as a system's refusal of more threads, is an
/// Error too.
void translate_others(std::exception_ptr thrown) {
  try {
    std::rethrow_exception(std::move(thrown));
  } catch (const Error&) {
    throw;
  } catch (const py::builtin_exception&) {
    throw;
  } catch (const std::bad_alloc&) {
    throw;
  } catch (const std::exception& error) {
    throw Error(error.what());
  }
}

}  // namespace

PYBIND11_MODULE(_core, module) {
  module.attr("__version__") = HWFFD_VERSION;
  // The one registered last is tried first.
  const py::object error = py::register_exception<Error>(module, "Error", PyExc_RuntimeError);
  py::register_exception<UsageError>(
      module, "UsageError",
      py::make_tuple(error, py::handle(PyExc_ValueError), py::handle(PyExc_TypeError)));
  py::register_local_exception_translator(&translate_others);
  python::watch_exit();
  python::bind_lattice(module);
  python::bind_embedding(module);
  python::bind_fit(module);
  python::bind_registration(module);
  python::bind_core(module);
  module.def("set_threads", &set_threads, py::arg("count"),
             "How many threads embed and evaluate; 0: as many as there are cores. No result "
             "depends on it.");
  module.def("threads", &thread_count, "How many threads embed and evaluate.");
  module.def("families", &Family::names, "The names that family= takes.");
  module.def("shapes", &shape_names, "The names that Lattice.around takes.");
  module.def("devices", &device_rows, py::arg("kind"),
             "The rows that set_device takes for a kind, model or rtl.");
}
