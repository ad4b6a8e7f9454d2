// A netlist in which one LUT is wrong: the bench must find it.
#include <gtest/gtest.h>

#include "system_run.hpp"

namespace hwffd::test {
namespace {

class FaultyNetlist : public PerConfiguration {};

TEST_P(FaultyNetlist, IsFound) {
  SystemRun run(GetParam(), 1);
  run.send_bspline();
  run.send(interleaved_packet(make_stimulus("random", run.codec(), 8, 1)));
  EXPECT_FALSE(run.run());
  EXPECT_GT(run.bench().scoreboard().mismatches(), 0U);
}

HWFFD_FOR_EACH_CONFIGURATION(FaultyNetlist);

}  // namespace
}  // namespace hwffd::test
