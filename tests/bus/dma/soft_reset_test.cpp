// A soft reset at every clock of a short transfer: the bus ends in order, the next transfer is
// exact.
#include <gtest/gtest.h>

#include "transfer.hpp"

namespace hwffd::test {
namespace {

constexpr std::uint64_t kResults = 23;

class SoftReset : public PerDmaSize {};
HWFFD_FOR_EACH_DMA_SIZE(SoftReset);

const Transfer kTransfer{
    {{kPackets - 3 * kBeat, 1}, {kPackets - 2 * kBeat, 30}, {kPackets + 28 * kBeat, 6}}, kResults};

/// Resets after `clocks`, then wants a whole transfer; false when the first one had ended by then.
bool reset_after(DmaBench& bench, std::uint64_t clocks) {
  kTransfer.start(bench, kArea);
  bench.run(clocks);
  const bool ended = kTransfer.done(bench);
  bench.begin_soft_reset();
  const std::size_t reads = bench.memory.reads().size(), writes = bench.memory.writes().size();
  EXPECT_TRUE(bench.end_soft_reset(5000));
  // At most the address that was being raised.
  EXPECT_LE(bench.memory.reads().size(), reads + 2);
  EXPECT_LE(bench.memory.writes().size(), writes + 2);
  EXPECT_TRUE(bench.memory.quiet());
  EXPECT_EQ(bench.status.ring_tail, 0);
  EXPECT_EQ(bench.status.result_count, 0u);
  EXPECT_FALSE(bench.status.ring_running || bench.status.result_running);
  const std::uint64_t beats = bench.memory.read_beats() + bench.memory.write_beats();
  bench.run(10);
  EXPECT_EQ(bench.memory.read_beats() + bench.memory.write_beats(), beats);

  kTransfer.expect_next(bench);
  EXPECT_EQ(bench.memory.changed_outside({{kRing, kRing + 127},
                                          {kPackets - 3 * kBeat, kPackets + 34 * kBeat - 1},
                                          {kArea, kArea + kResults * kBeat - 1},
                                          {kArea + 0x1000, kArea + 0x1000 + kResults * kBeat - 1}}),
            0u);
  EXPECT_TRUE(bench.read_errors().empty() && bench.write_errors().empty());
  return !ended;
}

TEST_P(SoftReset, AtEveryClock) {
  for (const std::string throttle : {"always", "bernoulli", "sparse"}) {
    std::uint64_t clocks = 0;
    bool inside = true;
    for (; inside; ++clocks) {
      SCOPED_TRACE(testing::Message() << throttle << ", after " << clocks << " clocks");
      DmaBench bench(GetParam(), 11);
      set_all_throttles(bench, throttle, throttle);
      bench.memory.set_latency({1, 12});
      inside = reset_after(bench, clocks);
      ASSERT_FALSE(HasFailure());
    }
    EXPECT_GT(clocks, 60u);
  }
}

// In the first clock in which clearing_o is low, no earlier and no later.
TEST_P(SoftReset, AStartCountsFromItsEndOn) {
  const auto after = [](std::uint64_t clocks, bool& clearing) {
    DmaBench bench(GetParam(), 12);
    bench.controls.soft_reset = true;
    bench.step();
    bench.run(clocks);
    bench.place_area(kArea, 1 << 12);
    bench.start_ring();
    clearing = bench.status.clearing;
    bench.run(5);
    EXPECT_EQ(bench.status.ring_running, bench.status.result_running);
    return bench.status.result_running;
  };
  bool clearing = true;
  std::uint64_t clocks = 0;
  for (; clearing; ++clocks) {
    ASSERT_LT(clocks, 50u);
    const bool runs = after(clocks, clearing);
    EXPECT_EQ(runs, !clearing) << clocks;
  }
  EXPECT_GT(clocks, 1u);
}

// One more begins another, in its last clock too.
TEST_P(SoftReset, IsNotLostAtItsEnd) {
  for (std::uint64_t clocks = 0; clocks < 20; ++clocks) {
    DmaBench bench(GetParam(), 13);
    bench.controls.soft_reset = true;
    bench.step();
    bench.run(clocks);
    bench.controls.soft_reset = true;
    bench.step();
    bench.step();
    EXPECT_TRUE(bench.status.clearing) << clocks;
    EXPECT_TRUE(bench.end_soft_reset(50));
  }
}

TEST_P(SoftReset, NothingStartsInReset) {
  DmaBench bench(GetParam(), 14);
  bench.put_packet(kPackets, 2);
  bench.ring_doorbell();
  bench.controls.rst = true;
  for (int clocks = 0; clocks < 5; ++clocks) {
    bench.controls.soft_reset = bench.controls.ring_start = true;
    bench.place_area(kArea, 256);
    bench.step();
  }
  bench.controls.rst = false;
  bench.controls.ring_start = true;  // the halves are in reset for a clock more
  bench.place_area(kArea, 256);
  for (int clocks = 0; clocks < 60; ++clocks) {
    bench.step();
    EXPECT_FALSE(bench.status.clearing || bench.status.ring_running ||
                 bench.status.result_running || bench.status.result_busy);
  }
  EXPECT_TRUE(bench.memory.reads().empty() && bench.memory.writes().empty());
  EXPECT_TRUE(bench.read_errors().empty() && bench.write_errors().empty());
  EXPECT_TRUE(bench.reads(1));
}

TEST_P(SoftReset, AfterAnErrorAndWhileHeld) {
  for (std::uint64_t wait = 0; wait < 40; ++wait) {
    DmaBench bench(GetParam(), wait);
    bench.memory.set_latency({8, 8});
    kTransfer.start(bench, kArea);
    bench.memory.fail_read_at(kPackets, 2, cores::kAxiSlverr);
    bench.memory.fail_write(0, cores::kAxiSlverr);
    bench.run(wait);
    bench.memory.fail_nothing();
    bench.begin_soft_reset();
    ASSERT_TRUE(bench.end_soft_reset(2000));
    bench.checker.restarted();
    kTransfer.expect_next(bench);
    ASSERT_FALSE(HasFailure());
  }
}

}  // namespace
}  // namespace hwffd::test
