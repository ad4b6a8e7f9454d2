#include "throughput.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace hwffd::organizations {
namespace {

/// At least as small and as fast, and better in one of them.
bool beats(const Throughput& a, const Throughput& b) {
  if (a.per_second().has_value() != b.per_second().has_value()) return false;
  return a.area.size <= b.area.size && a.rate() >= b.rate() &&
         (a.area.size < b.area.size || a.rate() > b.rate());
}

std::string or_dash(const std::optional<double>& value, const char* form) {
  return value ? fmt::format(fmt::runtime(form), *value) : "-";
}

}  // namespace

std::optional<double> Throughput::per_second() const {
  if (!area.clock_mhz) return std::nullopt;
  return *area.clock_mhz * 1e6 / interval;
}

std::optional<double> Throughput::per_multiplier() const {
  if (area.multipliers.value_or(0) == 0) return std::nullopt;
  return rate() / *area.multipliers;
}

std::vector<const Throughput*> front(const std::vector<Throughput>& rows) {
  std::vector<const Throughput*> best;
  for (const Throughput& row : rows) {
    const bool beaten = std::any_of(rows.begin(), rows.end(),
                                    [&](const Throughput& other) { return beats(other, row); });
    if (!beaten) best.push_back(&row);
  }
  std::stable_sort(best.begin(), best.end(), [](const Throughput* a, const Throughput* b) {
    return a->area.size < b->area.size;
  });
  return best;
}

std::vector<std::string> targets(const std::vector<Throughput>& rows) {
  std::vector<std::string> names;
  for (const Throughput& row : rows) {
    if (std::find(names.begin(), names.end(), row.area.target) == names.end()) {
      names.push_back(row.area.target);
    }
  }
  return names;
}

std::string area_table(const std::vector<Throughput>& rows) {
  if (rows.empty()) return "\nno areas: make synth writes build/reports/synth.json\n";
  std::string text = fmt::format(
      "\n{:<8} {:<32} {:>10} {:<5} {:>11} {:>7} {:>12} {:>12} {:>12} {:>12}\n", "target", "row",
      "size", "", "multipliers", "MHz", "vertex/clock", "vertex/s", "per size", "per mult.");
  for (const std::string& target : targets(rows)) {
    for (const Throughput& row : rows) {
      if (row.area.target != target) continue;
      text += fmt::format(
          "{:<8} {:<32} {:>10.0f} {:<5} {:>11} {:>7} {:>12.4f} {:>12} {:>12.4g} {:>12}\n", target,
          row.name, row.area.size, row.area.unit, or_dash(row.area.multipliers, "{:.0f}"),
          or_dash(row.area.clock_mhz, "{:.1f}"), row.per_clock(),
          or_dash(row.per_second(), "{:.4g}"), row.per_size(),
          or_dash(row.per_multiplier(), "{:.4g}"));
    }
  }
  return text +
         "per size and per multiplier: vertices per second, or per clock where no clock is known\n";
}

}  // namespace hwffd::organizations
