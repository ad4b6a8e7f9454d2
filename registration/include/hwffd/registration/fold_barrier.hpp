#pragma once

#include <limits>

#include "hwffd/lattice/fold.hpp"
#include "hwffd/lattice/lattice.hpp"

namespace hwffd {

/// A penalty that keeps a lattice of uniform cubic B-splines from folding: with d = det J, in parts
/// of its mean over the cells of a lattice to start from, the mean of
///
///     b(d) = (T - d)^3 / (T^2 d) for 0 < d < T,  0 from T on,  +infinity up to 0
///
/// over the places of all cells at 0, 1/2 and 1 along each axis. b is C2. The threshold T leaves
/// maps alone that shrink no volume below that part.
///
/// Between its places det J may still be negative: proves_no_fold() says whether.
class FoldBarrier {
 public:
  static constexpr double kThreshold = 0.3;

  /// @param start  whose map has one sign of det J
  /// @throws Error where proves_no_fold() would not prove it
  explicit FoldBarrier(const Lattice& start);

  struct Result {
    double penalty = 0.0;                                    ///< infinite where det J is not > 0
    double least = std::numeric_limits<double>::infinity();  ///< d at all places
    double most = -std::numeric_limits<double>::infinity();
  };
  /// The penalty of control points, m x 3. Adds `weight` times its gradient to `gradient`, if there
  /// is one and the penalty is finite.
  Result operator()(const Points& points, double weight = 1.0, Points* gradient = nullptr) const;

  /// Whether det J is proved to have the sign of the start's in all cells: from differences of the
  /// control points of each, which takes a microsecond where these are alike, or of its halves, up
  /// to six times. check_folds() of hwffd_geometry proves some more, and takes a hundred times as
  /// long.
  bool proves_no_fold(const Points& points) const;

  const Index3& dims() const { return dims_; }

 private:
  Index3 dims_;
  double mean_;  ///< det J of the start's mean edges
};

/// check_folds() of uniform cubic B-splines, but much faster where FoldBarrier's proof is enough:
/// of 58^3 cells it takes a second at most, not half a minute.
FoldCheck check_bspline_folds(const Lattice& lattice);

/// The range of det J at the same places with respect to a lattice at rest, both of the same dims:
/// 1 where volume stays.
FoldBarrier::Result jacobian_range(const Lattice& rest, const Lattice& deformed);

}  // namespace hwffd
