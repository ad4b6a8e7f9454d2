#pragma once

#include <array>
#include <cstdint>
#include <optional>

#include "hwffd/lattice/lattice.hpp"

namespace hwffd {

/// What a movement of a lattice's points goes by: its eight corners, and where between them every
/// point is. They are the points at the ends of the axes, and points are where their index says;
/// of a lattice joined to itself the corners of the bounding box, s along x, t along y, u along z,
/// and points are where they are.
class Frame {
 public:
  /// Eight points or displacements: corner (a, b, c), each 0 or 1 along s, t, u, is row
  /// a*4 + b*2 + c.
  using Corners = Eigen::Matrix<double, 8, 3, Eigen::RowMajor>;

  /// @param joined  of a lattice joined to itself the points whose bounding box has the corners
  /// @param up  the axis that heights are along: 0, 1, 2 for x and s, y and t, z and u
  Frame(const Lattice& lattice, const std::optional<Points>& joined, int up);

  int up() const { return up_; }

  const Corners& corners() const { return corners_; }
  Eigen::RowVector3d centre() const { return corners_.colwise().mean(); }

  bool is_top(int corner) const { return at_end(corner, up_); }
  /// Whether a corner is at the end of an axis, not at its beginning.
  static bool at_end(int corner, int axis) { return (corner >> (2 - axis) & 1) != 0; }

  /// Height of the middle of the bottom corners, and of the top corners above it.
  double bottom() const { return level(false); }
  double height() const { return level(true) - level(false); }

  /// Mean step from point to point: row a along axis a.
  Eigen::Matrix3d spacing() const;

  /// Moves every point by the trilinear interpolation of the corners' displacements.
  void interpolate(Points& points, const Corners& displacement) const;

 private:
  double level(bool top) const;

  Index3 dims_;
  int up_;
  Corners corners_;
  Points fractions_;  ///< of each point, 0 to 1 along s, t, u
};

/// The movements of Deformation, of that name (random: jitter). They take the points of the lattice
/// that the frame is of.
void twist(Points& points, const Frame& frame, double degrees);
/// @param cells  heights of what the lattice holds, bottom and top
void helix(Points& points, const Frame& frame, double degrees, const std::array<double, 2>& cells);
void shear(Points& points, const Frame& frame, double amount);
/// @param towards  the axis that the line along up() bends to, another one
void bend(Points& points, const Frame& frame, double degrees, int towards);
void taper(Points& points, const Frame& frame, double factor);
void scale(Points& points, const Frame& frame, const Eigen::Vector3d& factors);
void jitter(Points& points, const Frame& frame, std::uint64_t seed);

}  // namespace hwffd
