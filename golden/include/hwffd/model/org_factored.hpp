#pragma once

#include "hwffd/model/configuration.hpp"
#include "hwffd/model/organization.hpp"

namespace hwffd::model {

/// Organization `factored`, beyond the paper: eq. (1) one axis at a time, u, t, s, 64 -> 16 -> 4 ->
/// 1 points, each sum but the last narrowed to a point. Mirrors ffd_org_factored however often it
/// is folded.
template <class F>
class OrgFactored {
 public:
  explicit OrgFactored(const Configuration& /*configuration*/) {}

  VectorSum<F> evaluate(const LocalVertex<F>& vertex, const Support<F>& support,
                        const CoefficientBank<F>& bank) const {
    const auto weight = weights_of<F>(vertex, bank);
    Support<F> points = by_bank<F>(support, vertex.cell);
    for (int axis = 2; axis > 0; --axis) {
      const int left = axis == 2 ? 16 : 4;
      for (int i = 0; i < left; ++i) {
        const VectorSum<F> sum = contract(weight[axis], &points[4 * i]);
        points[i] = {F::narrow(sum[0]), F::narrow(sum[1]), F::narrow(sum[2])};
      }
    }
    return contract(weight[0], points.data());
  }

 private:
  using Weights = std::array<typename F::Weight, 4>;
  using Vector = std::array<typename F::Point, 3>;

  /// The sum of four points with their weights, by pairs.
  static VectorSum<F> contract(const Weights& weight, const Vector* point) {
    std::array<Factors<F>, 4> factors;
    for (int b = 0; b < 4; ++b) factors[b] = {weight[b], point[b]};
    return tree_sum<F>(factors.data(), 4);
  }
};

}  // namespace hwffd::model
