#pragma once

#include "hwffd/lattice/bezier_volume.hpp"
#include "newton.hpp"

namespace hwffd {

/// What a bisection of a cell found.
struct CellSearch {
  enum class Outcome { kFound, kExcluded, kUndecided };
  Outcome outcome = Outcome::kExcluded;
  Attempt attempt;     ///< the place if found
  int iterations = 0;  ///< Newton steps of all starts
};

/// Finds a point in a cell or proves that it is not there: halves the cell along all axes, drops
/// parts whose Bernstein coefficients exclude the point, starts newton() in the middle of the
/// others.
/// @param hull      the cell in Bernstein form
/// @param done      residual at which newton() is done
/// @param tolerance residual at which the point counts as found
CellSearch search_cell(const Oracle& oracle, const Support& support, const BezierVolume& hull,
                       const Point& point, double done, double tolerance);

}  // namespace hwffd
