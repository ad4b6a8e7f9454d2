#pragma once

#include "hwffd/model/configuration.hpp"
#include "hwffd/model/organization.hpp"

namespace hwffd::model {

/// The four weights of each axis, by bank.
template <class F>
using AxisWeights = std::array<std::array<typename F::Weight, 4>, 3>;

/// The sum of four points with their weights, by pairs.
template <class F>
VectorSum<F> contract(const std::array<typename F::Weight, 4>& weight,
                      const std::array<typename F::Point, 3>* point) {
  std::array<Factors<F>, 4> factors;
  for (int b = 0; b < 4; ++b) factors[b] = {weight[b], point[b]};
  return tree_sum<F, 4>(factors.data());
}

/// Points by bank, contracted one axis at a time, u, t, s, 64 -> 16 -> 4 -> 1, each sum but the
/// last narrowed to a point. Mirrors ffd_eval_contraction.
template <class F>
VectorSum<F> contract_axes(const AxisWeights<F>& weight, Support<F> points) {
  for (int axis = 2; axis > 0; --axis) {
    const int left = axis == 2 ? 16 : 4;
    for (int i = 0; i < left; ++i) {
      const VectorSum<F> sum = contract<F>(weight[axis], &points[4 * i]);
      points[i] = {F::narrow(sum[0]), F::narrow(sum[1]), F::narrow(sum[2])};
    }
  }
  return contract<F>(weight[0], points.data());
}

/// Organization `factored`, beyond the paper: eq. (1) one axis at a time. Mirrors ffd_org_factored
/// however often it is folded.
template <class F>
class OrgFactored {
 public:
  explicit OrgFactored(const Configuration& /*configuration*/) {}

  VectorSum<F> evaluate(const LocalVertex<F>& vertex, const Support<F>& support,
                        const CoefficientBank<F>& bank) const {
    return contract_axes<F>(weights(vertex, bank), by_bank<F>(support, vertex.cell));
  }

  /// Those that the axes are contracted with.
  static AxisWeights<F> weights(const LocalVertex<F>& vertex, const CoefficientBank<F>& bank) {
    return weights_of<F>(vertex, bank);
  }
};

}  // namespace hwffd::model
