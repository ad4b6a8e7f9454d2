#pragma once

#include <Eigen/Core>
#include <array>

#include "hwffd/points.hpp"

namespace hwffd {

/// The map of the four control points of an axis from one family of blending functions to another
/// (paper, section 3.1): P' = K P, so that `to` with P' is the same curve as `from` with P.
/// With the functions as rows P^T C_from = P'^T C_to, hence K = C_to^-T C_from^T.
/// @param from, to  4 x 4: row l is the function B_l, the columns are the coefficients of 1, x,
///                  x^2, x^3 (Oracle::Coefficients)
/// Throws Error where `to` does not span the cubics, as with degrees below 3.
Eigen::Matrix4d conversion(const Eigen::Matrix4d& from, const Eigen::Matrix4d& to);

/// A support through the maps of its axes s, t, u, one axis after the other.
Support convert(const Support& support, const std::array<Eigen::Matrix4d, 3>& axes);

/// Operations on single numbers.
struct Operations {
  int multiplications = 0;
  int additions = 0;
};

/// What `convert` costs a cell: what a coefficient file saves it (paper, section 3.3.3). Counts the
/// 16 rows of points, each of 3 components, along each axis; entries 0 cost nothing, entries 1 and
/// -1 no multiplication. Entries closer to these than 1e-12 count as them.
Operations conversion_operations(const std::array<Eigen::Matrix4d, 3>& axes);

}  // namespace hwffd
