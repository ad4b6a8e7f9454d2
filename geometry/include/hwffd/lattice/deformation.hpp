#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "hwffd/lattice/closure.hpp"
#include "hwffd/lattice/lattice.hpp"

namespace hwffd {

/// A way to move the control points of a lattice. Up is the y axis; the top and bottom of
/// a lattice are its last and first layer along t, left and right its first and last along s.
///
/// - `none`: nothing moves
/// - `twist:DEGREES`: the top 4 corners turn about the vertical line through the lattice's centre,
///   counterclockwise seen from above (paper, section 6)
/// - `helix:DEGREES`: every point turns about that line by an angle that is linear in its height,
/// so
///   that what the cells hold turns by DEGREES from their bottom to their top
/// - `shear:AMOUNT`: the bottom left corners sink, the bottom right corners rise, by AMOUNT times
///   the lattice's height (paper, section 6)
/// - `bend:DEGREES`: the vertical centre line becomes an arc of that angle towards +x; the bottom
///   layer stays
/// - `taper:FACTOR`: horizontal distances from the vertical centre line grow by a factor that
///   is linear in the height: 1 at the bottom, FACTOR at the top
/// - `scale:F` or `scale:FX,FY,FZ`: distances from the lattice's centre grow by F, or by a factor
///   for each of x, y, z
/// - `random:SEED`: every point moves by up to 0.3 spacings along each axis, independently
/// - `move:I,J,K:DX,DY,DZ`: point (I, J, K) moves by DX, DY, DZ in object units
/// - `to:FILE`: the points become those of a lattice file of the same dimensions, as they are there
///
/// After twist, helix, bend and taper may stand an axis, as in `twist:90:x`: x, y or z, along which
/// is then up, with bottom and top its first and last layer (along s, t, u). A bend goes from y
/// towards x, from z towards y, from x towards z, or as two axes say: `bend:90:yz` from y towards
/// z.
///
/// Twist and shear move the 8 corners; all other points follow by trilinear interpolation of the
/// corners' displacements, which in a box lattice is the paper's interpolation of positions.
///
/// In a lattice that is joined to itself (Closure) the corners are those of the bounding box of its
/// control points, s along x, t along y, u along z, and points follow by where they are in it, so
/// that points in one place stay together. Its joints are closed again afterwards; a point that
/// move names takes its repetitions along. to is not touched up.
///
/// Without an argument: twist and helix 90, shear 0.5, bend 90, taper 0.5, scale 1.5, random 1.
class Deformation {
 public:
  enum class Kind { kNone, kTwist, kHelix, kShear, kBend, kTaper, kScale, kRandom, kMove, kTo };

  /// What the text after the name gave.
  struct Arguments {
    /// Degrees (twist, helix, bend), fraction of the height (shear), factor (taper).
    double amount = 0.0;
    int axis = 1;            ///< that is up: 0, 1, 2 for x, y, z (twist, helix, bend, taper)
    int towards = 0;         ///< the axis that up bends to
    std::uint64_t seed = 0;  ///< random
    Eigen::Vector3d vector{0, 0, 0};  ///< factors (scale) or displacement (move) along x, y, z
    Index3 place{0, 0, 0};            ///< the point that moves
    std::string file;                 ///< to
  };

  /// @throws UsageError for an unknown name, an argument that is missing or not of the form above
  ///   (finite numbers, at most a million degrees, factors of scale other than 0; for random an
  ///   integer from 0 to 2^64 - 1), or an argument to none
  static Deformation parse(std::string_view text);

  /// The deformation `move` of a control point, its numbers from 0, by a finite vector.
  static Deformation move(const Index3& place, const Eigen::Vector3d& by);

  Kind kind() const { return kind_; }
  double amount() const { return arguments_.amount; }
  std::uint64_t seed() const { return arguments_.seed; }
  const Arguments& arguments() const { return arguments_; }

  /// The lattice with its points moved; same dimensions.
  /// @param family  of its cells, which say what helix turns by its angle and where joints are
  /// @throws Error if the lattice has no point that move names, if to's file cannot be read, has
  ///   other dimensions or names another family, or if a point would not be finite
  Lattice apply(const Lattice& lattice, const Family& family = {}) const;

 private:
  Deformation(Kind kind, Arguments arguments) : kind_(kind), arguments_(std::move(arguments)) {}

  Points moved(const Lattice& lattice, const Family& family, const Closure& closure) const;

  Kind kind_;
  Arguments arguments_;
};

/// One deformation after the other, in this order.
/// @throws Error as Deformation::apply
Lattice deform_lattice(const Lattice& lattice, const std::vector<Deformation>& deformations,
                       const Family& family = {});

}  // namespace hwffd
