// The comparison of organizations: clocks of a vertex counted in the RTL against the formulas, what
// the report says, and that it says what is wrong.
#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <nlohmann/json.hpp>
#include <ostream>
#include <string>

#include "comparison.hpp"
#include "hwffd/cores/evaluator_core_factory.hpp"
#include "hwffd/model/schedule.hpp"
#include "named.hpp"
#include "report.hpp"
#include "timeline.hpp"

namespace hwffd {

namespace organizations {
namespace {

const Effort kLittle{161, 900, 1};

std::vector<Configuration> built_rows() {
  return test::rows_where([](const Configuration& row) { return cores::has_evaluator_core(row); });
}

class EachRow : public ::testing::TestWithParam<Configuration> {};

// Clocks add up to the formula, and at the paper's schedule vertices follow each other at that
// distance.
TEST_P(EachRow, ClocksOfAVertex) {
  const Configuration& row = GetParam();
  const Measurement measured = measure(row, kLittle);
  EXPECT_EQ(measured.mismatches, 0U) << measured.first_mismatch;
  const std::size_t each = gives_jacobian(row) ? 4 : 1;
  EXPECT_EQ(measured.checked, each * (8 + kLittle.vertices) + measured.seam_values / 3);
  EXPECT_GE(measured.seam_values, kLittle.seam_values);
  EXPECT_EQ(measured.seam_differences, 0U);
  EXPECT_EQ(measured.interval, expected_interval(row));
  EXPECT_GT(measured.max_error, 0);
  if (overlaps(row)) return;
  EXPECT_EQ(static_cast<double>(measured.vertex.clocks), paper_clocks(row));
  EXPECT_EQ(static_cast<double>(measured.vertex.final_accumulation), last_accumulation(row));
}

INSTANTIATE_TEST_SUITE_P(, EachRow, ::testing::ValuesIn(built_rows()), test::by_name);

/// tree8 of fx18 at both schedules.
Comparison small_comparison() {
  std::vector<const Configuration*> rows = {&find_configuration("tree8-fx18-paper"),
                                            &find_configuration("tree8-fx18-overlapped")};
  const OperatorCount count{{41, 31, 0}, {64, 48, 0}, 7};
  return compare(rows, {{rows[0]->name, count}, {rows[1]->name, count}}, kLittle,
                 [](std::size_t, std::size_t) {});
}

TEST(Comparison, JsonHasEveryField) {
  const auto json = nlohmann::json::parse(json_report(small_comparison()));
  ASSERT_EQ(json.at("rows").size(), 2U);
  for (const auto& row : json.at("rows")) {
    EXPECT_EQ(row.at("org"), "tree");
    EXPECT_EQ(row.at("n"), 8);
    EXPECT_EQ(row.at("formula"), 96);
    EXPECT_EQ(row.at("clocks_paper"), 96);
    EXPECT_EQ(row.at("equal"), true);
    EXPECT_EQ(row.at("final_accumulation"), 1);
    EXPECT_EQ(row.at("interval_overlapped"), 8);
    EXPECT_EQ(row.at("formula_overlapped"), 8);
    EXPECT_EQ(row.at("equal_overlapped"), true);
    EXPECT_EQ(row.at("fmac"), false);
    EXPECT_EQ(row.at("operators"), (nlohmann::json{{"mul", 41}, {"add", 31}, {"fma", 0}}));
    for (const char* field :
         {"format", "schedule", "evaluator", "mismatches", "checked", "max_error",
          "seam_differences", "simulation_vertices_per_s", "simulation_share"}) {
      EXPECT_TRUE(row.contains(field)) << field;
    }
  }
}

TEST(Comparison, WithoutPartnerFieldsAreNull) {
  std::vector<Row> rows = small_comparison().rows();
  const auto overlapped =
      nlohmann::json::parse(json_report(Comparison({rows[1]}, 1e6))).at("rows").at(0);
  EXPECT_TRUE(overlapped.at("clocks_paper").is_null());
  EXPECT_TRUE(overlapped.at("equal").is_null());
  const auto paper =
      nlohmann::json::parse(json_report(Comparison({rows[0]}, 1e6))).at("rows").at(0);
  for (const char* field : {"formula_overlapped", "interval_overlapped", "equal_overlapped"}) {
    EXPECT_TRUE(paper.at(field).is_null()) << field;
  }
  EXPECT_EQ(paper.at("simulation_share").get<double>(),
            paper.at("simulation_vertices_per_s").get<double>() / 1e6);
}

// Of one format; the first vertex and a little more lies in the window, and nothing outside it.
TEST(Comparison, TimelinesOfAFormat) {
  const Comparison comparison = small_comparison();
  const auto json = nlohmann::json::parse(timelines(comparison)).at("rows");
  ASSERT_EQ(json.size(), 2U);
  for (const auto& row : json) {
    EXPECT_EQ(row.at("org"), "tree");
    EXPECT_GT(row.at("clocks"), row.at("first_done"));
    EXPECT_GT(row.at("lanes").size(), 3U);
    for (const auto& lane : row.at("lanes")) {
      ASSERT_FALSE(lane.at("spans").empty()) << lane.at("name");
      for (const auto& span : lane.at("spans")) {
        EXPECT_LT(span.at(0), span.at(1));
        EXPECT_LE(span.at(1), row.at("clocks"));
      }
    }
  }
}

// fx18, and fx17 of organizations that have no rows of it.
TEST(Comparison, TimelinesAreOfOneFormatOfEachOrganization) {
  std::vector<const Configuration*> rows;
  std::map<std::string, OperatorCount> counts;
  for (const char* name :
       {"basic-fp32-overlapped", "basic-fx18-overlapped", "affine3-fx17-overlapped"}) {
    rows.push_back(&find_configuration(name));
    counts[name] = {{8, 6, 0}, {8, 6, 0}, 3};
  }
  const Comparison comparison = compare(rows, counts, kLittle, [](std::size_t, std::size_t) {});
  const auto json = nlohmann::json::parse(timelines(comparison)).at("rows");
  std::vector<std::string> shown;
  for (const auto& row : json) shown.push_back(row.at("name"));
  EXPECT_EQ(shown, (std::vector<std::string>{rows[1]->name, rows[2]->name}));
}

// An organization that the paper lacks has no formula, and that is no fault.
TEST(Comparison, BeyondThePaperThereIsNoFormula) {
  const Configuration& row = find_configuration("factored3-fx18-overlapped");
  const OperatorCount count{{96, 75, 0}, {96, 75, 0}, 4};
  const Comparison comparison =
      compare({&row}, {{row.name, count}}, kLittle, [](std::size_t, std::size_t) {});
  const auto json = nlohmann::json::parse(json_report(comparison)).at("rows").at(0);
  EXPECT_EQ(json.at("org"), "factored/3");
  EXPECT_EQ(json.at("interval_overlapped"), 3);
  EXPECT_EQ(json.at("mismatches"), 0);
  EXPECT_TRUE(json.at("formula").is_null());
  EXPECT_TRUE(json.at("equal").is_null());
  EXPECT_EQ(faults(comparison), "");
  EXPECT_GT(comparison.rows().front().vertices_per_s, 0);
}

// Of rows[0] at the paper's schedule and of rows[1], overlapped.
TEST(Comparison, FaultsAreSaid) {
  const std::vector<Row> good = small_comparison().rows();
  EXPECT_EQ(faults(Comparison(good, 1e6)), "");
  const auto spoiled = [&](auto change, std::size_t row = 0) {
    std::vector<Row> rows = good;
    change(rows[row].measured);
    return faults(Comparison(rows, 1e6));
  };
  EXPECT_NE(spoiled([](Measurement& m) { m.mismatches = 1; }), "");
  EXPECT_NE(spoiled([](Measurement& m) { m.seam_differences = 1; }), "");
  EXPECT_NE(spoiled([](Measurement& m) { m.vertex.clocks = 97; }), "");
  EXPECT_NE(spoiled([](Measurement& m) { m.interval = 97; }), "");
  EXPECT_NE(spoiled([](Measurement& m) { m.checked = 0; }), "");
  EXPECT_EQ(spoiled([](Measurement& m) { m.interval = 8.5; }, 1),
            "tree8-fx18-overlapped: 8.5 clocks between vertices, the formula says 8\n");
}

TEST(Comparison, OperatorsMustBeCounted) {
  EXPECT_THROW(compare({&find_configuration("tree8-fx18-paper")}, {}, kLittle,
                       [](std::size_t, std::size_t) {}),
               std::runtime_error);
}

}  // namespace
}  // namespace organizations
}  // namespace hwffd
