#pragma once

#include <pybind11/numpy.h>

#include <optional>
#include <vector>

#include "hwffd/lattice/lattice.hpp"
#include "hwffd/points.hpp"

namespace hwffd::python {

namespace py = pybind11;

using Shape = std::vector<py::ssize_t>;

/// Points out of Python and how they came.
struct Read {
  py::array_t<double> packed;  ///< the caller's own array where that is
  Shape shape;                 ///< (..., 3)
  bool is_float;               ///< float32, so that results are

  /// n x 3, of `packed`.
  Eigen::Map<const Points> points() const { return {packed.data(), packed.size() / 3, 3}; }
};

/// An array (..., 3), or what NumPy makes one of, of floats or integers, with any strides.
/// @param name  of the argument, for messages
/// @throws UsageError for another shape or kind of numbers
Read read_points(const py::handle& array, const char* name);

/// The same of as many rows as there are points.
/// @throws UsageError for another number
Points read_rows(const py::handle& array, const char* name, Eigen::Index rows);

/// Control points, (ns, nt, nu, 3) or (ns*nt*nu, 3).
/// @throws UsageError for another shape
Points read_control_points(const py::handle& array, const Index3& dims);

/// Where results go: an array of the caller's, or a new one.
class Target {
 public:
  /// @param out  None, or a writable array of float32 or float64 with that shape
  /// @param is_float  of a new array: float32
  /// @throws UsageError for anything else
  Target(const py::object& out, Shape shape, bool is_float);

  /// The array with the points in it, as many as it has room for.
  /// @throws Error, before anything is written, if a float32 cannot hold a number
  py::array take(Points points) const;

 private:
  Shape shape_;
  std::optional<py::array> array_;  ///< none: a new one is made of the points
};

/// A new array of doubles, that NumPy refuses to write to if it is a copy of what a lattice has.
py::array new_array(const Shape& shape, const double* data);
py::array read_only(py::array array);

/// (ns, nt, nu, 3)
Shape grid_shape(const Index3& dims);
/// The way back. Numbers that no lattice has may come out smaller, but none that one has.
/// @throws UsageError for another number of dimensions
Index3 dims_of_grid(const Shape& shape);

}  // namespace hwffd::python
