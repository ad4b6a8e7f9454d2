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

std::string Report::json() const {
  Row sum;
  auto rows = nlohmann::ordered_json::array();
  for (const auto& [command, row] : commands_) {
    sum.cases += row.cases;
    sum.compared += row.compared;
    rows.push_back({{"command", command},
                    {"cases", row.cases},
                    {"compared", row.compared},
                    {"failed", row.failed}});
  }
  return nlohmann::ordered_json{{"calls", calls_},
                                {"error_cases", sum.cases},
                                {"compared_with_mesa", sum.compared},
                                {"failed", failed_checks_.size() + failed_cases_.size()},
                                {"failed_checks", failed_checks_.size()},
                                {"commands", std::move(rows)}}
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
