#pragma once

#include <array>
#include <vector>

#include "hwffd/lattice/family.hpp"
#include "hwffd/lattice/lattice.hpp"

namespace hwffd {

/// Where a lattice is joined to itself: found in its points, so that any lattice file may have it.
///
/// - An axis is *closed* if its last three layers of points repeat its first three: its last cell
///   then meets its first with C2 continuity. Of the families that are not regular() the last layer
///   repeats the first, and the cells meet with C0.
/// - A face of the outer cells is *collapsed* along an axis in it if moving along that axis
///   does not move the point: the axis of a cylinder along u, the centre of a sphere along t and u.
///
/// Control points that move one by one tear these joints; restore() closes them again.
class Closure {
 public:
  /// A face of the outer cells, collapsed along one of its axes.
  struct Collapsed {
    int axis = 0;   ///< the face is where the coordinate along this axis ends,
    int end = 0;    ///< at its beginning (0) or end (1)
    int along = 0;  ///< and does not depend on the coordinate along this one
  };

  /// Joints of a lattice whose cells are of a family, to within 1e-12 of its size, or of the
  /// rounding of coordinates where it lies far from the origin.
  explicit Closure(const Lattice& lattice, const Family& family = {});

  /// How many layers at the beginning of an axis are repeated at its end: 0 if it is not closed.
  int repeated(int axis) const { return repeated_[static_cast<std::size_t>(axis)]; }
  bool closed(int axis) const { return repeated(axis) > 0; }
  /// Whether there is any joint.
  bool joined() const { return repeated_ != std::array<int, 3>{} || !collapsed_.empty(); }
  const std::vector<Collapsed>& collapsed() const { return collapsed_; }

  /// A moved lattice with its joints closed again. The layers of a closed axis go to those that
  /// repeat them. On a collapsed face the outermost layer of points that the face is made of moves,
  /// that beyond it in a B-spline, so that the face lies at its mean along the collapsed axis; the
  /// other layers stay. Without joints the lattice comes back bit for bit.
  /// @param moved  of the same dimensions
  /// @throws Error if the dimensions differ
  Lattice restore(const Lattice& moved) const;
  /// The transpose of restore(): of the gradient of a number with respect to the points of the
  /// closed lattice, a row for each, that with respect to those of the moved one.
  Points pull_back(Points gradient) const;

 private:
  Index3 dims_;
  Family family_;
  std::array<int, 3> repeated_{};
  std::vector<Collapsed> collapsed_;
};

}  // namespace hwffd
