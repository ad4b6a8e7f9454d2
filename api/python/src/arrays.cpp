#include "arrays.hpp"

#include <algorithm>
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

/// Whether it is an array with a mask, which would be lost, or a list or tuple of some.
bool is_masked(const py::handle& object) {
  // Where nobody has loaded it, there are none.
  const auto modules = py::reinterpret_borrow<py::dict>(PyImport_GetModuleDict());
  if (!modules.contains("numpy.ma")) return false;
  // Another thread may be importing it: nobody has one then.
  const py::object kind = py::getattr(modules["numpy.ma"], "MaskedArray", py::none());
  if (kind.is_none()) return false;
  if (py::isinstance(object, kind)) return true;
  if (!py::isinstance<py::list>(object) && !py::isinstance<py::tuple>(object)) return false;
  const auto items = py::reinterpret_borrow<py::sequence>(object);
  return std::any_of(items.begin(), items.end(),
                     [&](const py::handle& item) { return py::isinstance(item, kind); });
}

/// What NumPy makes of an object, if that is numbers.
py::array numbers(const py::handle& object, const char* name) {
  refuse_masked(object, name);
  auto array = py::array::ensure(object);
  if (!array) {
    throw UsageError(std::string(name) + ": no array; give one of NumPy, of float32 or float64");
  }
  const char kind = array.dtype().kind();
  if (kind != 'f' && kind != 'i' && kind != 'u') {
    throw UsageError(std::string(name) + ": numbers of " + std::string(py::str(array.dtype())) +
                     "; give float32, float64 or integers");
  }
  return array;
}

/// The array, if its numbers are of that type and one behind the other; a copy where they are not.
template <typename Number>
py::array packed(const py::array& array) {
  auto converted = py::array_t<Number, py::array::c_style | py::array::forcecast>::ensure(array);
  if (!converted) throw py::error_already_set();
  return converted;
}

template <typename Number>
Points rows_of(const void* numbers, Eigen::Index first, Eigen::Index count) {
  using Rows = Eigen::Matrix<Number, Eigen::Dynamic, 3, Eigen::RowMajor>;
  return Eigen::Map<const Rows>(static_cast<const Number*>(numbers) + 3 * first, count, 3)
      .template cast<double>();
}

template <typename Number>
void put_rows(void* numbers, Eigen::Index first, const Points& rows) {
  using Rows = Eigen::Matrix<Number, Eigen::Dynamic, 3, Eigen::RowMajor>;
  Eigen::Map<Rows>(static_cast<Number*>(numbers) + 3 * first, rows.rows(), 3) = rows.cast<Number>();
}

}  // namespace

void refuse_masked(const py::handle& object, const char* name) {
  if (!is_masked(object)) return;
  throw UsageError(std::string(name) +
                   ": a masked array; give one without a mask, as filled(value) makes it");
}

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
  const bool is_float = is_float32(read.dtype());
  return {is_float ? packed<float>(read) : packed<double>(read), shape_of(read), is_float};
}

Points Read::rows(Eigen::Index first, Eigen::Index count) const {
  return is_float ? rows_of<float>(packed.data(), first, count)
                  : rows_of<double>(packed.data(), first, count);
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

Target::Target(const py::object& out, Shape shape, bool is_float)
    : is_float_(is_float), shape_(std::move(shape)) {
  if (out.is_none()) return;
  if (!py::isinstance<py::array>(out)) {
    throw UsageError("out: no array of NumPy; give one of float32 or float64");
  }
  refuse_masked(out, "out");
  out_ = py::reinterpret_borrow<py::array>(out);
  const py::dtype type = out_->dtype();
  if (!type.equal(py::dtype::of<float>()) && !type.equal(py::dtype::of<double>())) {
    throw UsageError("out: numbers of " + std::string(py::str(type)) + "; give float32 or float64");
  }
  if (shape_of(*out_) != shape_) {
    throw UsageError("out: shape " + text_of(shape_of(*out_)) + "; give " + text_of(shape_));
  }
  if (!out_->writeable()) throw UsageError("out: a read-only array; give one to write to");
  is_float_ = is_float32(type);
}

void Target::open() {
  room_ = py::array(is_float_ ? py::dtype::of<float>() : py::dtype::of<double>(), shape_);
  numbers_ = room_.mutable_data();
}

void Target::write(Eigen::Index first, const Points& rows) {
  if (!is_float_) return put_rows<double>(numbers_, first, rows);
  if (const auto row = beyond_float(rows)) {
    throw Error("point " + std::to_string(first + *row) +
                " is beyond what float32 holds; give points or out of float64");
  }
  put_rows<float>(numbers_, first, rows);
}

py::array Target::take() const {
  if (!out_) return room_;
  out_->attr("__setitem__")(py::ellipsis(), room_);
  return *out_;
}

py::array Target::take(Points points) {
  if (!out_ && !is_float_) return owning(std::move(points), shape_);
  open();
  write(0, points);
  return take();
}

py::array new_array(const Shape& shape, const double* data) {
  return py::array_t<double>(shape, data);
}

py::array read_only(py::array array) {
  array.attr("flags").attr("writeable") = false;
  return array;
}

}  // namespace hwffd::python
