// What `make -C lab tangents` says of a row that does not hold: it ends with 1 where this is not
// empty.
#include <gtest/gtest.h>

#include <cmath>

#include "tangents/report.hpp"

namespace hwffd::tangents {
namespace {

RowResult good() {
  RowResult result{};
  result.row.name = "basic-fx18-overlapped";
  result.vertices = result.upright = result.folded = 10;
  result.bound = result.determinant_bound = 1e-4;
  result.max_error = result.max_difference = result.max_determinant_error = 1e-4;
  result.seam_values = kSeamValues;
  return result;
}

/// Whether one fault is said, with this text in it.
bool says(void (*spoil)(RowResult&), const std::string& part) {
  RowResult row = good();
  spoil(row);
  const std::string text = faults(row);
  return text.rfind("basic-fx18-overlapped: ", 0) == 0 && text.find(part) != std::string::npos &&
         text.find('\n') == text.size() - 1;
}

TEST(TangentFaults, EachIsSaid) {
  EXPECT_EQ(faults(good()), "");
  EXPECT_TRUE(says([](RowResult& r) { r.failure = "watchdog"; }, "watchdog"));
  EXPECT_TRUE(says([](RowResult& r) { r.mismatches = 3; }, "3 results differ from the model"));
  EXPECT_TRUE(says([](RowResult& r) { r.max_error = 2e-4; }, "error of a derivative 2.00e-04"));
  EXPECT_TRUE(says([](RowResult& r) { r.max_difference = HUGE_VAL; }, "central differences"));
  EXPECT_TRUE(says([](RowResult& r) { r.max_determinant_error = 2e-4; }, "error of det J"));
  EXPECT_TRUE(says([](RowResult& r) { r.wrong_flags = 1; }, "1 wrong fold flags"));
  EXPECT_TRUE(says([](RowResult& r) { r.seam_differences = 1; }, "1 of 60000 values differ"));
  EXPECT_TRUE(says([](RowResult& r) { r.seam_values = 1; }, "too little tried"));
  EXPECT_TRUE(says([](RowResult& r) { r.folded = 0; }, "too little tried"));
}

}  // namespace
}  // namespace hwffd::tangents
