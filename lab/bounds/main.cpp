// hwffd-bounds: what a search over the bit-true model finds of the errors of its forms: the largest
// errors of weights over every coordinate, and vertices whose results are as far off as possible.

#include <CLI/CLI.hpp>

#include "facts.hpp"
#include "study_program.hpp"

namespace {

using namespace hwffd;

int carry_out(StudyProgram& program) {
  certified::Effort effort;
  effort.starts = 100;
  effort.steps = 400'000;
  bool sampled = false;
  program.app().add_option("--form", effort.form, "this form only");
  program.app().add_option("--format", effort.format, "this format only");
  program.app().add_flag("--sampled", sampled, "not every coordinate of wide formats");
  program.number("--starts", effort.starts, "of a search over coordinates", 1, 1'000'000);
  program.number("--steps", effort.steps, "of a search over control points", 1, 100'000'000);
  return program.run([&] {
    effort.all = !sampled;
    const certified::Facts facts = certified::find_facts(effort);
    const bool empty = facts.weights.empty() && facts.forms.empty();
    return Findings{{{"bounds_facts", certified::json_facts(facts)}},
                    empty ? "nothing was looked at: no such form in this format\n" : ""};
  });
}

}  // namespace

int main(int argc, char** argv) {
  return run_study("hwffd-bounds",
                   "Searches the bit-true model for the largest errors of its forms.", argc, argv,
                   carry_out);
}
