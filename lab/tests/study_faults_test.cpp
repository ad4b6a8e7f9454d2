// What the studies without RTL say of a result that does not hold: a program ends with 1 where this
// is not empty.
#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "bfp/report.hpp"
#include "embed/report.hpp"
#include "hwffd/numerics/largest_error.hpp"
#include "program.hpp"
#include "words/report.hpp"

namespace hwffd {
namespace {

bool has(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

TEST(Conclude, WhatIsWrongIsSaidAndEndsWithOne) {
  testing::internal::CaptureStderr();
  EXPECT_EQ(conclude(""), 0);
  EXPECT_EQ(testing::internal::GetCapturedStderr(), "");
  testing::internal::CaptureStderr();
  EXPECT_EQ(conclude("a row: wrong\n"), 1);
  EXPECT_EQ(testing::internal::GetCapturedStderr(), "a row: wrong\n");
}

TEST(LargestError, WhatIsNoNumberIsInfinite) {
  double largest = 0;
  raise_to(largest, 2);
  raise_to(largest, 1);
  EXPECT_EQ(largest, 2);
  raise_to(largest, std::nan(""));
  raise_to(largest, 3);
  EXPECT_EQ(largest, HUGE_VAL);
}

embed::Row embedded() {
  embed::Row row{"cat.3ds", "sphere", {4, 4, 4}, {}, 2.0, {}, true};
  row.summary.points = row.summary.inside = 10;
  row.summary.worst_residual = 1e-9;
  return row;
}

TEST(EmbedFaults, PointsThatWereNotPlaced) {
  EXPECT_EQ(embed::faults({embedded(), embedded()}), "");
  embed::Row row = embedded();
  row.summary.not_converged = 1;
  EXPECT_TRUE(has(embed::faults({embedded(), row}), "cat.3ds in sphere: 1 of 10 points not conv"));
  row = embedded();
  row.summary.outside = 3;
  EXPECT_TRUE(has(embed::faults({row}), "3 of 10 points outside"));
  row.holds_all = false;
  EXPECT_EQ(embed::faults({row}), "");
  row.summary.points = 0;
  EXPECT_TRUE(has(embed::faults({row}), "no points"));
}

TEST(EmbedFaults, PointsThatDoNotComeBack) {
  embed::Row row = embedded();
  for (const double residual : {2.1e-9, HUGE_VAL, std::nan("")}) {
    row.summary.worst_residual = residual;
    EXPECT_TRUE(has(embed::faults({row}), "residual")) << residual;
  }
}

TEST(WordFaults, ErrorsAboveTheirBounds) {
  const words::Result good{"product", "fx18", 18, true, 1e-4, 1e-5, 1e-4, 10};
  EXPECT_EQ(words::faults({good, good}), "");
  words::Result bad = good;
  bad.max_error = 1.1e-4;
  EXPECT_TRUE(has(words::faults({good, bad}), "product fx18: error 1.100e-04 over 10 vertices"));
  bad.max_error = std::nan("");
  EXPECT_NE(words::faults({bad}), "");
  bad = good;
  bad.vertices = 0;
  EXPECT_NE(words::faults({bad}), "");
}

TEST(BfpFaults, ErrorsAboveTheirBounds) {
  const bfp::Agreement same{"product", {"basic", "cg1"}, 100, 0, 0};
  bfp::Result result{"uniform", "product", 0.5, 0.6, 0.5, 10};
  EXPECT_EQ(bfp::faults({result}, {same}), "");
  result.of_lattice = 0.51;
  EXPECT_TRUE(has(bfp::faults({result}, {same}), "uniform, product: error 0.51 ulp"));
}

TEST(BfpFaults, RowsThatDiffer) {
  const bfp::Result good{"uniform", "product", 0.5, 0.6, 0.5, 10};
  bfp::Agreement agreement{"product", {"basic", "cg1"}, 100, 1, 0};
  EXPECT_TRUE(has(bfp::faults({good}, {agreement}), "1 results differ from the model's"));
  agreement = {"product", {"basic", "cg1"}, 100, 0, 2};
  EXPECT_TRUE(has(bfp::faults({good}, {agreement}), "2 from those of basic"));
  EXPECT_NE(bfp::faults({good}, {}), "") << "nothing was compared";
}

}  // namespace
}  // namespace hwffd
