#pragma once

#include <optional>

#include "hwffd/lattice/family.hpp"
#include "hwffd/lattice/lattice.hpp"
#include "view/screen.hpp"

namespace hwffd::view {

/// A lattice whose control points a mouse takes hold of and moves, in the plane through the point
/// that is parallel to the screen. In a lattice that is joined to itself (Closure) the joints stay
/// closed, as with the deformation `move`.
class LatticeDrag {
 public:
  static constexpr double kReach = 12;  ///< pixels between mouse and a point it takes hold of

  /// @param family  of the lattice, which says what its joints are
  LatticeDrag(Lattice lattice, const Family& family);

  const Lattice& lattice() const { return lattice_; }

  /// Takes hold of the point nearest to the mouse, if one is within reach; of points in one place
  /// that nearest to the eye. Returns whether there is one.
  bool grab(const Screen& screen, const Pixels& mouse);
  bool holds() const { return held_.has_value(); }
  /// The point that is held follows the mouse.
  /// @param screen  with the camera of grab()
  void drag(const Screen& screen, const Pixels& mouse);
  void release() { held_.reset(); }

  /// Lets go, and the lattice is what it was at the beginning.
  void reset();

 private:
  struct Held {
    Index3 place;     ///< of the control point
    double depth;     ///< of the plane in which it moves
    Pixels offset;    ///< from the mouse to the point
    Lattice lattice;  ///< when it was grabbed
  };

  Lattice first_;
  Lattice lattice_;
  Family family_;
  std::optional<Held> held_;
};

}  // namespace hwffd::view
