#pragma once

#include <pybind11/pybind11.h>

#include <memory>
#include <mutex>
#include <string>
#include <utility>

#include "hwffd/device/deformable_lattice.hpp"
#include "unlocked.hpp"

namespace hwffd::python {

/// Points that stay attached, as Python has them: never changed, so many may share one.
struct PyEmbedding {
  std::shared_ptr<const Attachment> attachment;
  std::vector<py::ssize_t> shape;  ///< of the points, (..., 3)
  bool is_float = false;           ///< whether they were float32
  std::string outside;             ///< what points outside do
};

/// A lattice of Python: one thread at a time uses it, others wait.
class PyLattice {
 public:
  explicit PyLattice(DeformableLattice lattice) : lattice_(std::move(lattice)) {}

  /// What f(lattice) gives, without the interpreter's lock and with nobody else at work.
  template <typename F>
  auto alone(const F& f) {
    const Turn turn(mutex_);
    return f(lattice_);
  }
  template <typename F>
  auto alone(const F& f) const {
    const Turn turn(mutex_);
    return f(static_cast<const DeformableLattice&>(lattice_));
  }

  /// What set_outside() was given; read and written within alone().
  std::string outside = "keep";

 private:
  mutable std::timed_mutex mutex_;
  DeformableLattice lattice_;
};

void bind_lattice(py::module_& module);
void bind_embedding(py::module_& module);

/// The points embedded in the lattice at rest; those that can neither be embedded nor excluded
/// stay.
PyEmbedding embed(const PyLattice& lattice, const py::object& points);

}  // namespace hwffd::python
