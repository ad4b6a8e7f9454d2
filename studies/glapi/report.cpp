#include "report.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <nlohmann/json.hpp>

namespace hwffd::glapi {

void Report::add_check(const std::vector<std::string>& calls, bool passed) {
  calls_ += static_cast<int>(calls.size());
  if (!passed) failed_checks_.push_back(fmt::format("{}", fmt::join(calls, ", ")));
}

void Report::add_error_case(const std::string& name, bool compared, bool passed) {
  Row& row = commands_[name.substr(0, name.find(':'))];
  ++row.cases;
  row.compared += compared ? 1 : 0;
  if (passed) return;
  ++row.failed;
  failed_cases_.push_back(name);
}

Report::Row Report::total() const {
  Row sum;
  for (const auto& [command, row] : commands_) {
    sum.cases += row.cases;
    sum.compared += row.compared;
    sum.failed += row.failed;
  }
  return sum;
}

std::string Report::table() const {
  std::string text = fmt::format(
      "{} calls checked by their values, {} checks failed\n\n"
      "{:<28} {:>11} {:>18} {:>7}\n",
      calls_, failed_checks_.size(), "error table of", "error cases", "compared with Mesa",
      "failed");
  const auto add = [&](const std::string& name, const Row& row) {
    text += fmt::format("{:<28} {:>11} {:>18} {:>7}\n", name, row.cases, row.compared, row.failed);
  };
  for (const auto& [command, row] : commands_) add(command, row);
  add("all", total());
  return text;
}

std::string Report::json() const {
  const Row sum = total();
  return nlohmann::ordered_json{{"calls", calls_},
                                {"error_cases", sum.cases},
                                {"compared_with_mesa", sum.compared},
                                {"failed", failed_checks_.size() + failed_cases_.size()}}
             .dump(2) +
         "\n";
}

std::string Report::faults() const {
  std::string text;
  if (calls_ == 0) text += "no calls checked\n";
  if (commands_.empty()) text += "no error cases tried\n";
  for (const auto& names : {failed_checks_, failed_cases_}) {
    for (const std::string& name : names) text += fmt::format("FAILED: {}\n", name);
  }
  return text;
}

}  // namespace hwffd::glapi
