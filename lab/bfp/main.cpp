// hwffd-bfp: block floating point. The error of both forms of eq. (1) in the bit-true model, beside
// the bound that is proved of it, and the bits of every organization that this build has in RTL.

#include <string>
#include <vector>

#include "agreement.hpp"
#include "hwffd/cores/evaluator_core_factory.hpp"
#include "hwffd/error.hpp"
#include "program.hpp"
#include "report.hpp"
#include "study.hpp"
#include "study_program.hpp"

namespace {

using namespace hwffd;
using namespace hwffd::bfp;

std::vector<const Configuration*> built_rows() {
  std::vector<const Configuration*> rows;
  for (const Configuration& row : configurations()) {
    if (std::string(row.format) == "bfp32" && cores::has_evaluator_core(row)) rows.push_back(&row);
  }
  if (rows.empty()) throw Error("no row of bfp32 in this build: configure it by make -C lab bfp");
  return rows;
}

int carry_out(StudyProgram& program) {
  std::int64_t vertices = 10'000'000;
  std::int64_t rtl_vertices = 2'000;
  std::uint64_t seed = 1;
  program.number("--vertices", vertices, "vertices of every distribution of control points", 1,
                 1'000'000'000);
  program.number("--rtl-vertices", rtl_vertices, "vertices of every row in RTL", 1, 1'000'000);
  program.seed(seed, "lattices, vertices and registers");
  return program.run([&] {
    const std::vector<Agreement> agreements =
        compare(built_rows(), static_cast<std::size_t>(rtl_vertices), seed, show_rows_done);
    const std::vector<Result> results =
        study(vertices, seed, [](double done) { show_progress("measured", done); });
    return Findings{{{"bfp", json_report(results, agreements)}}, faults(results, agreements)};
  });
}

}  // namespace

int main(int argc, char** argv) {
  return run_study("hwffd-bfp",
                   "Measures block floating point against eq. (1), and its organizations' bits.",
                   argc, argv, carry_out);
}
