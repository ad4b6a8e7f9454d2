#include "report.hpp"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "hwffd/model/organizations.hpp"

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
          {"operators", json_of(row.count.built)},
          {"operators_drawn", json_of(row.count.drawn)},
          {"evaluators", row.count.evaluators},
          {"simulation_vertices_per_s", row.vertices_per_s},
          {"simulation_share", row.vertices_per_s / comparison.reference_vertices_per_s()}};
}

}  // namespace

std::string json_report(const Comparison& comparison) {
  Json rows = Json::array();
  for (const Row& row : comparison.rows()) {
    rows.push_back(json_of(comparison, row));
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
    if (row.measured.seam_differences > 0) {
      text += fmt::format("{}: {} of {} values differ between cells\n", name,
                          row.measured.seam_differences, row.measured.seam_values);
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
