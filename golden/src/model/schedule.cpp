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

bool is_a(const Configuration& row, const char* organization) {
  return std::string(row.org).rfind(organization, 0) == 0;
}

double steps(const Configuration& row) {
  return (keeps_cell(row) ? 1 : std::ceil(64.0 / row.n)) * folds(row);
}

}  // namespace

bool contracts(const Configuration& row) { return is_a(row, "factored"); }

bool keeps_cell(const Configuration& row) { return is_a(row, "nested"); }

int folds(const Configuration& row) {
  const std::string org = row.org;
  const std::size_t stroke = org.find('/');
  return stroke == std::string::npos ? 1 : std::atoi(org.c_str() + stroke + 1);
}

std::optional<double> paper_clocks(const Configuration& row) {
  if (contracts(row) || keeps_cell(row)) return std::nullopt;
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
  return overlaps(row) ? overlapped_interval(row) : paper_clocks(row).value();
}

double scattered_interval(const Configuration& row) {
  if (!keeps_cell(row)) return expected_interval(row);
  constexpr int kReadLatency = 2;
  constexpr int kSteps = 16 + 3 * 64;  // of ffd_eval_former, whose four phases drain
  const int sum = row.fma_latency > 0 ? row.mul_latency + row.fma_latency + row.add_latency
                                      : row.mul_latency + 2 * row.add_latency;
  return kSteps + 4 * (kReadLatency + sum + row.convert_latency) + 2;
}

}  // namespace hwffd
