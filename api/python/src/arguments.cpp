#include "arguments.hpp"

#include <cmath>
#include <limits>
#include <string>

#include "hwffd/error.hpp"

namespace hwffd::python {
namespace {

/// What was given, as Python writes it; its kind, where it does not.
std::string written(const py::handle& object) {
  const auto text = py::reinterpret_steal<py::object>(PyObject_Repr(object.ptr()));
  if (text) return excerpt(text.cast<std::string>());
  PyErr_Clear();
  return std::string("an object of kind ") + Py_TYPE(object.ptr())->tp_name;
}

[[noreturn]] void refuse(const py::handle& given, const std::string& name,
                         const std::string& give) {
  throw UsageError(name + ": " + written(given) + "; give " + give);
}

/// Calls of Python that can fail leave an exception, which is answered for by refuse().
template <typename Value>
Value checked(Value value, bool& good) {
  if (PyErr_Occurred() == nullptr) return value;
  PyErr_Clear();
  good = false;
  return Value{};
}

long long integer(const py::handle& object, bool& good) {
  const auto number = py::reinterpret_steal<py::object>(PyNumber_Index(object.ptr()));
  checked(0, good);
  return number ? checked(PyLong_AsLongLong(number.ptr()), good) : 0;
}

double real(const py::handle& object, bool& good) {
  const double number = checked(PyFloat_AsDouble(object.ptr()), good);
  good = good && std::isfinite(number);
  return number;
}

template <typename Number, typename Get>
std::array<Number, 3> three(const py::handle& numbers, const std::string& name,
                            const std::string& give, const Get& get) {
  const bool text = PyUnicode_Check(numbers.ptr()) || PyBytes_Check(numbers.ptr());
  const auto list =
      py::reinterpret_steal<py::object>(text ? nullptr : PySequence_Tuple(numbers.ptr()));
  bool good = !text;
  checked(0, good);
  good = good && PyTuple_GET_SIZE(list.ptr()) == 3;
  std::array<Number, 3> result{};
  for (std::size_t axis = 0; good && axis < 3; ++axis) {
    const auto at = static_cast<py::ssize_t>(axis);
    result[axis] = static_cast<Number>(get(PyTuple_GET_ITEM(list.ptr(), at), good));
  }
  if (!good) refuse(numbers, name, give);
  return result;
}

}  // namespace

long long read_integer(const py::handle& number, const char* name, long long least,
                       long long most) {
  bool good = true;
  const long long value = integer(number, good);
  if (good && value >= least && value <= most) return value;
  refuse(number, name, "an integer from " + std::to_string(least) + " to " + std::to_string(most));
}

Index3 read_integers(const py::handle& numbers, const char* name, const char* give) {
  return three<int>(numbers, name, std::string(give) + ", three integers",
                    [](const py::handle& object, bool& good) {
                      const long long value = integer(object, good);
                      good = good && value >= std::numeric_limits<int>::min() &&
                             value <= std::numeric_limits<int>::max();
                      return value;
                    });
}

std::array<double, 3> read_numbers(const py::handle& numbers, const char* name, const char* give) {
  return three<double>(numbers, name, std::string(give) + ", three finite numbers", real);
}

std::array<double, 3> read_number_or_three(const py::handle& numbers, const char* name,
                                           const char* give) {
  bool good = PyNumber_Check(numbers.ptr()) != 0 && PySequence_Check(numbers.ptr()) == 0;
  const double number = good ? real(numbers, good) : 0.0;
  if (good) return {number, number, number};
  return three<double>(numbers, name, std::string(give) + ", one or three finite numbers", real);
}

}  // namespace hwffd::python
