#pragma once

#include <Eigen/Core>
#include <functional>

#include "hwffd/lattice/lattice.hpp"

namespace hwffd {

/// How the control points of an axis follow from those of another lattice: point `at` is the sum of
/// `weights` times its points from `first`.
struct AxisPoint {
  int first;
  Eigen::RowVector4d weights;
};
using AxisPoints = std::function<AxisPoint(int axis, int at)>;

/// The lattice of other points, one axis after the other.
Lattice mapped(const Lattice& lattice, const Index3& dims, const AxisPoints& point_of);

/// The transpose: of a gradient with respect to these other points that with respect to the
/// lattice's.
/// @param gradient  a row for each point of a lattice of `dims`
/// @param lattice   points an axis of the lattice
Points mapped_back(const Points& gradient, const Index3& dims, const Index3& lattice,
                   const AxisPoints& point_of);

}  // namespace hwffd
