#pragma once

#include <vector>

#include "hwffd/points.hpp"

namespace hwffd {

/// All places in a grid of that many along s, t and u, in the order of Lattice::index().
std::vector<Index3> places(const Index3& counts);

/// A lattice of n_s x n_t x n_u control points, of any shape (paper, section 2). Point (i, j, k),
/// i along s, j along t, k along u, has the index (i*n_t + j)*n_u + k: u runs fastest. In a 4 x 5 x
/// 6 lattice (0, 0, 1) is point 1, (0, 1, 0) is point 6 and (1, 0, 0) is point 30.
///
/// Four points an axis span one cell of eq. (1), so an axis of n points has n - 3 cells. Cell
/// (c_s, c_t, c_u) is deformed by the points c..c+3 of each axis; with uniform cubic B-splines
/// and regular points it fills the space between the points c+1 and c+2.
class Lattice {
 public:
  static constexpr int kFewestPoints = 2;  ///< of families that take them (few_points.hpp)
  static constexpr int kMinPoints = 4;     ///< with a cell
  static constexpr int kMaxPoints = 64;

  /// @param dims points an axis, each 2 to 64
  /// @param points dims[0]*dims[1]*dims[2] x 3, in the order above
  /// @throws Error for dimensions out of range, a wrong number of points, or a point that is not
  ///   finite or beyond kLargestCoordinate
  Lattice(const Index3& dims, Points points);

  /// Throws Error unless each axis has `least` to 64 points; with four it has a cell.
  static void check_dims(const Index3& dims, int least = kMinPoints);

  const Index3& dims() const { return dims_; }
  /// Cells along each axis; 0 along one of 2 or 3 points.
  Index3 cells() const;

  /// All points, n x 3, in the order of index().
  const Points& points() const { return points_; }

  /// Row of point (i, j, k); each in 0..dims - 1, unchecked.
  Eigen::Index index(int i, int j, int k) const {
    return (static_cast<Eigen::Index>(i) * dims_[1] + j) * dims_[2] + k;
  }
  Eigen::Index index(const Index3& at) const { return index(at[0], at[1], at[2]); }
  Point point(int i, int j, int k) const { return points_.row(index(i, j, k)); }
  Point point(const Index3& at) const { return points_.row(index(at)); }

  /// The 64 control points that deform a cell: row (l*4 + m)*4 + n is point (c_s+l, c_t+m, c_u+n).
  /// @throws Error if the lattice has no such cell
  Support support(const Index3& cell) const;

 private:
  Index3 dims_;
  Points points_;
};

/// The lattice between two: every point on the straight line from its place in a to its place
/// in b. At 0 it is a, at 1 it is b, bit for bit; below 0 and above 1 the lines go on.
/// @throws Error if the dimensions differ or a point would not be finite
Lattice between(const Lattice& a, const Lattice& b, double fraction);

/// Where a vertex lies in the lattice that it was embedded in: eq. (1) with the cell's support and
/// these local coordinates gives the vertex back.
struct Embedded {
  Index3 cell{0, 0, 0};
  Eigen::Vector3d local{0, 0, 0};  ///< s, t, u; in [0, 1] if inside
  bool inside = false;             ///< false: beyond the outer cells, cell is the nearest one
};

}  // namespace hwffd
