#include "hwffd/model/schedule.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <string>

namespace hwffd {
namespace {

/// Polynomial evaluators of a combination generator; 0 for other organizations.
int generator_evaluators(const Configuration& row) {
  const std::string org = row.org;
  return org.rfind("cg", 0) == 0 ? std::atoi(org.c_str() + 2) : 0;
}

double steps(const Configuration& row) { return std::ceil(64.0 / row.n) * folds(row); }

}  // namespace

bool contracts(const Configuration& row) { return std::string(row.org).rfind("factored", 0) == 0; }

int folds(const Configuration& row) {
  const std::string org = row.org;
  const std::size_t stroke = org.find('/');
  return stroke == std::string::npos ? 1 : std::atoi(org.c_str() + stroke + 1);
}

std::optional<double> paper_clocks(const Configuration& row) {
  if (contracts(row)) return std::nullopt;
  const bool fused = row.fma_latency > 0;
  const double polynomial = fused ? 3 : 6;
  if (const int evaluators = generator_evaluators(row)) {
    return 12.0 / evaluators * polynomial + 64 * (fused ? 4 : 5);
  }
  if (std::string(row.org) == "basic") return fused ? 384 : 640;
  return (polynomial + 3 + std::log2(row.n)) * steps(row);
}

double overlapped_interval(const Configuration& row) {
  const double polynomial = std::string(row.evaluator) == "iterative" ? 6 : 1;
  if (const int evaluators = generator_evaluators(row)) {
    return std::max(64.0, 12.0 / evaluators * polynomial);
  }
  return steps(row) * polynomial;
}

double expected_interval(const Configuration& row) {
  return std::string(row.schedule) == "paper" ? paper_clocks(row).value()
                                              : overlapped_interval(row);
}

}  // namespace hwffd
