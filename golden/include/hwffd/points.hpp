#pragma once

#include <Eigen/Core>
#include <array>

namespace hwffd {

/// One point of object space: x, y, z in the model's own unit. The y axis points up.
using Point = Eigen::Vector3d;

/// A list of points, n x 3, one point a row.
using Points = Eigen::Matrix<double, Eigen::Dynamic, 3, Eigen::RowMajor>;

/// The 64 control points that one cell sees, 64 x 3, row (l*4 + m)*4 + n: l along s, m along t,
/// n along u, so n runs fastest.
using Support = Eigen::Matrix<double, 64, 3, Eigen::RowMajor>;

/// One integer for each axis, in the order s, t, u.
using Index3 = std::array<int, 3>;

}  // namespace hwffd
