// Interrupts of packets and of descriptors: each comes with what it tells of, and none without.
#include <gtest/gtest.h>

#include <algorithm>

#include "dma_bench.hpp"

namespace hwffd::test {
namespace {

class Marks : public testing::TestWithParam<std::string> {};
INSTANTIATE_TEST_SUITE_P(Dma, Marks, testing::ValuesIn(tb::throttle_names()),
                         [](const auto& name) { return name.param; });

/// In each clock: a pulse exactly where the count of results in memory has come past one with a
/// mark.
std::uint64_t expect_pulses(DmaBench& bench, std::uint64_t results) {
  std::uint64_t pulses = 0, counted = 0;
  for (int clock = 0; clock < 20000 && counted < results; ++clock) {
    bench.step();
    const auto& marked = bench.marked_results();
    const std::uint64_t count = bench.status.result_count;
    EXPECT_LE(count, marked.size());
    const bool any = std::find(marked.begin() + static_cast<std::ptrdiff_t>(counted),
                               marked.begin() + static_cast<std::ptrdiff_t>(count),
                               true) != marked.begin() + static_cast<std::ptrdiff_t>(count);
    EXPECT_EQ(bench.status.result_marked, any) << "result " << count;
    pulses += any ? 1 : 0;
    counted = count;
  }
  EXPECT_EQ(counted, results);
  return pulses;
}

TEST_P(Marks, OfResultsComeWhenTheyAreInMemory) {
  for (const double chance : {0.02, 0.2, 1.0}) {
    DmaBench bench(marked_dma_size(), 3);
    set_all_throttles(bench, GetParam(), GetParam());
    bench.memory.set_latency({1, 30});
    bench.mark_results(chance);
    bench.start_results(kArea, 1 << 16);
    bench.offer_results(300, 7);
    EXPECT_GT(expect_pulses(bench, 300), 2U);
    EXPECT_EQ(bench.faults(), "");
  }
}

/// A burst that failed tells nothing, nor does what lies beyond the area.
TEST(MarksOfResults, AreNotOfWhatIsNotInMemory) {
  DmaBench bench(marked_dma_size(), 4);
  bench.memory.fail_write(1, cores::kAxiSlverr);
  bench.mark_results(1.0);
  bench.start_results(kArea, 1 << 16);
  bench.offer_results(48, 16);
  unsigned pulses = 0;
  for (int clock = 0; clock < 400; ++clock) {
    bench.step();
    pulses += bench.status.result_marked ? 1 : 0;
  }
  EXPECT_EQ(bench.status.result_count, 16U);
  EXPECT_EQ(pulses, 1U);
  DmaBench full(marked_dma_size(), 5);
  full.start_results(kArea, 4 * kBeat);
  full.offer_results(4, 4);
  full.run(50);
  full.mark_results(1.0);
  full.offer_results(4, 4);
  for (int clock = 0; clock < 100; ++clock) {
    full.step();
    EXPECT_FALSE(full.status.result_marked);
  }
  EXPECT_TRUE(full.status.result_overflow);
}

/// The tail moves in the clock after the pulse.
TEST_P(Marks, OfDescriptorsComeWithTheTail) {
  for (const unsigned every : {1U, 2U, 5U}) {
    DmaBench bench(marked_dma_size(), every);
    set_all_throttles(bench, GetParam(), GetParam());
    bench.memory.set_latency({1, 20});
    bench.place_ring(kRing, 4);
    for (unsigned i = 0; i < 15; ++i) {
      const std::uint64_t address = kPackets + i * 0x1000, beats = 1 + i % 4 * 9;
      bench.put_descriptor(
          {address, static_cast<std::uint32_t>(beats * kBeat), i % every == 0 ? 1U : 0U});
      bench.expect_packet(address, beats);
    }
    bench.start_ring();
    bool pulse = false;
    unsigned tail = 0, pulses = 0;
    for (int clock = 0; clock < 20000 && tail < 15; ++clock) {
      bench.step();
      const bool moved = bench.status.ring_tail != tail;
      EXPECT_EQ(pulse, moved && tail % every == 0) << tail;
      tail = bench.status.ring_tail;
      pulse = bench.status.ring_marked;
      pulses += pulse ? 1 : 0;
    }
    EXPECT_EQ(pulses, (15 + every - 1) / every);
    EXPECT_TRUE(bench.run_until_idle());
    EXPECT_TRUE(bench.exact(15));
  }
}

/// All other flags are refused as in a core without them.
TEST(MarksOfDescriptors, AreTheOnlyFlag) {
  for (unsigned flag = 1; flag < 32; ++flag) {
    DmaBench bench(marked_dma_size(), flag);
    bench.put_packet(kPackets, 3);
    bench.put_descriptor({kPackets, 64, 1U << flag | 1U});
    EXPECT_TRUE(bench.refuses(1, kFlags)) << flag;
    EXPECT_TRUE(bench.exact());
  }
}

}  // namespace
}  // namespace hwffd::test
