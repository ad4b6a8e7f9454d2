#pragma once

#include <vector>

#include "built_core.hpp"
#include "hwffd/model/configuration.hpp"

namespace hwffd::test {

/// A simulated `hwffd_scatter`.
struct ScatterBuild : BuiltCore {
  Configuration row;  ///< as one of `affine`, whose weights it has
  int axis;           ///< points an axis, at most
  int pages;
  bool rows;  ///< its parameter ROWS: grids go by rows
};

/// All cores of the program, which CMake makes of scatter_cores.csv.
std::vector<ScatterBuild> scatter_builds();

/// The row of `affine` whose weights a scatter core of that format and evaluator has.
inline Configuration transposed_row(const char* format, const char* evaluator) {
  Configuration row = find_configuration("affine-fx17-overlapped");
  row.format = format;
  row.evaluator = evaluator;
  return row;
}

}  // namespace hwffd::test
