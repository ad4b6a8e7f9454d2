#pragma once

#include <map>
#include <string>
#include <vector>

namespace hwffd::glapi {

/// What was tried of the OpenGL extension, and what failed.
class Report {
 public:
  /// A check of the values of one or more calls.
  void add_check(const std::vector<std::string>& calls, bool passed);
  /// A row of the error table of a command; its name is "command: mistake".
  /// @param compared  whether Mesa made the same mistake beside it
  void add_error_case(const std::string& name, bool compared, bool passed);

  /// build/reports/glapi.json.
  std::string json() const;
  /// A line for each check and each error case that failed, or that nothing was tried; empty if all
  /// is well.
  std::string faults() const;

 private:
  /// The error cases of a command.
  struct Row {
    int cases = 0;
    int compared = 0;
    int failed = 0;
  };
  int calls_ = 0;
  std::map<std::string, Row> commands_;
  std::vector<std::string> failed_checks_;
  std::vector<std::string> failed_cases_;
};

}  // namespace hwffd::glapi
