#pragma once

#include <string>

#include "compare/scene.hpp"

namespace hwffd::compare {

/// A program of this project on one core of this processor.
struct SoftwareRow {
  std::string what;
  bool sorted = false;
  double vertices_per_s = 0;    ///< the best of several runs
  double error = 0;             ///< the largest of a component, against the oracle
  double bound = 0;             ///< that it is held to
  double latency_ns = 0;        ///< of a call with one vertex, its data in cache; 0: not measured
  double bytes_per_vertex = 0;  ///< of arrays that are read and written; the lattice stays in cache
};

/// LatticeEvaluator on arrays. Real is float or double.
/// @param seconds  for which it is run, again and again; several times at least
template <class Real>
SoftwareRow evaluator(const Scene& scene, bool sorted, double seconds);

/// A device by its library's interface, cells and coordinates checked: "reference", or the bit-true
/// model of a row of the table.
/// @param row  empty for the reference
SoftwareRow device(const std::string& row, const Scene& scene, bool sorted, double seconds);

/// The walker of a row's bit-true model over a grid, to words.
/// @param row  one that contracts one axis after the other
SoftwareRow walker(const std::string& row, const GridScene& grid, double seconds);

/// A device as above that is given a grid.
SoftwareRow grid_device(const std::string& row, const GridScene& grid, double seconds);

/// The vector units for which LatticeEvaluator is compiled that this processor has, the widest.
std::string vector_units();

/// What the error of a number format is held to, of control points in [-1, 1).
/// @param format  "fp32", "bfp32", or "fx" and the width of a word
double error_bound(const std::string& format);

}  // namespace hwffd::compare
