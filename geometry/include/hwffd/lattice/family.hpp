#pragma once

#include <array>
#include <string>
#include <string_view>
#include <vector>

#include "hwffd/lattice/lattice.hpp"
#include "hwffd/oracle/oracle.hpp"

namespace hwffd {

/// A family of blending functions, and how the control points of a lattice of n points an axis make
/// its cells.
///
/// - `bspline`: uniform cubic B-splines, n - 3 cells, C2; all of the project's own
/// - `clamped`: cubic B-splines with clamped knots, 0, 0, 0, 0, 1, 2, ..., n-3, n-3, n-3, n-3. The
///   first and last points are the ends of the axis; n - 3 cells, C2
/// - `bernstein`: Bezier volumes of degree 3. A cell has points 3c to 3c + 3, and shares its last
///   with the next: n is 4, 7, 10, ..., 49, there are (n - 1)/3 cells, C0
/// - `catmull-rom`: through the control points but the first and last layers, n - 3 cells, C1
/// - `linear`: straight between these points, n - 3 cells, C0
class Family {
 public:
  enum class Kind { kBspline, kClamped, kBernstein, kCatmullRom, kLinear };

  /// bspline
  Family() = default;
  explicit Family(Kind kind) : kind_(kind) {}

  /// @throws UsageError for a name that is none of names(), which it lists
  static Family parse(std::string_view name);
  static const std::vector<std::string>& names();

  Kind kind() const { return kind_; }
  const std::string& name() const;

  /// Whether all cells have the same functions, which keep straight what is straight: regular
  /// points then make the box that they make as B-splines.
  bool regular() const { return kind_ != Kind::kClamped && kind_ != Kind::kBernstein; }

  /// Whether an axis may have 2 or 3 points (few_points.hpp).
  bool takes_few() const { return kind_ != Kind::kBspline && kind_ != Kind::kClamped; }

  /// @throws Error for points an axis that the family cannot evaluate
  void check_dims(const Index3& dims) const;
  /// Cells along each axis of a lattice with that many points.
  Index3 cells(const Index3& dims) const;
  /// The first of the four control points of a cell along an axis.
  int first(int cell) const { return kind_ == Kind::kBernstein ? 3 * cell : cell; }
  /// The functions of a cell along an axis of that many points.
  Oracle::Coefficients functions(int points, int cell) const;

  /// The 64 control points of the uniform B-spline that maps a cell as this family does, to within
  /// rounding; those of the lattice, bit for bit, where this is that family.
  /// @throws Error if the lattice has no such cell
  Support support(const Lattice& lattice, const Index3& cell) const;

  /// Points an axis of a B-spline lattice with as many cells.
  Index3 bspline_dims(const Index3& dims) const;
  /// The lattice that maps its cells as B-splines map those of a lattice: exactly for clamped and
  /// bernstein; for the others the same points.
  /// @throws Error for cells that the family cannot have
  Lattice from_bspline(const Lattice& lattice) const;

  /// A lattice as devices evaluate it: its cells lie `step` cells apart in each axis of `lattice`,
  /// whose functions are the same in all of them.
  struct Evaluable {
    Lattice lattice;
    std::array<Oracle::Coefficients, 3> blending;
    int step = 1;

    /// A place of the lattice of the family in this one.
    Embedded at(const Embedded& place) const;
  };
  Evaluable evaluable(const Lattice& lattice) const;
  /// The transpose of evaluable(): of a gradient with respect to the points of the lattice that
  /// devices evaluate, that with respect to those of a lattice of so many points an axis.
  Points pull_back(const Index3& dims, const Points& gradient) const;

 private:
  Kind kind_ = Kind::kBspline;
};

}  // namespace hwffd
