#include "arrays.hpp"

#include <algorithm>
#include <optional>
#include <string>

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

/// Copies an array of any strides, of 3*n numbers.
Points copy_of(const py::array& array) {
  const auto packed = py::array_t<double, py::array::c_style | py::array::forcecast>::ensure(array);
  if (!packed) throw py::error_already_set();
  return Eigen::Map<const Points>(packed.data(), packed.size() / 3, 3);
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
  return {copy_of(read), shape_of(read), is_float32(read.dtype())};
}

Points read_rows(const py::handle& array, const char* name, Eigen::Index rows) {
  Points read = read_points(array, name).points;
  if (read.rows() == rows) return read;
  throw UsageError(std::string(name) + ": " + std::to_string(read.rows()) + " rows; give " +
                   std::to_string(rows) + ", one for each point");
}

Points read_control_points(const py::handle& array, const Index3& dims) {
  const Read read = read_points(array, "control points");
  const Shape grid = grid_shape(dims);
  const Shape flat = {grid[0] * grid[1] * grid[2], 3};
  if (read.shape == grid || read.shape == flat) return read.points;
  throw UsageError("control points: shape " + text_of(read.shape) + "; give " + text_of(grid) +
                   " or " + text_of(flat));
}

py::array target(const py::object& out, const Shape& shape, bool is_float) {
  if (out.is_none()) {
    return {is_float ? py::dtype::of<float>() : py::dtype::of<double>(), shape};
  }
  if (!py::isinstance<py::array>(out)) {
    throw UsageError("out: no array of NumPy; give one of float32 or float64");
  }
  auto array = py::reinterpret_borrow<py::array>(out);
  const py::dtype type = array.dtype();
  if (!type.equal(py::dtype::of<float>()) && !type.equal(py::dtype::of<double>())) {
    throw UsageError("out: numbers of " + std::string(py::str(type)) + "; give float32 or float64");
  }
  if (shape_of(array) != shape) {
    throw UsageError("out: shape " + text_of(shape_of(array)) + "; give " + text_of(shape));
  }
  if (!array.writeable()) throw UsageError("out: a read-only array; give one to write to");
  return array;
}

void write_points(const Points& points, const py::array& to) {
  const auto row = is_float32(to.dtype()) ? beyond_float(points) : std::nullopt;
  if (row) {
    throw Error("point " + std::to_string(*row) +
                " is beyond what float32 holds; give points or out of float64");
  }
  // With a base, if only None, NumPy takes the numbers where they are.
  const py::array_t<double> from(shape_of(to), points.data(), py::none());
  to.attr("__setitem__")(py::ellipsis(), from);
}

py::array new_array(const Shape& shape, const double* data) {
  return py::array_t<double>(shape, data);
}

py::array read_only(py::array array) {
  array.attr("flags").attr("writeable") = false;
  return array;
}

}  // namespace hwffd::python
