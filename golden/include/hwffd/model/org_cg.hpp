#pragma once

#include "hwffd/model/configuration.hpp"
#include "hwffd/model/organization.hpp"

namespace hwffd::model {

/// Organization `cg` (paper, section 4.4): weights are evaluated once, the combinations summed as
/// in `basic`. Mirrors ffd_org_cg with any number of evaluators, at either schedule.
template <class F>
class OrgCg {
 public:
  explicit OrgCg(const Configuration& /*configuration*/) {}

  VectorSum<F> evaluate(const LocalVertex<F>& vertex, const Support<F>& support,
                        const CoefficientBank<F>& bank) const {
    return summation<F>(factors_of<F>(vertex, support, bank), 1);
  }
};

}  // namespace hwffd::model
