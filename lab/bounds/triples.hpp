#pragma once

#include <cstdint>
#include <vector>

#include "axis.hpp"

namespace hwffd::certified {

/// Coordinates whose errors lie in the same box: x and the four errors, each between two ends.
struct ErrorBox {
  double low_x = 2;
  double high_x = -1;
  Four low{};
  Four high{};

  void add(double x, const Four& e);
  void add(const ErrorBox& other);
  bool empty() const { return high_x < low_x; }
};

/// What branch and bound finds over all triples of coordinates.
struct TripleBound {
  double bound = 0;        ///< no triple has a larger sum |w_l w_m w_n - B_l B_m B_n|
  double reached = 0;      ///< some triple of boxes has this at the middle of them
  std::int64_t steps = 0;  ///< triples of sets that were looked at
};

/// The largest sum of 64 errors of products of weights over all triples of coordinates, the three
/// axes alike, to within `tolerance` of itself and the size of the boxes. To first order in the
/// errors; what is left out is added (lab/docs/bounds.md). B-splines only.
TripleBound bound_triples(std::vector<ErrorBox> boxes, double tolerance);

/// The same where one axis, whichever, has half the derivatives of B-splines, with errors of its
/// own.
TripleBound bound_triples_with_slopes(std::vector<ErrorBox> slopes, std::vector<ErrorBox> boxes,
                                      double tolerance);

}  // namespace hwffd::certified
