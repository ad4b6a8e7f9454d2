#pragma once

#include "hwffd/model/org_factored.hpp"
#include "hwffd/numerics/lanes.hpp"

namespace hwffd::model {

/// Organization `affine`, beyond the paper: `factored` where bank 3 of an axis has the weight that
/// the others leave of one, of a derivative of zero. Fixed point only: in exact sums that is what
/// ffd_org_affine computes by differences, however often it is folded.
template <class F>
class OrgAffine {
 public:
  explicit OrgAffine(const Configuration& /*configuration*/) {}

  VectorSum<F> evaluate(const LocalVertex<F>& vertex, const Support<F>& support,
                        const CoefficientBank<F>& bank) const {
    return contract_axes<F>(weights(vertex, bank), by_bank<F>(support, vertex.cell));
  }

  /// Those that the axes are contracted with.
  static AxisWeights<F> weights(const LocalVertex<F>& vertex, const CoefficientBank<F>& bank) {
    AxisWeights<F> weight = weights_of<F>(vertex, bank);
    for (int axis = 0; axis < 3; ++axis) complete(weight[axis], axis != vertex.derivative);
    return weight;
  }

 private:
  /// Bank 3 gets what the others leave of 1, or of 0. It may have more bits than a weight.
  static void complete(std::array<typename F::Weight, 4>& weight, bool to_one) {
    const std::int64_t whole = to_one ? std::int64_t{1} << F::kWeightFraction : 0;
    weight[3] = {everywhere<typename F::Word>(whole), typename F::Flag{}};
    for (int b = 0; b < 3; ++b) {
      weight[3].value -= weight[b].value;
      weight[3].saturated = either(weight[3].saturated, weight[b].saturated);
    }
  }
};

}  // namespace hwffd::model
