#include "report.hpp"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "hwffd/model/organizations.hpp"
#include "hwffd/model/seam_bound.hpp"

namespace hwffd::organizations {
namespace {

using Json = nlohmann::ordered_json;

Json json_of(const Operators& operators) {
  return {{"mul", operators.mul}, {"add", operators.add}, {"fma", operators.fma}};
}

template <class T>
Json json_or_null(const std::optional<T>& value) {
  return value ? Json(*value) : Json();
}

Json json_of(const Throughput& on_target) {
  return {{"size", on_target.area.size},
          {"unit", on_target.area.unit},
          {"multipliers", json_or_null(on_target.area.multipliers)},
          {"fmax_mhz", json_or_null(on_target.area.clock_mhz)},
          {"vertices_per_clock", on_target.per_clock()},
          {"vertices_per_s", json_or_null(on_target.per_second())},
          {"per_size", on_target.per_size()},
          {"per_multiplier", json_or_null(on_target.per_multiplier())}};
}

/// By target; empty for a row that is mapped on none.
Json targets_of(const Row& row, const std::vector<Throughput>& areas) {
  Json found = Json::object();
  for (const Throughput& on_target : areas) {
    if (on_target.name == row.configuration->name)
      found[on_target.area.target] = json_of(on_target);
  }
  return found;
}

Json json_of(const Comparison& comparison, const Row& row) {
  const Configuration& c = *row.configuration;
  const std::optional<VertexClocks> paper = comparison.paper_clocks(row);
  return {{"name", c.name},
          {"org", c.org},
          {"n", c.n},
          {"format", c.format},
          {"schedule", c.schedule},
          {"evaluator", c.evaluator},
          {"fmac", c.fma_latency > 0},
          {"formula", json_or_null(comparison.formula(row))},
          {"clocks_paper", paper ? Json(paper->clocks) : Json()},
          {"equal", json_or_null(comparison.equal(row))},
          {"final_accumulation", paper ? Json(paper->final_accumulation) : Json()},
          {"formula_overlapped", json_or_null(comparison.overlapped_formula(row))},
          {"interval_overlapped", json_or_null(comparison.overlapped_interval(row))},
          {"equal_overlapped", json_or_null(comparison.overlapped_equal(row))},
          {"mismatches", row.measured.mismatches},
          {"checked", row.measured.checked},
          {"max_error", row.measured.max_error},
          {"seam_values", row.measured.seam_values},
          {"seam_differences", row.measured.seam_differences},
          {"seam_largest_units", row.measured.seam_largest},
          {"seam_bound_units", seam_bound(c)},
          {"operators", json_of(row.count.built)},
          {"operators_drawn", json_of(row.count.drawn)},
          {"evaluators", row.count.evaluators},
          {"simulation_vertices_per_s", row.vertices_per_s},
          {"simulation_share", row.vertices_per_s / comparison.reference_vertices_per_s()}};
}

std::string text_of(const Operators& operators) {
  return fmt::format("{}/{}/{}", operators.mul, operators.add, operators.fma);
}

/// Rows of the overlapped schedule, and those of the paper's that have no partner there.
std::vector<const Row*> lines(const Comparison& comparison) {
  std::vector<const Row*> lines;
  for (const Row& row : comparison.rows()) {
    if (overlaps(*row.configuration) || comparison.partner(row, "overlapped") == nullptr) {
      lines.push_back(&row);
    }
  }
  return lines;
}

const char* verdict(const std::optional<bool>& equal) {
  if (!equal) return "-";
  return *equal ? "yes" : "NO";
}

std::string variant(const Configuration& row) {
  return std::string(row.evaluator) + (row.fma_latency > 0 ? " fmac" : "");
}

/// Of both rows of a line.
template <class T>
T sum(const Row& row, const Row* paper, T Measurement::*figure) {
  return row.measured.*figure + (paper == nullptr ? T() : paper->measured.*figure);
}

std::string line(const Comparison& comparison, const Row& row) {
  const Configuration& c = *row.configuration;
  const Row* paper = comparison.partner(row, "paper");
  const std::optional<double> formula = comparison.formula(row);
  const std::optional<VertexClocks> clocks = comparison.paper_clocks(row);
  const std::optional<double> interval = comparison.overlapped_interval(row);
  if (paper == &row) paper = nullptr;
  return fmt::format(
      "{:<10} {:>2} {:<5} {:<15} {:>7} {:>6} {:>5} {:>5} {:>11} {:>11} {:>8} {:>5} {:>11} {:>11} "
      "{:>9.2e} {:>5} {:>4} {:>8.0f} {:>8.4f}\n",
      c.org, c.n, c.format, variant(c), formula ? fmt::format("{}", *formula) : "-",
      clocks ? std::to_string(clocks->clocks) : "-", verdict(comparison.equal(row)),
      clocks ? std::to_string(clocks->final_accumulation) : "-",
      paper != nullptr ? text_of(paper->count.built) : "-",
      paper != nullptr ? text_of(paper->count.drawn) : "-",
      interval ? fmt::format("{:.2f}", *interval) : "-", verdict(comparison.overlapped_equal(row)),
      text_of(row.count.built), text_of(row.count.drawn), row.measured.max_error,
      sum(row, paper, &Measurement::mismatches), sum(row, paper, &Measurement::seam_differences),
      row.vertices_per_s, row.vertices_per_s / comparison.reference_vertices_per_s());
}

}  // namespace

std::string table(const Comparison& comparison) {
  std::string text = fmt::format(
      "{:<35} {:<51} {:<8}\n"
      "{:<10} {:>2} {:<5} {:<15} {:>7} {:>6} {:>5} {:>5} {:>11} {:>11} {:>8} {:>5} {:>11} {:>11} "
      "{:>9} {:>5} {:>4} {:>8} {:>8}\n",
      "", "the paper's schedule", "overlapped", "org", "n", "format", "evaluator", "formula",
      "clocks", "equal", "final", "operators", "as drawn", "interval", "equal", "operators",
      "as drawn", "max error", "wrong", "seam", "vertex/s", "of C++");
  for (const Row* row : lines(comparison)) text += line(comparison, *row);
  text += fmt::format(
      "\nvertex/s is of the simulation; C++, eq. (1) in double by three loops, does {:.0f}; each "
      "is "
      "timed alone on one thread, compiled with {}\n",
      comparison.reference_vertices_per_s(), HWFFD_TIMED_OPTIONS);
  return text;
}

std::string json_report(const Comparison& comparison, const std::vector<Throughput>& areas) {
  Json rows = Json::array();
  for (const Row& row : comparison.rows()) {
    rows.push_back(json_of(comparison, row));
    if (!areas.empty()) rows.back()["targets"] = targets_of(row, areas);
    // One of every N is the same build (`parallel`, the last of the paper's seven trees).
    for (const Organization& other : organization_table()) {
      const Organization& own = organization_of(*row.configuration);
      if (own.n == 0 || other.n != 0 || std::string(own.module) != other.module) continue;
      rows.push_back(rows.back());
      rows.back()["org"] = other.name;
    }
  }
  return Json{{"reference_vertices_per_s", comparison.reference_vertices_per_s()},
              {"compiler_options", HWFFD_TIMED_OPTIONS},
              {"rows", std::move(rows)}}
             .dump(2) +
         "\n";
}

std::string faults(const Comparison& comparison) {
  std::string text;
  for (const Row& row : comparison.rows()) {
    const char* name = row.configuration->name;
    if (row.measured.mismatches > 0) {
      text += fmt::format("{}: {} results differ from the model; {}\n", name,
                          row.measured.mismatches, row.measured.first_mismatch);
    }
    const double bound = seam_bound(*row.configuration);
    if (row.measured.seam_largest > bound) {
      text += fmt::format("{}: {} of {} values differ between cells, by up to {} units of {}\n",
                          name, row.measured.seam_differences, row.measured.seam_values,
                          row.measured.seam_largest, bound);
    }
    if (row.measured.checked == 0) text += fmt::format("{}: no result checked\n", name);
    if (overlaps(*row.configuration)) {
      if (comparison.overlapped_equal(row).value()) continue;
      text += fmt::format("{}: {} clocks between vertices, the formula says {}\n", name,
                          row.measured.interval, comparison.overlapped_formula(row).value());
    } else if (!comparison.equal(row).value()) {
      text += fmt::format("{}: {} clocks a vertex and {} between vertices, the formula says {}\n",
                          name, row.measured.vertex.clocks, row.measured.interval,
                          comparison.formula(row).value());
    }
  }
  return text;
}

}  // namespace hwffd::organizations
