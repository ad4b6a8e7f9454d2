#pragma once

#include <fmt/format.h>

#include <cstdint>
#include <memory>
#include <string>
#include <type_traits>
#include <vector>

#include "host.hpp"
#include "hwffd/tb/sim.hpp"
#include "operands.hpp"

namespace hwffd::testfloat {

/// What a unit has done.
struct Row {
  std::string unit;
  int latency = 0;
  std::uint64_t cases = 0;
  std::uint64_t mismatches = 0;
  std::uint64_t combinations = 0;      ///< of sign and special exponent of all operands, that came
  std::uint64_t all_combinations = 0;  ///< that there are
  std::uint64_t control_cases = 0;
  std::uint64_t control_mismatches = 0;  ///< against the host rounding towards zero
  std::string first;                     ///< the first mismatch, in words; empty if none
};

/// Which operation a Verilated unit is, by its name in the report.
inline Operation operation_of(const std::string& unit) {
  return unit == "add" ? Operation::kAdd : unit == "mul" ? Operation::kMul : Operation::kFma;
}

/// Drives a unit with a new case in every clock, and compares what comes out `latency` later.
template <class VDut, bool kThree>
void drive(Row& row, std::uint64_t cases, std::uint64_t seed, std::uint64_t& checked,
           std::uint64_t& mismatches) {
  tb::Sim<VDut> unit(seed);
  Operands operands(kThree ? 3 : 2, seed);
  const Operation operation = operation_of(row.unit);
  const auto latency = static_cast<std::uint64_t>(row.latency);
  std::vector<std::array<std::uint32_t, 3>> under_way(latency);
  for (std::uint64_t i = 0; i < cases + latency - 1; ++i) {
    under_way[i % latency] = operands.next();
    const auto& in = under_way[i % latency];
    unit->a_i = in[0];
    unit->b_i = in[1];
    if constexpr (kThree) unit->c_i = in[2];
    unit.tick();
    if (i + 1 < latency) continue;
    const auto& out = under_way[(i + 1) % latency];
    const std::uint32_t expected = host(operation, out);
    ++checked;
    if (unit->result_o == expected) continue;
    if (mismatches++ == 0) {
      row.first = fmt::format("{:08x} {:08x} {:08x}: {:08x}, not {:08x}", out[0], out[1], out[2],
                              static_cast<std::uint32_t>(unit->result_o), expected);
    }
  }
  row.combinations = operands.combinations();
  row.all_combinations = operands.all_combinations();
}

/// A unit over so many cases; before them it is compared with a wrong reference, which must show.
template <class VDut, bool kThree>
Row run(const std::string& unit, int latency, std::uint64_t cases, std::uint64_t seed) {
  constexpr std::uint64_t kControl = 20'000;
  Row row;
  row.unit = unit;
  row.latency = latency;
  {
    const TowardsZero wrong;
    drive<VDut, kThree>(row, kControl, seed, row.control_cases, row.control_mismatches);
  }
  row.first.clear();
  drive<VDut, kThree>(row, cases, seed, row.cases, row.mismatches);
  return row;
}

/// Every unit at every latency that is built here.
std::vector<Row> run_all(std::uint64_t cases, std::uint64_t seed);

/// What does not hold, a line each.
std::string faults(const std::vector<Row>& rows);

}  // namespace hwffd::testfloat
