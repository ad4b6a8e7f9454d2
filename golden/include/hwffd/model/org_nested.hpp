#pragma once

#include <type_traits>

#include "hwffd/model/configuration.hpp"
#include "hwffd/model/organization.hpp"

namespace hwffd::model {

/// Organization `nested`, beyond the paper: eq. (1) as a polynomial in sigma = 2s - 1, tau, upsilon
/// about the cell's centre, by Horner's rule. Mirrors ffd_org_nested however often it is folded.
template <class F>
class OrgNested {
 public:
  explicit OrgNested(const Configuration& /*configuration*/) {}

  using Value = typename F::Point;
  using Vector = std::array<Value, 3>;
  /// The 64 coefficient vectors of a cell: that of sigma^i tau^j upsilon^k at [16 i + 4 j + k], in
  /// fixed point halved that often (docs/numerics.md section 3).
  struct CellCoefficients {
    std::array<Vector, 64> vector;
    int halvings = 0;
  };
  static_assert(std::is_same_v<typename F::Weight, Value>, "a step takes values for weights");

  VectorSum<F> evaluate(const LocalVertex<F>& vertex, const Support<F>& support,
                        const CoefficientBank<F>& bank) const {
    const CellCoefficients cell = form(vertex.cell, support, bank, vertex.derivative);
    VectorSum<F> sum;
    for (int c = 0; c < 3; ++c) {
      std::array<Value, 64> value;
      for (int n = 0; n < 64; ++n) value[n] = cell.vector[n][c];
      for (int axis = 2; axis >= 0; --axis) {
        const auto x = F::centre(vertex.local[axis]);
        for (int n = 0; n < 1 << 2 * axis; ++n) value[n] = horner(&value[4 * n], x);
      }
      sum[c] = F::widen(value[0], cell.halvings);
    }
    return sum;
  }

  /// c = (M_s x M_t x M_u) P, one axis at a time, u first. Mirrors ffd_eval_former.
  /// @param derivative  the axis that takes its derivative functions; -1: none
  static CellCoefficients form(const std::array<int, 3>& cell, const Support<F>& support,
                               const CoefficientBank<F>& bank, int derivative = -1) {
    CellCoefficients left{by_bank<F>(support, cell)};
    for (int axis = 2; axis >= 0; --axis) {
      const auto& functions = (axis == derivative ? bank.derivative : bank.entry)[axis];
      const Matrix matrix = power_matrix(functions, cell[axis]);
      const bool halved = functions[0].shift > 0 && left.halvings < 2;
      left.halvings += halved ? 1 : 0;
      const int stride = 1 << 2 * (2 - axis);  // of this axis's digit
      for (int n = 0; n < 64; ++n) {
        if (n / stride % 4 != 0) continue;
        std::array<Vector, 4> taken;
        for (int b = 0; b < 4; ++b) taken[b] = left.vector[n + b * stride];
        for (int k = 0; k < 4; ++k) {
          left.vector[n + k * stride] = contract(matrix[k], taken, halved ? -1 : 0);
        }
      }
    }
    return left;
  }

 private:
  using Weights = std::array<typename F::Weight, 4>;
  using Matrix = std::array<Weights, 4>;  // [power of the centred coordinate][bank]
  using Functions = typename CoefficientBank<F>::Functions;

  /// The coefficient of (2x - 1)^k in each blending function: sum_j c_j binom(j, k) / 2^j.
  static Matrix power_matrix(const Functions& functions, int cell) {
    Matrix matrix;
    for (int b = 0; b < 4; ++b) {
      const auto& entry = functions[local_of_bank(b, cell)];
      for (int k = 0; k < 4; ++k) {
        std::array<Vector, 4> coefficient{};
        Weights binomial;
        for (int j = 0; j < 4; ++j) {
          coefficient[j][0] = entry.coefficient[j];
          binomial[j] = F::binomial(j, k);
        }
        matrix[k][b] = contract(binomial, coefficient, entry.shift)[0];
      }
    }
    return matrix;
  }

  /// The sum of four points with their weights, by pairs, times 2^shift in fixed point.
  static Vector contract(const Weights& weight, const std::array<Vector, 4>& point, int shift) {
    std::array<Factors<F>, 4> factors;
    for (int b = 0; b < 4; ++b) factors[b] = {weight[b], point[b]};
    const VectorSum<F> sum = tree_sum<F, 4>(factors.data());
    return {F::rescale(sum[0], shift), F::rescale(sum[1], shift), F::rescale(sum[2], shift)};
  }

  static Value horner(const Value* coefficient, typename F::Weight x) {
    Value value = coefficient[3];
    for (int power = 2; power >= 0; --power) value = F::step(coefficient[power], x, value);
    return value;
  }
};

}  // namespace hwffd::model
