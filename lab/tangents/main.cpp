// hwffd-tangents: vertices with their derivatives and with det J out of the RTL, every bit against
// the model, values against the oracle and central differences, and where cells meet.

#include <fmt/format.h>

#include "hwffd/cores/stream_core_factory.hpp"
#include "hwffd/model/schedule.hpp"
#include "program.hpp"
#include "report.hpp"
#include "study_program.hpp"

namespace {

using namespace hwffd;
using namespace hwffd::tangents;

/// `basic`, overlapped, in every format that it has in this build: the smallest core that has
/// streams; and every core that has them and gives derivatives in one pass.
std::vector<Configuration> rows() {
  std::vector<Configuration> selected;
  for (const Configuration& row : configurations()) {
    if (row.name != fmt::format("basic-{}-overlapped", row.format) && !gives_jacobian(row))
      continue;
    if (cores::has_stream_core(row)) {
      selected.push_back(row);
    } else {
      fmt::print("left out: {} is not in this build; TIER=all may have it\n", row.name);
    }
  }
  return selected;
}

int carry_out(StudyProgram& program) {
  std::int64_t vertices = 5000;
  std::uint64_t seed = 1;
  program.number("--vertices", vertices, "in each of two lattices", 1, 1'000'000);
  program.seed(seed, "vertices and points");
  return program.run([&] {
    std::vector<RowResult> results;
    std::string wrong;
    for (const Configuration& row : rows()) {
      results.push_back(run(row, static_cast<std::size_t>(vertices), seed,
                            [&](double done) { show_progress(row.name, done); }));
      wrong += faults(results.back());
    }
    if (results.empty()) wrong = "no row of this build has streams\n";
    return Findings{{{"tangents", json_report(results)}}, wrong};
  });
}

}  // namespace

int main(int argc, char** argv) {
  return run_study("hwffd-tangents",
                   "Checks derivatives and det J that the RTL evaluates, in each number format.",
                   argc, argv, carry_out);
}
