#pragma once

#include "hwffd/oracle/oracle.hpp"

namespace hwffd {

/// Where a search in one cell ended.
struct Attempt {
  Eigen::Vector3d local{0.5, 0.5, 0.5};  ///< s, t, u, in [0, 1]
  double residual = 0.0;                 ///< distance from the point, in object space
  int iterations = 0;                    ///< systems solved
};

/// The uniform B-spline's four functions at a place in a cell, and their first two derivatives.
Eigen::Matrix<double, 4, 3> uniform_functions(double x);

/// What the second derivatives of eq. (1) add to those of half the squared distance from a point.
/// @param difference  eq. (1) there, less the point
Eigen::Matrix3d curvature(const Support& support, const Eigen::Vector3d& local,
                          const Eigen::Vector3d& difference);

/// Newton-Raphson on eq. (2) from a start: finds local coordinates of point in a cell. Damped: a
/// step is halved until the residual falls, and kept within half a cell of the cell; it ends where
/// no step helps. What it finds beyond the cell is moved to the nearest face.
/// @param tolerance residual at which it is done
Attempt newton(const Oracle& oracle, const Support& support, const Point& point,
               const Eigen::Vector3d& start, double tolerance);

/// The point of the cell nearest to one outside it, or one where no step brings it nearer: Newton's
/// method on half the squared distance, damped, within the cell.
/// @param start in the cell
Attempt nearest(const Oracle& oracle, const Support& support, const Point& point,
                const Eigen::Vector3d& start);

}  // namespace hwffd
