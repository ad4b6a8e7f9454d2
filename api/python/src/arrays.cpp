#include "arrays.hpp"

#include <algorithm>
#include <memory>
#include <optional>
#include <string>
#include <utility>

#include "hwffd/error.hpp"
#include "hwffd/lattice/coordinates.hpp"

namespace hwffd::python {
namespace {

std::string text_of(const Shape& shape) {
  std::string text = "(";
  for (std::size_t i = 0; i < shape.size(); ++i) {
    text += (i > 0 ? ", " : "") + std::to_string(shape[i]);
  }
  return text + (shape.size() == 1 ? ",)" : ")");
}

Shape shape_of(const py::array& array) { return {array.shape(), array.shape() + array.ndim()}; }

bool is_float32(const py::dtype& type) { return type.kind() == 'f' && type.itemsize() == 4; }

/// What NumPy makes of an object, if that is numbers.
py::array numbers(const py::handle& object, const char* name) {
  auto array = py::array::ensure(object);
  if (!array) {
    PyErr_Clear();
    throw UsageError(std::string(name) + ": no array; give one of NumPy, of float32 or float64");
  }
  const char kind = array.dtype().kind();
  if (kind != 'f' && kind != 'i' && kind != 'u') {
    throw UsageError(std::string(name) + ": numbers of " + std::string(py::str(array.dtype())) +
                     "; give float32, float64 or integers");
  }
  return array;
}

/// The array, if its numbers are doubles one behind the other; a copy where they are not.
py::array_t<double> packed(const py::array& array) {
  const auto found = py::array_t<double, py::array::c_style | py::array::forcecast>::ensure(array);
  if (!found) throw py::error_already_set();
  return found;
}

/// An array with the points for its numbers.
py::array owning(Points points, const Shape& shape) {
  auto owned = std::make_unique<Points>(std::move(points));
  const double* data = owned->data();
  const py::capsule owner(owned.release(), [](void* of) { delete static_cast<Points*>(of); });
  return py::array_t<double>(shape, data, owner);
}

}  // namespace

Shape grid_shape(const Index3& dims) { return {dims[0], dims[1], dims[2], 3}; }

Index3 dims_of_grid(const Shape& shape) {
  if (shape.size() != 4) {
    throw UsageError("control points: " + std::to_string(shape.size()) +
                     " dimensions; give four, (ns, nt, nu, 3)");
  }
  Index3 dims{};
  for (std::size_t axis = 0; axis < 3; ++axis) {
    dims[axis] = static_cast<int>(std::min<py::ssize_t>(shape[axis], 1 << 20));
  }
  return dims;
}

Read read_points(const py::handle& array, const char* name) {
  const py::array read = numbers(array, name);
  if (read.ndim() == 0 || read.shape(read.ndim() - 1) != 3) {
    throw UsageError(std::string(name) + ": shape " + text_of(shape_of(read)) +
                     "; give (..., 3), x, y and z last");
  }
  return {packed(read), shape_of(read), is_float32(read.dtype())};
}

Points read_rows(const py::handle& array, const char* name, Eigen::Index rows) {
  Points read = read_points(array, name).points();
  if (read.rows() == rows) return read;
  throw UsageError(std::string(name) + ": " + std::to_string(read.rows()) + " rows; give " +
                   std::to_string(rows) + ", one for each point");
}

Points read_control_points(const py::handle& array, const Index3& dims) {
  const Read read = read_points(array, "control points");
  const Shape grid = grid_shape(dims);
  const Shape flat = {grid[0] * grid[1] * grid[2], 3};
  if (read.shape == grid || read.shape == flat) return read.points();
  throw UsageError("control points: shape " + text_of(read.shape) + "; give " + text_of(grid) +
                   " or " + text_of(flat));
}

Target::Target(const py::object& out, Shape shape, bool is_float) : shape_(std::move(shape)) {
  if (out.is_none()) {
    if (is_float) array_ = py::array(py::dtype::of<float>(), shape_);
    return;
  }
  if (!py::isinstance<py::array>(out)) {
    throw UsageError("out: no array of NumPy; give one of float32 or float64");
  }
  array_ = py::reinterpret_borrow<py::array>(out);
  const py::dtype type = array_->dtype();
  if (!type.equal(py::dtype::of<float>()) && !type.equal(py::dtype::of<double>())) {
    throw UsageError("out: numbers of " + std::string(py::str(type)) + "; give float32 or float64");
  }
  if (shape_of(*array_) != shape_) {
    throw UsageError("out: shape " + text_of(shape_of(*array_)) + "; give " + text_of(shape_));
  }
  if (!array_->writeable()) throw UsageError("out: a read-only array; give one to write to");
}

py::array Target::take(Points points) const {
  if (!array_) return owning(std::move(points), shape_);
  const auto row = is_float32(array_->dtype()) ? beyond_float(points) : std::nullopt;
  if (row) {
    throw Error("point " + std::to_string(*row) +
                " is beyond what float32 holds; give points or out of float64");
  }
  // With a base, if only None, NumPy takes the numbers where they are.
  const py::array_t<double> from(shape_, points.data(), py::none());
  array_->attr("__setitem__")(py::ellipsis(), from);
  return *array_;
}

py::array new_array(const Shape& shape, const double* data) {
  return py::array_t<double>(shape, data);
}

py::array read_only(py::array array) {
  array.attr("flags").attr("writeable") = false;
  return array;
}

}  // namespace hwffd::python
