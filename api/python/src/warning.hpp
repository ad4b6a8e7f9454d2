#pragma once

#include <pybind11/pybind11.h>

#include <string>

namespace hwffd::python {

/// A UserWarning at the line of the program that called.
/// @throws error_already_set where warnings are errors
inline void warn(const std::string& text) {
  constexpr pybind11::ssize_t kCaller = 2;  // of the function of Python around those here
  if (PyErr_WarnEx(PyExc_UserWarning, text.c_str(), kCaller) == 0) return;
  throw pybind11::error_already_set();
}

}  // namespace hwffd::python
