// hwffd-organizations: the table of the paper's section 4, counted in RTL. Every row that this
// build has runs at its read port: clocks at the paper's schedule against the formula, overlapped
// interval, operators, error, seams.

#include <fmt/format.h>
#include <unistd.h>

#include <exception>
#include <filesystem>
#include <set>

#include "chart.hpp"
#include "comparison.hpp"
#include "hwffd/atomic_file.hpp"
#include "hwffd/error.hpp"
#include "hwffd/tb/evaluator_core_factory.hpp"
#include "options.hpp"
#include "report.hpp"
#include "timeline.hpp"

namespace {

using namespace hwffd;
using namespace hwffd::organizations;

void show_progress(std::size_t done, std::size_t all) {
  if (isatty(fileno(stderr)) == 0) return;
  fmt::print(stderr, "\r\033[K[{}/{}] rows measured", done, all);
  if (done == all) fmt::print(stderr, "\r\033[K");
}

std::vector<const Configuration*> built_rows() {
  std::vector<const Configuration*> rows;
  for (const Configuration& row : configurations()) {
    if (tb::has_evaluator_core(row)) rows.push_back(&row);
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
      const std::string name =
          std::string(c.org) == "tree" ? fmt::format("tree{}", c.n) : std::string(c.org);
      if (!drawn.insert(name).second) continue;
      files.push_back(
          {folder / fmt::format("timeline-{}.svg", name),
           timeline(comparison.partner(row, "paper"), comparison.partner(row, "overlapped"))});
    }
  }
}

int run(const Options& options) {
  const Comparison comparison =
      compare(built_rows(), read_operators(options.operators), options.effort, show_progress);
  fmt::print("{}", table(comparison));
  const std::filesystem::path folder = options.output / "reports";
  std::filesystem::create_directories(folder);
  std::vector<FileContent> files = {{folder / "organizations.json", json_report(comparison)},
                                    {folder / "organizations.svg", tradeoff_chart(comparison)}};
  add_timelines(files, folder, comparison);
  write_files(files);
  fmt::print("\nwrote {0}/organizations.json, {0}/organizations.svg and {0}/timeline-*.svg\n",
             folder.string());
  const std::string wrong = faults(comparison);
  fmt::print(stderr, "{}", wrong);
  return wrong.empty() ? 0 : 1;
}

}  // namespace

int main(int argc, char** argv) {
  try {
    return run(parse_options(argc, argv));
  } catch (const Error& error) {
    fmt::print(stderr, "hwffd-organizations: {}\n", error.what());
    return error.exit_status();
  } catch (const std::exception& error) {
    fmt::print(stderr, "hwffd-organizations: {}\n", error.what());
    return 1;
  }
}
