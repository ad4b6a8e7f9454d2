#pragma once

#include <vector>

#include "axis_blending.hpp"

namespace hwffd::glu {

/// The knots of one axis and the blending functions that they give its cells.
class Knots {
 public:
  /// @param count  of the knots: as many as control points, and `order` more
  /// @param knots  null: 0, 1, 2, ...
  /// @throws GluError for an order, a sequence or a number of cells that cannot be, checked in the
  ///   order of Mesa's gluNurbsSurface
  Knots(int order, int count, const float* knots);

  int order() const { return order_; }
  int points() const { return static_cast<int>(knots_.size()) - order_; }
  int cells() const { return points() - order_ + 1; }

  /// Whether a cell's range is empty, so that no vertex lies in it.
  bool is_empty(int cell) const;

  /// The B-splines of a cell that is not empty, over coordinates 0 to 1 from its first knot to
  /// its last (recurrence of Cox and de Boor, on polynomials).
  gl::AxisBlending blending(int cell) const;

 private:
  void check() const;

  int order_;
  std::vector<double> knots_;
};

}  // namespace hwffd::glu
