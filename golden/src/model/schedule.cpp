#include "hwffd/model/schedule.hpp"

#include <string>

#include "hwffd/model/organizations.hpp"

namespace hwffd {
namespace {

ClockTerms terms_of(const Configuration& row) {
  const bool fused = row.fma_latency > 0;
  ClockTerms terms{};
  terms.n = row.n;
  terms.poly = fused ? 3 : 6;
  terms.add = fused ? 0 : 1;
  terms.start = std::string(row.evaluator) == "iterative" ? 3 : 1;
  return terms;
}

std::optional<double> clocks(const Configuration& row, Organization::Clocks formula) {
  if (formula == nullptr) return std::nullopt;
  return formula(terms_of(row));
}

}  // namespace

bool contracts(const Configuration& row) { return contracts(organization_of(row).form); }

int folds(const Configuration& row) { return organization_of(row).fold; }

int lanes(const Configuration& row) { return organization_of(row).lanes; }

bool gives_jacobian(const Configuration& row) { return organization_of(row).jacobian; }

bool walks(const Configuration& row) { return organization_of(row).walks; }

bool pairs(const Configuration& row) { return organization_of(row).pairs; }

std::optional<double> paper_clocks(const Configuration& row) {
  return clocks(row, organization_of(row).paper);
}

std::optional<double> last_accumulation(const Configuration& row) {
  return clocks(row, organization_of(row).last);
}

double overlapped_interval(const Configuration& row) {
  return organization_of(row).overlapped(terms_of(row));
}

double expected_interval(const Configuration& row) {
  return overlaps(row) ? overlapped_interval(row) : paper_clocks(row).value();
}

}  // namespace hwffd
