#pragma once

#include <array>

#include "hwffd/model/coefficients.hpp"

namespace hwffd::model {

/// A vertex as an organization sees it: local coordinates s, t, u and the cell i, j, k.
template <class F>
struct LocalVertex {
  std::array<typename F::Weight, 3> local{};
  std::array<int, 3> cell{};
};

/// The 4 x 4 x 4 control points of a cell, in local order (l, m, n), n fastest; components x, y, z.
template <class F>
using Support = std::array<std::array<typename F::Point, 3>, 64>;

template <class F>
using VectorSum = std::array<typename F::Sum, 3>;

/// The local index of a bank on one axis: cells that share a face see a control point in the same
/// bank, and so add it at the same place (docs/numerics.md section 5).
inline int local_of_bank(int bank, int cell) { return (bank - cell) & 3; }

/// The term ((B_l B_m) B_n) P of bank index 0 to 63 (l, m, n in two bits each, n fastest).
/// Mirrors three ffd_eval_poly and ffd_eval_vector_multiplier.
template <class F>
VectorSum<F> term_of(const LocalVertex<F>& vertex, const Support<F>& support,
                     const CoefficientBank<F>& bank, int index) {
  const int l = local_of_bank(index >> 4, vertex.cell[0]);
  const int m = local_of_bank(index >> 2, vertex.cell[1]);
  const int n = local_of_bank(index, vertex.cell[2]);
  const auto weight = F::mul(F::mul(polynomial<F>(bank, 0, l, vertex.local[0]),
                                    polynomial<F>(bank, 1, m, vertex.local[1])),
                             polynomial<F>(bank, 2, n, vertex.local[2]));
  const auto& point = support[16 * l + 4 * m + n];
  return {F::term(weight, point[0]), F::term(weight, point[1]), F::term(weight, point[2])};
}

template <class F>
VectorSum<F> add(const VectorSum<F>& a, const VectorSum<F>& b) {
  return {F::add(a[0], b[0]), F::add(a[1], b[1]), F::add(a[2], b[2])};
}

}  // namespace hwffd::model
