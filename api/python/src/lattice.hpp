#pragma once

#include <pybind11/pybind11.h>

#include <memory>
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
  mutable OwnedMutex mutex_;
  DeformableLattice lattice_;
};

/// Throws UsageError for an object that `__new__` alone has made, which has nothing to use.
/// @param kind  the class, and how its objects are made, for the message
void check_made(const py::handle& object, const char* kind, const char* cure);

void bind_lattice(py::module_& module);
/// Lattice.around.
void bind_around(py::class_<PyLattice>& type);
/// What a lattice does to space: displacements, the inverse, the bending energy.
void bind_space(py::class_<PyLattice>& type);
void bind_embedding(py::module_& module);

/// The points embedded in the lattice at rest; those that can neither be embedded nor excluded
/// stay.
PyEmbedding embed(const PyLattice& lattice, const py::object& points);

}  // namespace hwffd::python

namespace pybind11::detail {

template <>
struct type_caster<hwffd::python::PyLattice> : type_caster_base<hwffd::python::PyLattice> {
  bool load(handle object, bool convert) {
    if (isinstance<hwffd::python::PyLattice>(object)) {
      hwffd::python::check_made(object, "Lattice", "Lattice.of, around or read");
    }
    return type_caster_base<hwffd::python::PyLattice>::load(object, convert);
  }
};

template <>
struct type_caster<hwffd::python::PyEmbedding> : type_caster_base<hwffd::python::PyEmbedding> {
  bool load(handle object, bool convert) {
    if (isinstance<hwffd::python::PyEmbedding>(object)) {
      hwffd::python::check_made(object, "Embedding", "embed of a lattice");
    }
    return type_caster_base<hwffd::python::PyEmbedding>::load(object, convert);
  }
};

}  // namespace pybind11::detail
