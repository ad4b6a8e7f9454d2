#pragma once

#include "hwffd/model/configuration.hpp"
#include "hwffd/model/organization.hpp"

namespace hwffd::model {

/// Organizations `tree`, `basic` (N = 1) and `parallel` (N = 64) of the paper's sections 4.1
/// to 4.3. Mirrors ffd_org_tree at either schedule.
template <class F>
class OrgTree {
 public:
  explicit OrgTree(const Configuration& configuration) : n_(configuration.n) {}

  VectorSum<F> evaluate(const LocalVertex<F>& vertex, const Support<F>& support,
                        const CoefficientBank<F>& bank) const {
    return summation<F>(factors_of<F>(vertex, support, bank), n_);
  }

 private:
  int n_;
};

}  // namespace hwffd::model
