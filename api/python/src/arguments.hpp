#pragma once

#include <pybind11/pybind11.h>

#include <array>

#include "hwffd/points.hpp"

namespace hwffd::python {

namespace py = pybind11;

/// A whole number of Python or NumPy.
/// @param name  of the argument, for messages
/// @throws UsageError for anything else, and for a number that is not within least and most
long long read_integer(const py::handle& number, const char* name, long long least, long long most);

/// Three of them, as a tuple, list or array, for something along three axes.
/// @param give  what is wanted, for messages: "(ns, nt, nu)"
/// @throws UsageError for anything else
Index3 read_integers(const py::handle& numbers, const char* name, const char* give);

/// Three finite numbers.
/// @throws UsageError for anything else
std::array<double, 3> read_numbers(const py::handle& numbers, const char* name, const char* give);

/// One such number for all three axes, or three.
/// @throws UsageError for anything else
std::array<double, 3> read_number_or_three(const py::handle& numbers, const char* name,
                                           const char* give);

}  // namespace hwffd::python
