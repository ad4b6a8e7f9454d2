// hwffd-organizations: the table of the paper's section 4, counted in RTL. Every row that this
// build has runs at its read port: clocks at the paper's schedule against the formula, overlapped
// interval, operators, error, seams.

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <set>

#include "chart.hpp"
#include "comparison.hpp"
#include "hwffd/atomic_file.hpp"
#include "hwffd/cores/evaluator_core_factory.hpp"
#include "options.hpp"
#include "pareto.hpp"
#include "program.hpp"
#include "report.hpp"
#include "timeline.hpp"

namespace {

using namespace hwffd;
using namespace hwffd::organizations;

std::vector<const Configuration*> built_rows() {
  std::vector<const Configuration*> rows;
  for (const Configuration& row : configurations()) {
    if (cores::has_evaluator_core(row)) rows.push_back(&row);
  }
  return rows;
}

/// A timeline for every organization and N, of the first of fx18 or whatever format there is.
void add_timelines(std::vector<FileContent>& files, const std::filesystem::path& folder,
                   const Comparison& comparison) {
  std::set<std::string> drawn;
  for (const char* format : {"fx18", ""}) {
    for (const Row& row : comparison.rows()) {
      const Configuration& c = *row.configuration;
      if (*format != '\0' && std::string(c.format) != format) continue;
      std::string name = short_name(c);
      name.erase(std::remove(name.begin(), name.end(), ' '), name.end());
      std::replace(name.begin(), name.end(), '/', '-');
      if (!drawn.insert(name).second) continue;
      files.push_back(
          {folder / fmt::format("timeline-{}.svg", name),
           timeline(comparison.partner(row, "paper"), comparison.partner(row, "overlapped"))});
    }
  }
}

int run(const Options& options) {
  const Comparison comparison =
      compare(built_rows(), read_operators(options.operators), options.effort, show_rows_done);
  const std::vector<Throughput> areas = throughputs(comparison, read_areas(options.areas));
  fmt::print("{}{}", table(comparison), area_table(areas));
  const std::filesystem::path folder = options.output / "reports";
  std::filesystem::create_directories(folder);
  std::vector<FileContent> files = {{folder / "organizations.json", json_report(comparison, areas)},
                                    {folder / "organizations.svg", tradeoff_chart(comparison)}};
  if (!areas.empty()) files.push_back({folder / "pareto.svg", pareto_chart(areas)});
  add_timelines(files, folder, comparison);
  write_files(files);
  fmt::print("\nwrote {0}/organizations.json, {0}/organizations.svg{1} and {0}/timeline-*.svg\n",
             folder.string(), areas.empty() ? "" : fmt::format(", {}/pareto.svg", folder.string()));
  return conclude(faults(comparison));
}

}  // namespace

int main(int argc, char** argv) {
  return hwffd::run_program("hwffd-organizations", [&] { return run(parse_options(argc, argv)); });
}
