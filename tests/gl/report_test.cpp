// What `make glapi` says of a call or an error case that fails: it ends with 1 where this is not
// empty.
#include "report.hpp"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

namespace hwffd::glapi {
namespace {

TEST(GlapiReport, NamesWhatFailed) {
  Report report;
  EXPECT_NE(report.faults(), "") << "nothing was tried";
  report.add_check({"glMap3d", "glMap3f"}, true);
  report.add_error_case("glMap3: stride 2", true, true);
  EXPECT_EQ(report.faults(), "");
  report.add_check({"glFFD"}, false);
  report.add_error_case("glMap3: uorder 0", true, false);
  report.add_error_case("gluFfdNormals: none", false, false);
  EXPECT_EQ(report.faults(),
            "FAILED: glFFD\nFAILED: glMap3: uorder 0\nFAILED: gluFfdNormals: none\n");
}

TEST(GlapiReport, CountsByCommand) {
  Report report;
  report.add_check({"glMap3d", "glMap3f"}, true);
  report.add_error_case("glMap3: stride 2", true, true);
  report.add_error_case("glMap3: uorder 0", true, false);
  report.add_error_case("gluFfdNormals: none", false, true);
  const nlohmann::json commands = {
      {{"command", "glMap3"}, {"cases", 2}, {"compared", 2}, {"failed", 1}},
      {{"command", "gluFfdNormals"}, {"cases", 1}, {"compared", 0}, {"failed", 0}}};
  EXPECT_EQ(nlohmann::json::parse(report.json()), (nlohmann::json{{"calls", 2},
                                                                  {"error_cases", 3},
                                                                  {"compared_with_mesa", 2},
                                                                  {"failed", 1},
                                                                  {"failed_checks", 0},
                                                                  {"commands", commands}}));
}

}  // namespace
}  // namespace hwffd::glapi
