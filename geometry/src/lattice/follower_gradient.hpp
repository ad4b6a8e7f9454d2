#pragma once

#include <Eigen/Core>

#include "hwffd/lattice/outside.hpp"
#include "hwffd/oracle/oracle.hpp"

namespace hwffd {

/// A point outside a lattice, and the nearest place of the lattice, which it follows.
struct Following {
  Point point;            ///< at rest
  Eigen::Vector3d local;  ///< of the place
  Support rest;           ///< of its cell
  Oracle::Jet deformed;   ///< at the place
};

/// The derivative of the map x -> x + w(|x - p|) (D(p) - p) at the point, where p is the place of
/// the lattice nearest to x, D its place in the deformed lattice and w Outside::weight(): p moves
/// along the face, edge or corner that the lattice ends at there. NaN where p jumps (centres of
/// curvature) or the faces are collapsed.
Eigen::Matrix3d follower_gradient(const Following& following, const Outside& outside);

}  // namespace hwffd
