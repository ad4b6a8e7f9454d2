// An error response stops the engine: no address after it, what is open ends, a start goes on.
#include <gtest/gtest.h>

#include "dma_bench.hpp"

namespace hwffd::test {
namespace {

class BusError : public PerDmaSize {};
HWFFD_FOR_EACH_DMA_SIZE(BusError);

/// Where the read burst that holds packet beat `beat` (of a packet at kPackets + 0x1000) starts.
std::uint64_t burst_of(const DmaBench& bench, std::uint64_t beat) {
  const std::uint64_t address = kPackets + 0x1000 + beat * kBeat;
  for (const auto& read : bench.memory.reads()) {
    if (read.address <= address && address < read.address + read.beats * kBeat) {
      return read.address;
    }
  }
  return 0;
}

/// Three packets; the read that brings beat `failing` of the second one, of `second` beats, fails.
void fail_beat(const DmaSize& size, std::uint64_t second, std::uint64_t failing,
               cores::AxiResponse response, const std::string& throttle) {
  constexpr std::uint64_t kFirst = 5, kThird = 9;
  SCOPED_TRACE(testing::Message() << "beat " << failing << " " << throttle);
  DmaBench bench(size, failing + response);
  set_all_throttles(bench, throttle, throttle);
  bench.memory.set_latency({1, 10});
  bench.put_packet(kPackets, kFirst);
  bench.put_packet(kPackets + 0x1000, second);
  bench.put_packet(kPackets + 0x2000, kThird);
  // Bursts end at multiples of max_burst, and 0x1000 is such a border.
  const std::uint64_t length = std::min<std::uint64_t>(bench.size().max_burst, second);
  const std::uint64_t target = kPackets + 0x1000 + failing / length * length * kBeat;
  bench.memory.fail_read_at(target, failing % length, response);
  bench.start_ring();
  ASSERT_TRUE(bench.run_until_error());
  ASSERT_TRUE(bench.run_until_stopped());
  bench.run(30);
  const unsigned code = response == cores::kAxiDecerr ? kDecodeError : kSlaveError;
  EXPECT_TRUE(only(bench.read_errors(), code, burst_of(bench, failing)));
  EXPECT_EQ(bench.status.ring_tail, 1);
  // The first packet, and of the second what came before the error, ended by `last`.
  const std::uint64_t good = kFirst + failing / bench.blocks() * bench.blocks();
  std::vector<Beat> wanted(bench.expected().begin(), bench.expected().begin() + good);
  wanted.back().last = true;
  EXPECT_TRUE(bench.packets() == wanted) << bench.packets().size() << " of " << wanted.size();
  EXPECT_TRUE(bench.memory.quiet());

  // Again from the second packet on.
  bench.memory.fail_nothing();
  bench.forget_packets();
  bench.expect_packet(kPackets + 0x1000, second);
  bench.expect_packet(kPackets + 0x2000, kThird);
  EXPECT_TRUE(bench.reads(3));
  EXPECT_EQ(bench.read_errors().size(), 1u);
}

TEST_P(BusError, ReadErrorOnEveryBeat) {
  for (std::uint64_t beat = 0; beat < 38; ++beat) {
    fail_beat(GetParam(), 38, beat, cores::kAxiSlverr, "always");
    fail_beat(GetParam(), 38, beat, cores::kAxiDecerr, "bernoulli");
    fail_beat(GetParam(), 38, beat, cores::kAxiExOkay, "bursts");
  }
}

TEST_P(BusError, ReadErrorOnEveryBeatOfTheLongestBurst) {
  const std::uint64_t longest = GetParam().max_burst;
  for (std::uint64_t beat = 0; beat < longest; ++beat) {
    fail_beat(GetParam(), longest, beat, cores::kAxiSlverr, "bernoulli");
  }
}

TEST_P(BusError, DescriptorFetchFails) {
  unsigned earlier = 0;
  for (unsigned index = 0; index < 5; ++index) {
    DmaBench bench(GetParam(), index);
    bench.memory.set_latency({1, 10});
    bench.put_packets(5, 7);
    bench.memory.fail_read_at(bench.descriptor_address(index), 0, cores::kAxiDecerr);
    bench.start_ring();
    ASSERT_TRUE(bench.run_until_error(3000));
    ASSERT_TRUE(bench.run_until_idle());
    EXPECT_FALSE(bench.status.ring_running);
    EXPECT_TRUE(only(bench.read_errors(), kDecodeError, bench.descriptor_address(index)));
    EXPECT_LE(bench.status.ring_tail, index);
    earlier += bench.status.ring_tail < index ? 1 : 0;
    EXPECT_EQ(bench.packets().size(), 7u * bench.status.ring_tail);
    bench.memory.fail_nothing();
    ASSERT_TRUE(bench.reads(5));
  }
  EXPECT_GT(earlier, 0u) << "descriptors are fetched ahead of packets";
}

TEST_P(BusError, WriteErrorOnEveryBurst) {
  for (std::uint64_t failing = 0; failing < 8; ++failing) {
    for (const std::string throttle : {"always", "bernoulli"}) {
      DmaBench bench(GetParam(), failing);
      const std::uint64_t burst = bench.size().max_burst, results = 8 * burst;
      set_all_throttles(bench, throttle, throttle);
      bench.memory.set_latency({1, 30});
      bench.memory.fail_write(failing, failing % 2 ? cores::kAxiDecerr : cores::kAxiSlverr);
      bench.start_results(kArea, 1 << 20);
      bench.offer_results(results, burst);
      ASSERT_TRUE(bench.run_until_error());
      ASSERT_TRUE(bench.run_until([&] { return !bench.status.result_running; }));
      bench.run(40);
      const std::uint64_t failed = bench.memory.writes()[failing].address;
      EXPECT_TRUE(only(bench.write_errors(), failing % 2 ? kDecodeError : kSlaveError, failed));
      // What was counted lies before the failed burst, and is in memory.
      const std::uint64_t counted = bench.status.result_count;
      EXPECT_EQ(kArea + counted * kBeat, failed);
      EXPECT_TRUE(bench.writes(kArea, 0, counted));
      EXPECT_TRUE(bench.memory.quiet());

      // What no burst had taken goes to the next area.
      std::uint64_t taken = 0;
      for (const auto& write : bench.memory.writes()) taken += write.beats;
      bench.start_results(kArea + (1 << 20), 1 << 20);
      bench.step();
      EXPECT_EQ(bench.status.result_count, counted) << "of the start before, for one clock more";
      bench.step();
      EXPECT_EQ(bench.status.result_count, 0U);
      ASSERT_TRUE(bench.writes(kArea + (1 << 20), taken, results - taken));
    }
  }
}

// Whatever the clocks between a bad answer and the burst that would come next: one that begins in
// the clock of the answer is the last, or one that is in the guard then.
TEST_P(BusError, NoBurstBeginsBehindABadAnswer) {
  for (std::uint64_t gap = 0; gap <= 30; ++gap) {
    SCOPED_TRACE(testing::Message() << gap << " clocks");
    DmaBench bench(GetParam(), gap);
    bench.memory.set_latency({16, 16});
    bench.memory.fail_write(0, cores::kAxiSlverr);
    bench.start_results(kArea, 1 << 20);
    bench.run(10);
    bench.offer_results(1, 1);
    bool answered = false;
    std::size_t writes = 0;
    std::uint64_t behind = 0;  // clocks
    for (std::uint64_t clock = 0; clock < 100; ++clock) {
      if (clock == gap) bench.offer_results(1, 1);
      bench.step();
      // What was raised in the clock behind the answer has been taken.
      behind += answered ? 1 : 0;
      if (behind == 1 + GetParam().guard()) writes = bench.memory.writes().size();
      answered = answered || (bench.bus().b.valid && bench.bus().b.ready);
    }
    ASSERT_TRUE(answered);
    EXPECT_EQ(bench.memory.writes().size(), writes);
    EXPECT_EQ(bench.write_errors().size(), 1u);
    EXPECT_EQ(bench.faults(), "");
  }
}

TEST_P(BusError, AReadErrorHoldsTheWriterUntilTheRingIsStarted) {
  DmaBench bench(GetParam(), 3);
  bench.put_packet(kPackets, 30);
  bench.memory.fail_read_at(kPackets, 2, cores::kAxiSlverr);
  bench.start_results(kArea, 1 << 16);
  bench.start_ring();
  ASSERT_TRUE(bench.run_until_error());
  bench.offer_results(bench.size().depth / 2, 1);
  bench.run(300);
  EXPECT_TRUE(bench.memory.writes().empty());
  EXPECT_TRUE(bench.status.halted);
  bench.memory.fail_nothing();
  bench.forget_packets();
  bench.expect_packet(kPackets, 30);
  bench.start_ring();
  ASSERT_TRUE(bench.run_until_counted(bench.size().depth / 2));
  ASSERT_TRUE(bench.run_until_idle());
  EXPECT_TRUE(bench.exact());
}

// Bursts of results are on their way when a packet fails: halted comes behind them.
TEST_P(BusError, AReadErrorHaltsWhenNoBurstIsOpen) {
  for (std::uint64_t clocks = 0; clocks < 30; ++clocks) {
    SCOPED_TRACE(testing::Message() << clocks << " clocks");
    DmaBench bench(GetParam(), clocks);
    bench.memory.set_latency({16, 16});
    bench.put_packet(kPackets, 1);
    bench.memory.fail_read_at(kPackets, 0, cores::kAxiSlverr);
    bench.start_results(kArea, 1 << 16);
    bench.run(20);
    bench.start_ring();
    bench.run(25 + clocks);
    bench.offer_results(2, 1);
    ASSERT_TRUE(bench.run_until([&] { return bench.status.halted; }, 200));
    EXPECT_TRUE(bench.memory.quiet());
    EXPECT_EQ(bench.read_errors().size(), 1u);
    EXPECT_EQ(bench.faults(), "");
  }
}

TEST_P(BusError, AWriteErrorHoldsTheReaderUntilResultsAreStarted) {
  DmaBench bench(GetParam(), 4);
  bench.memory.set_latency({3, 3});
  bench.put_packet(kPackets, 1000);
  bench.memory.fail_write(0, cores::kAxiSlverr);
  bench.start_results(kArea, 1 << 16);
  bench.offer_results(1, 1);
  bench.start_ring();
  ASSERT_TRUE(bench.run_until_error());
  ASSERT_TRUE(bench.run_until([&] { return bench.status.halted; }));
  EXPECT_TRUE(bench.memory.quiet()) << "halted with bursts open";
  bench.run(1200);
  EXPECT_LT(bench.packets().size(), 1000u);
  EXPECT_TRUE(bench.status.halted);
  bench.start_results(kArea, 1 << 16);
  ASSERT_TRUE(bench.run_until_idle());
  EXPECT_FALSE(bench.status.halted);
  EXPECT_TRUE(bench.exact());
  EXPECT_TRUE(bench.read_errors().empty());
}

}  // namespace
}  // namespace hwffd::test
