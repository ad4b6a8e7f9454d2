#pragma once

#include <pybind11/numpy.h>

#include <vector>

#include "hwffd/lattice/lattice.hpp"
#include "hwffd/points.hpp"

namespace hwffd::python {

namespace py = pybind11;

using Shape = std::vector<py::ssize_t>;

/// Points out of Python and how they came.
struct Read {
  Points points;  ///< n x 3
  Shape shape;    ///< of the array, (..., 3)
  bool is_float;  ///< float32, so that results are
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

/// An array to write results to: `out` of the caller, or a new one.
/// @param out  None, or a writable array of float32 or float64 with that shape
/// @throws UsageError for anything else
py::array target(const py::object& out, const Shape& shape, bool is_float);

/// Writes points to an array of the same size.
/// @throws Error, before anything is written, if a float32 cannot hold a number
void write_points(const Points& points, const py::array& to);

/// A new array of doubles, that NumPy refuses to write to if it is a copy of what a lattice has.
py::array new_array(const Shape& shape, const double* data);
py::array read_only(py::array array);

/// (ns, nt, nu, 3)
Shape grid_shape(const Index3& dims);
/// The way back. Numbers that no lattice has may come out smaller, but none that one has.
/// @throws UsageError for another number of dimensions
Index3 dims_of_grid(const Shape& shape);

}  // namespace hwffd::python
