#pragma once

#include <array>

#include "hwffd/model/coefficients.hpp"

namespace hwffd::model {

/// A vertex as an organization sees it: local coordinates s, t, u, the cell i, j, k, and the axis
/// along which the derivative is wanted, -1 for the position.
template <class F>
struct LocalVertex {
  std::array<typename F::Weight, 3> local{};
  std::array<int, 3> cell{};
  int derivative = -1;
};

/// The 4 x 4 x 4 control points of a cell, in local order (l, m, n), n fastest; components x, y, z.
template <class F>
using Support = std::array<std::array<typename F::Point, 3>, 64>;

template <class F>
using VectorSum = std::array<typename F::Sum, 3>;

/// The local index of a bank on one axis: cells that share a face see a control point in the same
/// bank, and so add it at the same place (docs/numerics.md section 5).
inline int local_of_bank(int bank, int cell) { return (bank - cell) & 3; }

/// The four weights of each axis, by bank. An organization evaluates a weight as often as it likes:
/// the bits are the same, so the model does it once.
template <class F>
std::array<std::array<typename F::Weight, 4>, 3> weights_of(const LocalVertex<F>& vertex,
                                                            const CoefficientBank<F>& bank) {
  std::array<std::array<typename F::Weight, 4>, 3> weight;
  for (int axis = 0; axis < 3; ++axis) {
    const bool derivative = axis == vertex.derivative;
    for (int b = 0; b < 4; ++b) {
      const int function = local_of_bank(b, vertex.cell[axis]);
      weight[axis][b] = polynomial<F>(bank, axis, function, vertex.local[axis], derivative);
    }
  }
  return weight;
}

/// The control points by bank index 0 to 63 (l, m, n in two bits each, n fastest).
template <class F>
Support<F> by_bank(const Support<F>& support, const std::array<int, 3>& cell) {
  Support<F> points;
  for (int index = 0; index < 64; ++index) {
    const int l = local_of_bank(index >> 4, cell[0]);
    const int m = local_of_bank(index >> 2, cell[1]);
    const int n = local_of_bank(index, cell[2]);
    points[index] = support[16 * l + 4 * m + n];
  }
  return points;
}

/// A weight and the control point that it multiplies.
template <class F>
struct Factors {
  typename F::Weight weight;
  std::array<typename F::Point, 3> point;
};

/// The weight (B_l B_m) B_n and the control point of each bank index. Mirrors
/// ffd_eval_weight_product over the evaluators.
template <class F>
std::array<Factors<F>, 64> factors_of(const LocalVertex<F>& vertex, const Support<F>& support,
                                      const CoefficientBank<F>& bank) {
  const auto weight = weights_of<F>(vertex, bank);
  const Support<F> points = by_bank<F>(support, vertex.cell);
  std::array<Factors<F>, 64> factors;
  for (int index = 0; index < 64; ++index) {
    factors[index].weight =
        F::mul(F::mul(weight[0][index >> 4], weight[1][index >> 2 & 3]), weight[2][index & 3]);
    factors[index].point = points[index];
  }
  return factors;
}

template <class F>
VectorSum<F> zero_sum() {
  return {F::zero_sum(), F::zero_sum(), F::zero_sum()};
}

template <class F>
VectorSum<F> term(const Factors<F>& f) {
  return {F::term(f.weight, f.point[0]), F::term(f.weight, f.point[1]),
          F::term(f.weight, f.point[2])};
}

template <class F>
VectorSum<F> mac(const VectorSum<F>& sum, const Factors<F>& f) {
  return {F::mac(sum[0], f.weight, f.point[0]), F::mac(sum[1], f.weight, f.point[1]),
          F::mac(sum[2], f.weight, f.point[2])};
}

template <class F>
VectorSum<F> add(const VectorSum<F>& a, const VectorSum<F>& b) {
  return {F::add(a[0], b[0]), F::add(a[1], b[1]), F::add(a[2], b[2])};
}

/// The sum of n = 1, 2 or 4 terms by adjacent pairs. Mirrors ffd_eval_tree: the odd term of each
/// pair is added as it is multiplied, which matters where that is fused.
template <class F, int n>
VectorSum<F> tree_sum(const Factors<F>* factors) {
  if constexpr (n == 1) {
    return term<F>(factors[0]);
  } else if constexpr (n == 2) {
    return mac<F>(term<F>(factors[0]), factors[1]);
  } else {
    return add<F>(tree_sum<F, n / 2>(factors), tree_sum<F, n / 2>(factors + n / 2));
  }
}

/// The same of n = 4, 8 .. 64 terms. A loop: written out for each n, it takes a compiler minutes.
template <class F>
VectorSum<F> large_tree_sum(const Factors<F>* factors, int n) {
  std::array<VectorSum<F>, 16> sums;
  for (int i = 0; i < n / 4; ++i) sums[i] = tree_sum<F, 4>(factors + 4 * i);
  for (int count = n / 8; count > 0; count /= 2) {
    for (int i = 0; i < count; ++i) sums[i] = add<F>(sums[2 * i], sums[2 * i + 1]);
  }
  return sums[0];
}

/// The 64 terms n at a time, each so many by a tree, accumulated from +0 in the order of the banks.
/// Mirrors ffd_eval_summation.
template <class F>
VectorSum<F> summation(const std::array<Factors<F>, 64>& factors, int n) {
  if (n == 64) return large_tree_sum<F>(factors.data(), 64);
  VectorSum<F> sum = zero_sum<F>();
  if (n == 1) {
    for (const Factors<F>& factor : factors) sum = mac<F>(sum, factor);
    return sum;
  }
  for (int index = 0; index < 64; index += n) {
    const Factors<F>* const some = &factors[index];
    sum = add<F>(sum, n == 2 ? tree_sum<F, 2>(some) : large_tree_sum<F>(some, n));
  }
  return sum;
}

}  // namespace hwffd::model
