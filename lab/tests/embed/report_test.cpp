// What the study of embedding writes.
#include "embed/report.hpp"

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "embed/study.hpp"
#include "errors.hpp"
#include "sample_lattices.hpp"

namespace hwffd::test {
namespace {

TEST(EmbedReport, RowsAndFields) {
  const std::vector<embed::Row> rows = embed::by_construction(50, 3);
  ASSERT_EQ(rows.size(), lattice_kinds().size());
  const std::string json = embed::json_report(rows, 12.5);
  for (const char* const field :
       {"\"mesh\": \"by construction\"", "\"lattice\": \"sphere\"", "\"points\": 50",
        "\"inside\": 50", "\"not_converged\": 0",
        "\"max_residual_relative\": ", "\"newton_mean_iterations\": ", "\"folds\": \"proved"}) {
    expect_part(json, field);
  }
}

}  // namespace
}  // namespace hwffd::test
