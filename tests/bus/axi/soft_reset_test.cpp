// Resets while packets and results are on their way: open bursts are completed, then all is as new
// and the next run exact.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include "axi_run.hpp"

namespace hwffd::test {
namespace {

class AxiReset : public PerAxiConfiguration {
 protected:
  /// Packets of all kinds, the last of them long.
  void prepare(AxiRun& run) {
    run.send_scene(20);
    run.send(interleaved_packet(make_stimulus("random", run.codec(), 2, run.random().bits())));
    run.send_vertices(60);
  }
  /// The moments, in clocks after the start: dense at first, then over the whole run.
  static std::vector<std::uint64_t> moments() {
    std::vector<std::uint64_t> clocks;
    for (std::uint64_t clock = 0; clock < 7000; clock += 1 + clock / 12) clocks.push_back(clock);
    return clocks;
  }
};

TEST_P(AxiReset, SoftResetAtAnyMoment) {
  std::uint64_t busy = 0;
  for (const char* throttles : {"always", "bernoulli"}) {
    AxiRun run(GetParam(), 1, throttles);
    for (const std::uint64_t clock : moments()) {
      prepare(run);
      run.start();
      run.system().run(clock);
      busy += (run.system().read32(HWFFD_STATUS_OFFSET) & HWFFD_STATUS_BUSY_MASK) != 0 ? 1 : 0;
      ASSERT_TRUE(run.soft_reset()) << clock;
      EXPECT_TRUE(run.system().memory.quiet()) << "after " << clock << " clocks a burst is open";
      EXPECT_EQ(run.driver().result_count(), 0U);
      EXPECT_EQ(run.driver().take_errors().status, 0U) << clock;
      ASSERT_TRUE(run.good_run()) << clock;
    }
    EXPECT_TRUE(run.clean());
  }
  EXPECT_GT(busy, 40U);
  fmt::print("{} soft resets, {} of them while busy\n", 2 * moments().size(), busy);
}

/// Nothing is loaded after a soft reset: neither coefficients nor a lattice.
TEST_P(AxiReset, SoftResetUnloads) {
  AxiRun run(GetParam(), 2);
  ASSERT_TRUE(run.good_run());
  ASSERT_TRUE(run.soft_reset());
  run.send(vertices_packet(random_vertices(run.codec(), run.random(), {4, 4, 4}, 2)));
  ASSERT_TRUE(run.go());
  EXPECT_EQ(run.result_word(0, 3) >> 16, kStatusUnloaded >> 16);
  const std::uint32_t both = 1U << kNoCoefficients | 1U << kNoLattice;
  EXPECT_EQ(run.driver().take_errors().status, both);
  EXPECT_TRUE(run.ends_well());
}

/// A soft reset changes no register but what the hardware says.
TEST_P(AxiReset, SoftResetKeepsRegisters) {
  AxiRun run(GetParam(), 3);
  run.send({{{0x77, 0, 0, 0}, true}});
  ASSERT_TRUE(run.go());
  run.driver().take_errors();
  ASSERT_TRUE(run.good_run());
  ASSERT_TRUE(run.soft_reset());
  EXPECT_TRUE(run.driver().windows_locked());
  EXPECT_EQ(run.system().read32(HWFFD_READ_WINDOW_BASE_LO_OFFSET), kReadWindow.base);
  EXPECT_GT(run.driver().counters().vertices, 0U);
  EXPECT_EQ(run.system().read32(HWFFD_ERROR_COUNT_OFFSET), 1U);
  EXPECT_TRUE(run.ends_well());
}

/// One edge of aresetn, on the whole bus: nothing of the run before is among the results of the
/// next.
TEST_P(AxiReset, OneEdgeOfHardResetAtAnyMoment) {
  constexpr int kResets = 220;
  constexpr std::uint64_t kLongest = 3000;
  std::uint64_t unfinished = 0;
  for (const char* throttles : {"always", "bernoulli"}) {
    AxiRun run(GetParam(), 4, throttles);
    for (int reset = 0; reset < kResets / 2; ++reset) {
      prepare(run);
      run.start();
      run.system().run(run.random().below(kLongest));
      unfinished += run.system().read32(HWFFD_STATUS_OFFSET) & HWFFD_STATUS_BUSY_MASK;
      run.hard_reset(1);
      EXPECT_FALSE(run.system().interrupt());
      EXPECT_EQ(run.driver().take_errors().status, 0U) << reset;
      EXPECT_EQ(run.driver().counters().vertices, 0U) << reset;
      ASSERT_TRUE(run.ends_well()) << throttles << ", reset " << reset;
    }
  }
  EXPECT_GT(unfinished, std::uint64_t{kResets / 20});
}

HWFFD_FOR_EACH_AXI_CONFIGURATION(AxiReset);

}  // namespace
}  // namespace hwffd::test
