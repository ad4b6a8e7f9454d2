// A soft reset at every clock of a short transfer: the bus ends in order, the next transfer is
// exact.
#include <gtest/gtest.h>

#include "dma_bench.hpp"

namespace hwffd::test {
namespace {

constexpr std::uint64_t kResults = 23;

class SoftReset : public PerDmaSize {};
HWFFD_FOR_EACH_DMA_SIZE(SoftReset);

/// Starts both halves: packets of 1, 30 and 6 beats, 23 results into the area at `area`.
void start(DmaBench& bench, std::uint64_t area) {
  bench.place_ring(kRing, 2);
  std::uint64_t at = kPackets - 3 * kBeat;
  for (std::uint64_t beats : {1, 30, 6}) {
    bench.put_packet(at, beats);
    at += beats * kBeat;
  }
  bench.offer_results(kResults, 7);
  bench.place_area(area, kResults * kBeat);
  bench.start_ring();
}

bool done(const DmaBench& bench) {
  return bench.status.idle && bench.results_waiting() == 0 &&
         bench.status.result_count == kResults && bench.packets().size() == 37;
}

/// Resets after `clocks`, then wants a whole transfer; false when the first one had ended by then.
bool reset_after(DmaBench& bench, std::uint64_t clocks) {
  start(bench, kArea);
  bench.run(clocks);
  const bool ended = done(bench);
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

  bench.forget_packets();
  bench.forget_results();
  start(bench, kArea + 0x1000);
  EXPECT_TRUE(bench.run_until([&] { return done(bench); }, 5000));
  EXPECT_EQ(bench.packet_difference(), "");
  EXPECT_EQ(bench.results_in_memory(kArea + 0x1000, 0, kResults), kResults);
  EXPECT_EQ(bench.memory.changed_outside({{kRing, kRing + 63},
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
      EXPECT_EQ(bench.faults(), "");
      ASSERT_FALSE(HasFailure());
    }
    EXPECT_GT(clocks, 60u);
  }
}

TEST_P(SoftReset, AfterAnErrorAndWhileHeld) {
  for (std::uint64_t wait = 0; wait < 40; ++wait) {
    DmaBench bench(GetParam(), wait);
    bench.memory.set_latency({8, 8});
    start(bench, kArea);
    bench.memory.fail_read_at(kPackets, 2, cores::kAxiSlverr);
    bench.memory.fail_write(0, cores::kAxiSlverr);
    bench.run(wait);
    bench.memory.fail_nothing();
    bench.begin_soft_reset();
    ASSERT_TRUE(bench.end_soft_reset(2000));
    bench.forget_packets();
    bench.forget_results();
    bench.checker.restarted();
    start(bench, kArea + 0x1000);
    ASSERT_TRUE(bench.run_until([&] { return done(bench); }, 3000));
    EXPECT_EQ(bench.packet_difference(), "");
    EXPECT_EQ(bench.results_in_memory(kArea + 0x1000, 0, kResults), kResults);
    EXPECT_EQ(bench.faults(), "");
  }
}

}  // namespace
}  // namespace hwffd::test
