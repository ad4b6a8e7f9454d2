#pragma once

#include <array>

#include "hwffd/model/organization.hpp"
#include "hwffd/numerics/out_word.hpp"

namespace hwffd::model {

/// Fixed point inside: the word of a determinant is det J times 2^-kDeterminantShift.
constexpr int kDeterminantShift = 2;

/// det J of the columns dq/ds, dq/dt, dq/du, as the stream returns it: each column narrowed to a
/// point, each cofactor to half of itself, its terms added (0 + 1) + 2 (docs/numerics.md section
/// 9). Mirrors ffd_eval_determinant.
/// @param exponent  of the points
template <class F>
OutWord determinant(const std::array<VectorSum<F>, 3>& columns, int exponent) {
  using Point = typename F::Point;
  using Sum = typename F::Sum;
  std::array<std::array<Point, 3>, 3> at;
  for (int axis = 0; axis < 3; ++axis) {
    for (int c = 0; c < 3; ++c) at[axis][c] = F::narrow(columns[axis][c]);
  }
  std::array<Sum, 3> term;
  for (int c = 0; c < 3; ++c) {
    const int next = (c + 1) % 3;
    const int after = (c + 2) % 3;
    const Sum difference = F::add(F::product(at[1][next], at[2][after]),
                                  F::negate(F::product(at[1][after], at[2][next])));
    term[c] = F::product(at[0][c], F::narrow(difference, 2));
  }
  return F::out(F::add(F::add(term[0], term[1]), term[2]), 3 * exponent, kDeterminantShift);
}

}  // namespace hwffd::model
