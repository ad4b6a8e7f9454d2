#pragma once

#include "hwffd/model/configuration.hpp"
#include "hwffd/model/organization.hpp"

namespace hwffd::model {

/// Organization `basic` (paper, fig. 1 and section 4.1): 64 terms, added one after the other in the
/// order of the banks, from +0. Mirrors ffd_org_basic at either schedule.
template <class F>
class OrgBasic {
 public:
  explicit OrgBasic(const Configuration& /*configuration*/) {}

  VectorSum<F> evaluate(const LocalVertex<F>& vertex, const Support<F>& support,
                        const CoefficientBank<F>& bank) const {
    VectorSum<F> sum{F::zero_sum(), F::zero_sum(), F::zero_sum()};
    for (int index = 0; index < 64; ++index) {
      sum = add<F>(sum, term_of<F>(vertex, support, bank, index));
    }
    return sum;
  }
};

}  // namespace hwffd::model
