#pragma once

#include <string_view>

namespace hwffd {

/// What becomes of points outside the cells of a lattice.
///
/// - `keep`: they stay where they are
/// - `clamp`: they move as the nearest place of the lattice does: local coordinates are clamped as
///   the hardware clamps them, and the vector from that place to the point is carried along
/// - `fade:WIDTH`: the same displacement, fading to nothing at the distance WIDTH from the lattice
class Outside {
 public:
  enum class Kind { kKeep, kClamp, kFade };

  /// @throws UsageError for an unknown name, a width that is not a finite number above 0, a width
  ///   missing, or an argument to keep or clamp
  static Outside parse(std::string_view text);

  Kind kind() const { return kind_; }
  /// Of fade, in object units; 0 for the others.
  double width() const { return width_; }

  /// The part of the nearest place's displacement that a point outside follows: 0 for keep, 1 for
  /// clamp; for fade 1 - 3x^2 + 2x^3 with x = distance / width up to 1, beyond it 0. So the weight
  /// and its slope are continuous.
  /// @param distance from the lattice, at least 0
  double weight(double distance) const;
  /// Its derivative.
  double slope(double distance) const;

 private:
  Outside(Kind kind, double width) : kind_(kind), width_(width) {}

  Kind kind_;
  double width_;
};

}  // namespace hwffd
