#pragma once

#include <fmt/format.h>

#include <Eigen/LU>
#include <cmath>

#include "hwffd/error.hpp"
#include "hwffd/lattice/lattice.hpp"

namespace hwffd {

/// The lattice with the point at(i, j, k) in every place.
/// @throws Error for dims out of range (Lattice)
template <typename F>
Lattice generate_lattice(const Index3& dims, F at) {
  Lattice::check_dims(dims);
  Points points(static_cast<Eigen::Index>(dims[0]) * dims[1] * dims[2], 3);
  Eigen::Index row = 0;
  for (const auto& [i, j, k] : places(dims)) points.row(row++) = Point(at(i, j, k));
  return Lattice(dims, std::move(points));
}

/// Throws Error unless an origin and three edges (columns) are finite and span a volume.
inline void check_frame(const char* shape, const Point& origin, const Eigen::Matrix3d& edges) {
  const double scale = edges.col(0).norm() * edges.col(1).norm() * edges.col(2).norm();
  const bool spans = std::abs(edges.determinant()) > 1e-9 * scale;
  if (spans && origin.allFinite() && edges.allFinite() && edges.inverse().allFinite()) return;
  throw Error(fmt::format(
      "{} lattice: its three edges span no volume; give finite edges in three directions", shape));
}

}  // namespace hwffd
