#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "hwffd/lattice/lattice.hpp"

namespace hwffd {

/// A way to move the control points of a lattice. Up is the y axis; the top and bottom of
/// a lattice are its last and first layer along t, left and right its first and last along s.
///
/// - `none`: nothing moves
/// - `twist:DEGREES`: the top 4 corners turn about the vertical line through the lattice's centre,
///   counterclockwise seen from above (paper, section 6)
/// - `shear:AMOUNT`: the bottom left corners sink, the bottom right corners rise, by AMOUNT times
///   the lattice's height (paper, section 6)
/// - `bend:DEGREES`: the vertical centre line becomes an arc of that angle towards +x; the bottom
///   layer stays
/// - `random:SEED`: every point moves by up to 0.3 spacings along each axis, independently
///
/// Twist and shear move the 8 corners; all other points follow by trilinear interpolation of the
/// corners' displacements, which in a box lattice is the paper's interpolation of positions.
/// Without an argument: twist 90, shear 0.5, bend 90, random 1.
class Deformation {
 public:
  enum class Kind { kNone, kTwist, kShear, kBend, kRandom };

  /// @throws UsageError for an unknown name, an argument that is not a finite number (for random:
  ///   an integer from 0 to 2^64 - 1), or an argument to none
  static Deformation parse(std::string_view text);

  Kind kind() const { return kind_; }
  /// Degrees (twist, bend) or fraction of the height (shear).
  double amount() const { return amount_; }
  std::uint64_t seed() const { return seed_; }

  /// The lattice with its points moved; same dimensions.
  Lattice apply(const Lattice& lattice) const;

 private:
  Deformation(Kind kind, double amount, std::uint64_t seed)
      : kind_(kind), amount_(amount), seed_(seed) {}

  Kind kind_;
  double amount_;
  std::uint64_t seed_;
};

}  // namespace hwffd
