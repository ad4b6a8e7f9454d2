// hwffd-organizations: the table of the paper's section 4, counted in RTL. Every row that this
// build has runs at its read port: clocks at the paper's schedule against the formula, overlapped
// interval, operators, error, seams.

#include <CLI/CLI.hpp>

#include "comparison.hpp"
#include "hwffd/cores/evaluator_core_factory.hpp"
#include "hwffd/error.hpp"
#include "program.hpp"
#include "report.hpp"
#include "study_program.hpp"
#include "timeline.hpp"

namespace {

using namespace hwffd;
using namespace hwffd::organizations;

std::vector<const Configuration*> built_rows() {
  std::vector<const Configuration*> rows;
  for (const Configuration& row : configurations()) {
    if (cores::has_evaluator_core(row)) rows.push_back(&row);
  }
  if (rows.empty()) throw Error("no row in this build: configure it by make organizations");
  return rows;
}

int carry_out(StudyProgram& program) {
  std::int64_t vertices = 4001;
  std::int64_t seam_values = 60'000;
  std::uint64_t seed = 1;
  std::string operators = HWFFD_OPERATORS;  // of this build
  program.number("--vertices", vertices,
                 "random vertices of every row, 41 and a multiple of 120; slow rows: 1241 at most",
                 161, 1'000'000);
  program.number("--seam-values", seam_values,
                 "components of shared vertices of every row; slow rows: a tenth", 1, 10'000'000);
  program.seed(seed, "vertices and registers");
  program.app().add_option("--operators", operators, "what tools/synth/operators.py wrote");
  return program.run([&] {
    if ((vertices - 41) % 120 != 0) {
      throw UsageError("--vertices: expected 41 and a multiple of 120");
    }
    const auto rows = built_rows();
    const Effort effort{static_cast<std::size_t>(vertices), static_cast<std::size_t>(seam_values),
                        seed};
    const Comparison comparison = compare(rows, read_operators(operators), effort, show_rows_done);
    return Findings{
        {{"organizations", json_report(comparison)}, {"timelines", timelines(comparison)}},
        faults(comparison)};
  });
}

}  // namespace

int main(int argc, char** argv) {
  return run_study("hwffd-organizations",
                   "Compares organizations at their read port: clocks, operators, errors, seams.",
                   argc, argv, carry_out);
}
