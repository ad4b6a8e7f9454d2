#pragma once

#include <vector>

#include "hwffd/points.hpp"

namespace hwffd {

/// Normals of a surface where a deformation has taken it, n x 3, of length 1: the direction of the
/// gradient's cofactors times the normal, the side that it was on. A row is NaN where the gradient
/// is not known (Attachment::gradients) or singular, or the normal has no direction.
/// @param gradients  of the map at each point
/// @param normals    at rest, n x 3, of any length
/// @throws Error for another number of normals
Points carried_normals(const std::vector<Eigen::Matrix3d>& gradients, const Points& normals);

}  // namespace hwffd
