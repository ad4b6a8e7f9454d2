#pragma once

#include <optional>
#include <vector>

#include "hwffd/lattice/bezier_volume.hpp"
#include "hwffd/lattice/box.hpp"
#include "hwffd/lattice/family.hpp"
#include "hwffd/lattice/lattice.hpp"

namespace hwffd {

/// The place of a lattice nearest to a point outside its cells.
///
/// In a box with right angles that is the point's coordinates, clamped. In any other lattice it is
/// on the faces that the lattice ends at: all outer faces but those where it is joined to itself
/// (Closure; families that are not regular end at all of them). Each face lies in the convex hull
/// of its Bernstein coefficients, so their distance from the point bounds that of the face from
/// below, and every place tried bounds it from above. Faces that may be nearer than the best place
/// so far are searched by Newton's method within their cell, then quartered, best first, until none
/// can be nearer by more than 1e-7 of the lattice's size.
///
/// In a folded lattice the surface may also be inside the cells: then the place found is one of
/// those faces, or one nearer to the point that Newton's method met.
class NearestPlace {
 public:
  explicit NearestPlace(const Lattice& lattice, const Family& family = {});

  struct Result {
    Embedded at;            ///< inside is true: eq. (1) gives `point`
    Point point;            ///< the place in object space
    double distance = 0.0;  ///< from the point asked for
    int parts = 0;          ///< faces and parts of faces looked at
  };

  /// @param point outside the cells, finite
  Result find(const Point& point) const;

 private:
  /// An outer face of a cell; its points are relative to centre_.
  struct Face {
    Index3 cell;
    int axis;
    int end;
    BezierVolume hull;
    Point low, high;
  };
  class Search;

  Support support(const Index3& cell) const { return family_.support(lattice_, cell); }

  Family family_;
  std::optional<Box> box_;  ///< if it has right angles
  Point centre_;
  Lattice lattice_;  ///< relative to centre_, so that one far away loses no digits
  double size_ = 0.0;
  std::vector<Face> faces_;
};

}  // namespace hwffd
