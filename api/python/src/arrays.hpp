#pragma once

#include <pybind11/numpy.h>

#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "hwffd/lattice/lattice.hpp"
#include "hwffd/points.hpp"

namespace hwffd::python {

namespace py = pybind11;

using Shape = std::vector<py::ssize_t>;

/// Points out of Python and how they came.
struct Read {
  py::array packed;  ///< of float if they were, else of double; the caller's own where it is that
  Shape shape;       ///< (..., 3)
  bool is_float;     ///< float32, so that results are

  Eigen::Index count() const { return packed.size() / 3; }
  /// Some of them, in double. Needs no lock of the interpreter.
  Points rows(Eigen::Index first, Eigen::Index count) const;
  Points points() const { return rows(0, count()); }
};

/// Throws UsageError for an array with a mask, which would be lost, and for a list of such.
void refuse_masked(const py::handle& object, const char* name);

/// An array (..., 3), or what NumPy makes one of, of floats or integers, with any strides.
/// @param name  of the argument, for messages
/// @throws UsageError for another shape or kind of numbers, and for masked arrays
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

  /// Makes room for write().
  void open();
  /// Keeps rows from `first` on. Several threads may, each its own rows; needs no lock of the
  /// interpreter.
  /// @throws Error if a float32 cannot hold a number
  void write(Eigen::Index first, const Points& rows);
  /// The array with the rows that were written.
  py::array take() const;
  /// The array with these points, as many as it has room for.
  /// @throws Error, before anything is written, if a float32 cannot hold a number
  py::array take(Points points);

 private:
  bool is_float_;
  Shape shape_;
  std::optional<py::array> out_;  ///< the caller's
  py::array room_;                ///< packed
  void* numbers_ = nullptr;       ///< of room_
};

/// A new array of doubles, that NumPy refuses to write to if it is a copy of what a lattice has.
py::array new_array(const Shape& shape, const double* data);

/// An array with numbers, of a matrix or vector, for its own.
template <typename Numbers>
py::array owning(Numbers numbers, const Shape& shape) {
  using Number = typename Numbers::value_type;
  auto owned = std::make_unique<Numbers>(std::move(numbers));
  const Number* data = owned->data();
  const py::capsule owner(owned.release(), [](void* of) { delete static_cast<Numbers*>(of); });
  return py::array_t<Number>(shape, data, owner);
}
/// In one row.
template <typename Number>
py::array owning(std::vector<Number> numbers) {
  const auto size = static_cast<py::ssize_t>(numbers.size());
  return owning(std::move(numbers), {size});
}
py::array read_only(py::array array);

/// (ns, nt, nu, 3)
Shape grid_shape(const Index3& dims);
/// The way back. Numbers that no lattice has may come out smaller, but none that one has.
/// @throws UsageError for another number of dimensions
Index3 dims_of_grid(const Shape& shape);

}  // namespace hwffd::python
