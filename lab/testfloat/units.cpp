#include <fmt/format.h>

#include "Vfp_add_e8f23_l1.h"
#include "Vfp_add_e8f23_l4.h"
#include "Vfp_add_e8f23_l7.h"
#include "Vfp_fma_e8f23_l1.h"
#include "Vfp_fma_e8f23_l4.h"
#include "Vfp_fma_e8f23_l7.h"
#include "Vfp_mul_e8f23_l1.h"
#include "Vfp_mul_e8f23_l4.h"
#include "Vfp_mul_e8f23_l7.h"
#include "unit.hpp"

namespace hwffd::testfloat {

std::vector<Row> run_all(std::uint64_t cases, std::uint64_t seed) {
  return {run<Vfp_add_e8f23_l1, false>("add", 1, cases, seed),
          run<Vfp_add_e8f23_l4, false>("add", 4, cases, seed + 1),
          run<Vfp_add_e8f23_l7, false>("add", 7, cases, seed + 2),
          run<Vfp_mul_e8f23_l1, false>("mul", 1, cases, seed + 3),
          run<Vfp_mul_e8f23_l4, false>("mul", 4, cases, seed + 4),
          run<Vfp_mul_e8f23_l7, false>("mul", 7, cases, seed + 5),
          run<Vfp_fma_e8f23_l1, true>("fma", 1, cases, seed + 6),
          run<Vfp_fma_e8f23_l4, true>("fma", 4, cases, seed + 7),
          run<Vfp_fma_e8f23_l7, true>("fma", 7, cases, seed + 8)};
}

std::string faults(const std::vector<Row>& rows) {
  std::string text;
  for (const Row& row : rows) {
    const std::string name = fmt::format("{} at latency {}", row.unit, row.latency);
    if (row.cases == 0) text += name + ": 0 cases were compared\n";
    if (row.mismatches > 0) {
      text += fmt::format("{}: {} of {} cases differ, the first {}\n", name, row.mismatches,
                          row.cases, row.first);
    }
    if (row.control_mismatches == 0) text += name + ": a wrong reference was not found\n";
  }
  if (rows.empty()) text += "no unit was run\n";
  return text;
}

}  // namespace hwffd::testfloat
