#pragma once

#include <Eigen/Core>

namespace hwffd {

/// A gradient, scaled so that its largest entry is 1: its direction counts, and products of its
/// entries must not overflow. Zero if it is not known: not finite, or singular.
Eigen::Matrix3d known(const Eigen::Matrix3d& gradient);

/// Inverse transpose times determinant: the image of an area vector.
Eigen::Matrix3d cofactor(const Eigen::Matrix3d& g);

}  // namespace hwffd
