// hwffd-glapi: every call of the OpenGL extension, and every row of its error tables beside what
// Mesa makes of the same mistake.

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <filesystem>
#include <vector>

#include "call_checks.hpp"
#include "context.hpp"
#include "error_cases.hpp"
#include "glu_error_cases.hpp"
#include "hwffd/atomic_file.hpp"
#include "program.hpp"
#include "report.hpp"

namespace {

using namespace hwffd;
using namespace hwffd::glapi;

void try_calls(Report& report) {
  for (const CallCheck& check : call_checks()) report.add_check(check.calls, check.passes());
}

void try_gl_errors(Report& report) {
  for (const ErrorCase& one : gl_error_cases()) {
    const bool compared = static_cast<bool>(one.planar);
    const bool expected = error_of(one.call) == one.expected;
    const bool as_mesa = !compared || error_of(one.planar) == one.expected;
    report.add_error_case(one.name, compared, expected && as_mesa);
  }
}

void try_glu_errors(Report& report) {
  for (const GluErrorCase& one : glu_error_cases()) {
    std::vector<GLenum> expected;
    if (one.expected != GL_NO_ERROR) expected.push_back(one.expected);
    report.add_error_case(one.name, false, errors_of(one) == expected);
  }
}

int run(const std::filesystem::path& output) {
  const Context context;
  Report report;
  try_calls(report);
  try_gl_errors(report);
  try_glu_errors(report);
  fmt::print("{}", report.table());
  const std::filesystem::path file = output / "reports" / "glapi.json";
  std::filesystem::create_directories(file.parent_path());
  write_files({{file, report.json()}});
  fmt::print("\nwrote {}\n", file.string());
  return conclude(report.faults());
}

}  // namespace

int main(int argc, char** argv) {
  return hwffd::run_program("hwffd-glapi", [&] {
    CLI::App app("every call of the OpenGL extension, and every row of its error tables");
    std::filesystem::path output = "build";
    app.add_option("--output", output, "folder of the report")->capture_default_str();
    parse_command_line(app, argc, argv);
    return run(output);
  });
}
