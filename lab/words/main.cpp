// hwffd-words: how long a word must be. The bit-true model of every word length against the oracle,
// and beside each measured error the bound that is proved of it.

#include "program.hpp"
#include "report.hpp"
#include "study_program.hpp"

namespace {

using namespace hwffd;

int carry_out(StudyProgram& program) {
  std::int64_t vertices = 1'000'000;
  std::uint64_t seed = 1;
  program.number("--vertices", vertices, "vertices of every row, half of them in smooth cells", 2,
                 1'000'000'000);
  program.seed(seed, "the vertices");
  return program.run([&] {
    const auto results = words::study(words::all_rows(), vertices, seed,
                                      [](double done) { show_progress("measured", done); });
    return Findings{{{"words", words::json_report(results)}}, words::faults(results)};
  });
}

}  // namespace

int main(int argc, char** argv) {
  return run_study("hwffd-words",
                   "Measures and bounds the error of every word length against eq. (1) in double.",
                   argc, argv, carry_out);
}
