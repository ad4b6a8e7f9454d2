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
  static constexpr const char* kName = "Embedding";
  static constexpr const char* kFactory = "embed of a lattice";

  std::shared_ptr<const Attachment> attachment;
  std::vector<py::ssize_t> shape;  ///< of the points, (..., 3)
  bool is_float = false;           ///< whether they were float32
  std::string outside;             ///< what points outside do
};

/// A lattice of Python: one thread at a time uses it, others wait.
class PyLattice {
 public:
  static constexpr const char* kName = "Lattice";
  static constexpr const char* kFactory = "Lattice.of, around or read";

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
void check_constructed(const py::handle& object, const char* kind, const char* cure);

void bind_lattice(py::module_& module);
/// Lattice.around.
void bind_around(py::class_<PyLattice>& type);
/// What a lattice does to space: displacements, the inverse, the bending energy.
void bind_space(py::class_<PyLattice>& type);
/// Lattice.refine.
void bind_refine(py::class_<PyLattice>& type);
void bind_embedding(py::module_& module);
void bind_fit(py::module_& module);
void bind_registration(py::module_& module);
void bind_core(py::module_& module);

/// The points embedded in the lattice at rest; those that can neither be embedded nor excluded
/// stay.
PyEmbedding embed(const PyLattice& lattice, const py::object& points);

}  // namespace hwffd::python

namespace pybind11::detail {

/// Of a class whose objects `__new__` alone may have made, which are refused.
template <typename Object>
struct constructed_caster : type_caster_base<Object> {
  bool load(handle object, bool convert) {
    if (isinstance<Object>(object)) {
      hwffd::python::check_constructed(object, Object::kName, Object::kFactory);
    }
    return type_caster_base<Object>::load(object, convert);
  }
};

template <>
struct type_caster<hwffd::python::PyLattice> : constructed_caster<hwffd::python::PyLattice> {};

template <>
struct type_caster<hwffd::python::PyEmbedding> : constructed_caster<hwffd::python::PyEmbedding> {};

}  // namespace pybind11::detail
