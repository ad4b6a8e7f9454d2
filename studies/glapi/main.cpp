// hwffd-glapi: every call of the OpenGL extension, and every row of its error tables beside what
// Mesa makes of the same mistake.

#include <vector>

#include "call_checks.hpp"
#include "context.hpp"
#include "error_cases.hpp"
#include "glu_error_cases.hpp"
#include "report.hpp"
#include "study_program.hpp"

namespace {

using namespace hwffd;
using namespace hwffd::glapi;

void try_calls(glapi::Report& report) {
  for (const CallCheck& check : call_checks()) report.add_check(check.calls, check.passes());
}

void try_gl_errors(glapi::Report& report) {
  for (const ErrorCase& one : gl_error_cases()) {
    const bool compared = static_cast<bool>(one.planar);
    const bool expected = error_of(one.call) == one.expected;
    const bool as_mesa = !compared || error_of(one.planar) == one.expected;
    report.add_error_case(one.name, compared, expected && as_mesa);
  }
}

void try_glu_errors(glapi::Report& report) {
  for (const GluErrorCase& one : glu_error_cases()) {
    std::vector<GLenum> expected;
    if (one.expected != GL_NO_ERROR) expected.push_back(one.expected);
    report.add_error_case(one.name, false, errors_of(one) == expected);
  }
}

}  // namespace

int main(int argc, char** argv) {
  StudyProgram program(
      "hwffd-glapi",
      "Tries every call of the OpenGL extension, and every row of its error tables.");
  return program.run(argc, argv, [] {
    const Context context;
    glapi::Report report;
    try_calls(report);
    try_gl_errors(report);
    try_glu_errors(report);
    return Findings{{{"glapi", report.json()}}, report.faults()};
  });
}
