// hwffd-testfloat: the floating-point units on operands by TestFloat's scheme, against the host's
// binary32.

#include <nlohmann/json.hpp>

#include "study_program.hpp"
#include "unit.hpp"

namespace {

using namespace hwffd;
using namespace hwffd::testfloat;

std::string json_report(const std::vector<Row>& rows, std::uint64_t seed) {
  auto list = nlohmann::ordered_json::array();
  std::uint64_t cases = 0;
  std::uint64_t mismatches = 0;
  for (const Row& row : rows) {
    cases += row.cases;
    mismatches += row.mismatches;
    list.push_back({{"unit", row.unit},
                    {"latency", row.latency},
                    {"cases", row.cases},
                    {"mismatches", row.mismatches},
                    {"combinations", row.combinations},
                    {"all_combinations", row.all_combinations},
                    {"control_cases", row.control_cases},
                    {"control_mismatches", row.control_mismatches},
                    {"first", row.first}});
  }
  const nlohmann::ordered_json report{
      {"seed", seed}, {"cases", cases}, {"mismatches", mismatches}, {"rows", list}};
  return report.dump(1) + "\n";
}

int carry_out(StudyProgram& program) {
  std::int64_t cases = 1'000'000;
  std::uint64_t seed = 1;
  program.number("--cases", cases, "of each unit and latency", 1, 1'000'000'000'000);
  program.seed(seed, "the operands");
  return program.run([&] {
    const std::vector<Row> rows = run_all(static_cast<std::uint64_t>(cases), seed);
    return Findings{{{"testfloat", json_report(rows, seed)}}, faults(rows)};
  });
}

}  // namespace

int main(int argc, char** argv) {
  return run_study("hwffd-testfloat",
                   "Runs the floating-point units on operands by TestFloat's scheme.", argc, argv,
                   carry_out);
}
