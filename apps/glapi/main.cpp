// hwffd-glapi: every call of the OpenGL extension, and every row of its error tables beside what
// Mesa makes of the same mistake.

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <CLI/CLI.hpp>
#include <filesystem>
#include <map>
#include <nlohmann/json.hpp>
#include <string>

#include "call_checks.hpp"
#include "context.hpp"
#include "error_cases.hpp"
#include "glu_error_cases.hpp"
#include "hwffd/atomic_file.hpp"
#include "program.hpp"

namespace {

using namespace hwffd;
using namespace hwffd::glapi;

/// A line of the table: what was tried of a command.
struct Row {
  int cases = 0;
  int compared = 0;
  int failed = 0;
};

using Table = std::map<std::string, Row>;

std::string command_of(const std::string& case_name) {
  return case_name.substr(0, case_name.find(':'));
}

/// Counts a case, and says what is wrong with it.
void count(Row& row, const std::string& name, bool right) {
  ++row.cases;
  if (right) return;
  ++row.failed;
  fmt::print("FAILED: {}\n", name);
}

Table gl_errors() {
  Table table;
  for (const ErrorCase& one : gl_error_cases()) {
    Row& row = table[command_of(one.name)];
    const bool expected = error_of(one.call) == one.expected;
    const bool as_mesa = !one.planar || error_of(one.planar) == one.expected;
    row.compared += one.planar ? 1 : 0;
    count(row, one.name, expected && as_mesa);
  }
  return table;
}

Table glu_errors() {
  Table table;
  for (const GluErrorCase& one : glu_error_cases()) {
    std::vector<GLenum> expected;
    if (one.expected != GL_NO_ERROR) expected.push_back(one.expected);
    count(table[command_of(one.name)], one.name, errors_of(one) == expected);
  }
  return table;
}

Row total(const Table& table) {
  Row sum;
  for (const auto& [command, row] : table) {
    sum.cases += row.cases;
    sum.compared += row.compared;
    sum.failed += row.failed;
  }
  return sum;
}

void print(const Table& table) {
  for (const auto& [command, row] : table) {
    fmt::print("{:<28} {:>11} {:>18} {:>7}\n", command, row.cases, row.compared, row.failed);
  }
}

int run(const std::filesystem::path& output) {
  const Context context;
  int calls = 0;
  int failed = 0;
  for (const CallCheck& check : call_checks()) {
    calls += static_cast<int>(check.calls.size());
    if (check.passes()) continue;
    ++failed;
    fmt::print("FAILED: {}\n", fmt::join(check.calls, ", "));
  }
  fmt::print("{} calls checked by their values, {} checks failed\n\n", calls, failed);
  Table table = gl_errors();
  table.merge(glu_errors());
  fmt::print("{:<28} {:>11} {:>18} {:>7}\n", "error table of", "error cases", "compared with Mesa",
             "failed");
  print(table);
  const Row sum = total(table);
  print({{"all", sum}});
  failed += sum.failed;
  const nlohmann::ordered_json report{{"calls", calls},
                                      {"error_cases", sum.cases},
                                      {"compared_with_mesa", sum.compared},
                                      {"failed", failed}};
  const std::filesystem::path file = output / "reports" / "glapi.json";
  std::filesystem::create_directories(file.parent_path());
  write_files({{file, report.dump(2) + "\n"}});
  fmt::print("\nwrote {}\n", file.string());
  return failed == 0 ? 0 : 1;
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
