// What `make sim` says of a run that is no good: it ends with 1 where this is not empty.
#include "sim/report.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace hwffd::sim {
namespace {

RunResult good() {
  RunResult result{{}, "twist:90", 10, 0, 64, 1e-7, 1e-8, {}, {}, {}};
  result.row.name = "basic-fx18-overlapped";
  return result;
}

TEST(SimFaults, RunsThatAreNoGood) {
  EXPECT_EQ(faults(good()), "");
  RunResult result = good();
  result.failure = "watchdog";
  EXPECT_EQ(faults(result), "watchdog\n");
  result = good();
  result.mismatches = 2;
  EXPECT_EQ(faults(result),
            "basic-fx18-overlapped twist:90: 2 of 10 results differ from the model\n");
  result = good();
  result.checked = 0;
  EXPECT_NE(faults(result), "") << "nothing was compared";
  result = good();
  result.max_error = std::nan("");
  EXPECT_NE(faults(result), "");
}

}  // namespace
}  // namespace hwffd::sim
