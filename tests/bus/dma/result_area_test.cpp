// A result area from its start to the next one: partly used, full, failed, flushed.
#include <gtest/gtest.h>

#include "dma_bench.hpp"

namespace hwffd::test {
namespace {

constexpr std::uint64_t kFirst = 0x10000;  // a border of every burst
constexpr std::uint64_t kNext = 0x90000;

class ResultArea : public PerDmaSize {};
HWFFD_FOR_EACH_DMA_SIZE(ResultArea);

TEST_P(ResultArea, TheNextOneBeginsWhereTheOldOneIsPartlyUsed) {
  for (const std::uint64_t used : {0, 1, 3, 17, 63}) {
    DmaBench bench(GetParam(), used);
    bench.start_results(kFirst, 64 * kBeat);
    bench.run(10);
    bench.offer_results(used, used);
    ASSERT_TRUE(bench.writes(kFirst, 0, used));
    bench.start_results(kNext, 64 * kBeat);
    bench.offer_results(20, 20);
    ASSERT_TRUE(bench.writes(kNext, used, 20));
    EXPECT_EQ(bench.memory.changed_outside({{kFirst, kFirst + used * kBeat - (used != 0 ? 1 : 0)},
                                            {kNext, kNext + 20 * kBeat - 1}}),
              0u);
    EXPECT_FALSE(bench.status.result_overflow);
  }
}

// As many as take 18 bits, in an odd number of bursts each time.
TEST(LargeArea, IsCountedToItsEnd) {
  constexpr std::uint64_t kResults = (1u << 18) + 5;
  DmaBench bench(small_dma_size(), 1);
  bench.start_results(kFirst, kResults * kBeat);
  bench.run(10);
  for (std::uint64_t count = 0; count < kResults;) {
    const std::uint64_t more = std::min<std::uint64_t>(kResults - count, 1004);
    bench.offer_results(more, more);
    count += more;
    ASSERT_TRUE(bench.run_until_counted(count));
  }
  EXPECT_EQ(bench.results_in_memory(kFirst, 0, kResults), kResults);
  EXPECT_EQ(bench.faults(), "");
}

// Of a slave that answers before it takes data: of every burst that has gone out the data follows,
// and there are no more of them than their lengths have room.
TEST_P(ResultArea, AnswersBeforeDataLoseNoData) {
  constexpr std::uint64_t count = 40;
  DmaBench bench(GetParam(), 1);
  bench.memory.answer_before_data();
  tb::AxiThrottles throttles;
  throttles.w = tb::Throttle::shut_after(1, 1000);
  bench.memory.set_throttles(throttles);
  bench.start_results(kFirst, static_cast<std::uint32_t>(count * kBeat));
  bench.result_throttle = tb::Throttle::sparse(20);
  bench.offer_results(count, 1);  // a burst each
  bench.run(20 * count);
  bench.memory.set_throttles({});
  bench.run(20 * count);
  EXPECT_EQ(bench.results_in_memory(kFirst, 0, count), count);
  EXPECT_EQ(bench.status.result_count, count);
  EXPECT_TRUE(bench.memory.quiet());
}

// An area that its last burst would have filled is not full once that burst has failed.
TEST_P(ResultArea, ResultsBehindAFailedLastBurstWait) {
  const std::uint64_t burst = GetParam().max_burst;
  for (std::uint64_t bursts = 1; bursts <= 3; ++bursts) {
    DmaBench bench(GetParam(), bursts);
    const std::uint64_t capacity = bursts * burst;
    bench.memory.fail_write(bursts - 1, cores::kAxiSlverr);
    bench.start_results(kFirst, static_cast<std::uint32_t>(capacity * kBeat));
    bench.offer_results(capacity, burst);
    ASSERT_TRUE(bench.run_until_error(5000));
    ASSERT_TRUE(bench.run_until([&] { return !bench.status.result_running; }, 100));
    bench.offer_results(6, 3);
    bench.run(50);
    EXPECT_EQ(bench.results_waiting(), 0u);
    EXPECT_FALSE(bench.status.result_overflow);
    EXPECT_EQ(bench.status.result_count, capacity - burst);
    bench.start_results(kNext, 6 * kBeat);
    EXPECT_TRUE(bench.writes(kNext, capacity, 6));
    EXPECT_EQ(bench.write_errors().size(), 1u);
  }
}

/// Clocks until the address of what was just offered goes out.
std::uint64_t clocks_to_address(DmaBench& bench) {
  const std::uint64_t writes = bench.memory.writes().size(), start = bench.cycle();
  EXPECT_TRUE(bench.run_until([&] { return bench.memory.writes().size() > writes; }, 1000));
  return bench.cycle() - start;
}

// However many beats a `last` has sent on, a beat without one then waits for others.
TEST_P(ResultArea, AFlushEndsWithItsLastBeat) {
  const std::uint64_t patience = 21 + GetParam().guard();  // FLUSH_CLOCKS, and the way to the bus
  const std::uint64_t burst = GetParam().max_burst;
  for (std::uint64_t flushed = 1; flushed <= std::min<std::uint64_t>(2 * burst + 1, 40);
       ++flushed) {
    if ((flushed + 1) % burst == 0) continue;  // the beat behind would fill a burst
    SCOPED_TRACE(testing::Message() << flushed << " beats flushed");
    DmaBench bench(GetParam(), flushed);
    bench.start_results(kFirst, 1 << 16);
    bench.run(10);
    bench.offer_results(flushed, flushed);
    ASSERT_TRUE(bench.run_until_counted(flushed, 5000));
    bench.offer_results(1);
    EXPECT_EQ(clocks_to_address(bench), patience);
    EXPECT_TRUE(bench.writes(kFirst, 0, flushed + 1));
  }
}

// What patience sent on leaves none behind: the next beat waits as long.
TEST_P(ResultArea, PatienceBeginsAnewBehindAFlush) {
  const std::uint64_t patience = 21 + GetParam().guard();
  DmaBench bench(GetParam(), 7);
  bench.start_results(kFirst, 1 << 16);
  bench.run(10);
  for (std::uint64_t sent = 0; sent < 40; ++sent) {
    bench.run(sent);
    bench.offer_results(1);
    const std::uint64_t clocks = clocks_to_address(bench);
    const bool fills_burst = (sent + 1) % GetParam().max_burst == 0;
    EXPECT_TRUE(clocks == patience || fills_burst) << clocks << " clocks, " << sent << " behind";
    ASSERT_TRUE(bench.writes(kFirst, 0, sent + 1));
  }
}

// A `last` that comes while a burst is on its way, which could take its flush along.
TEST_P(ResultArea, ALastNeverWaitsForMore) {
  // Less than FLUSH_CLOCKS and that way. A guard waits for the data of the burst before, too.
  const bool waits = GetParam().hardened && GetParam().width < 128;
  const std::uint64_t prompt = 12 + GetParam().guard() + (waits ? 2 : 0);
  for (std::uint64_t first = 1; first <= 5; ++first) {
    for (std::uint64_t gap = 0; gap <= 16; ++gap) {
      SCOPED_TRACE(testing::Message() << first << " beats, then " << gap << " clocks");
      DmaBench bench(GetParam(), first);
      bench.start_results(kFirst, 1 << 16);
      bench.run(10);
      bench.offer_results(first, first);
      bench.run(gap);
      bench.offer_results(1, 1);
      ASSERT_TRUE(bench.run_until([&] { return bench.results_waiting() == 0; }, 100));
      const std::uint64_t taken = bench.cycle();
      const auto& writes = bench.memory.writes();
      const auto all_out = [&] {
        return !writes.empty() &&
               writes.back().address + writes.back().beats * kBeat >= kFirst + (first + 1) * kBeat;
      };
      ASSERT_TRUE(bench.run_until(all_out, 100));
      EXPECT_LE(bench.cycle() - taken, prompt);
      EXPECT_TRUE(bench.writes(kFirst, 0, first + 1));
    }
  }
}

// Nor one behind which several bursts wait for the bus.
TEST_P(ResultArea, ALastBehindSeveralBurstsNeverWaitsForMore) {
  constexpr std::uint64_t kOpen = 60;
  const std::uint64_t burst = GetParam().max_burst;
  const std::uint64_t prompt = GetParam().hardened ? 40 : 10;  // a guard waits for the data, too
  for (std::uint64_t results = 2; results <= 3 * std::min<std::uint64_t>(burst, 6); ++results) {
    for (std::uint64_t shut = 1; shut <= results + 6; ++shut) {
      SCOPED_TRACE(testing::Message() << results << " beats, " << shut << " clocks");
      DmaBench bench(GetParam(), results);
      bench.start_results(kFirst, 1 << 16);
      const std::uint64_t opens = bench.cycle() + kOpen + shut;
      tb::AxiThrottles throttles;
      throttles.aw = tb::Throttle::shut_after(kOpen, shut);
      bench.memory.set_throttles(throttles);
      bench.run(kOpen);
      bench.offer_results(results, results);
      ASSERT_TRUE(bench.run_until([&] { return bench.results_waiting() == 0; }, 100));
      const std::uint64_t taken = std::max(bench.cycle(), opens);
      const auto& writes = bench.memory.writes();
      const auto all_out = [&] {
        return !writes.empty() &&
               writes.back().address + writes.back().beats * kBeat >= kFirst + results * kBeat;
      };
      ASSERT_TRUE(bench.run_until(all_out, 100));
      EXPECT_LE(bench.cycle(), taken + prompt);
      EXPECT_TRUE(bench.writes(kFirst, 0, results));
    }
  }
}

// Results behind a full area are dropped up to the clock before the next start, whose are of its
// area.
TEST_P(ResultArea, AResultOfTheClockBeforeAStartIsItsFirst) {
  constexpr std::uint64_t kUsed = 4;
  for (std::uint64_t clocks = 0; clocks < 8; ++clocks) {
    SCOPED_TRACE(testing::Message() << clocks << " clocks between");
    DmaBench bench(GetParam(), clocks);
    bench.start_results(kFirst, kUsed * kBeat);
    bench.run(10);
    bench.offer_results(kUsed + 1, kUsed);
    const auto full = [&] { return bench.status.result_overflow && !bench.status.result_busy; };
    ASSERT_TRUE(bench.run_until(full, 1000));
    bench.run(20);
    bench.offer_results(1);
    bench.step();
    ASSERT_EQ(bench.results_waiting(), 0U);
    bench.run(clocks);
    bench.start_results(kNext, 2 * kBeat);
    bench.run(10);
    bench.offer_results(4, 4);
    bench.run(200);
    EXPECT_EQ(bench.results_in_memory(kNext, kUsed + (clocks == 0 ? 1 : 2), 2), 2U);
  }
}

// A start in the clock behind another one is none.
TEST_P(ResultArea, AnotherStartAtOnceChangesNothing) {
  DmaBench bench(GetParam(), 8);
  bench.start_results(kFirst, 64 * kBeat);
  bench.start_results(kNext, 32 * kBeat);
  bench.offer_results(3, 3);
  EXPECT_TRUE(bench.writes(kFirst, 0, 3));

  DmaBench bad(GetParam(), 8);
  bad.start_results(kFirst + 4, 64 * kBeat);
  bad.start_results(kNext, 32 * kBeat);
  bad.run(20);
  EXPECT_TRUE(only(bad.write_errors(), kMisaligned, kFirst + 4));
}

// Nor is one while a burst is not answered.
TEST_P(ResultArea, NoneStartsWhileABurstIsOut) {
  DmaBench bench(GetParam(), 10);
  bench.memory.set_latency({60, 60});
  bench.start_results(kFirst, 1 << 16);
  bench.offer_results(1, 1);
  ASSERT_TRUE(bench.run_until([&] { return !bench.memory.writes().empty(); }, 1000));
  for (int clocks = 0; clocks < 20; ++clocks) {
    ASSERT_TRUE(bench.status.result_busy);
    bench.start_results(kNext, 1 << 16);
  }
  bench.offer_results(2, 2);
  EXPECT_TRUE(bench.writes(kFirst, 0, 3));
}

/// A soft reset that waits for a burst of the reader, while the writer has none open.
void begin_long_soft_reset(DmaBench& bench) {
  bench.memory.set_latency({60, 60});
  bench.place_ring(kRing, 2);
  bench.put_packet(kPackets, bench.size().max_burst);
  bench.start_ring();
  bench.run(20);
  bench.controls.soft_reset = true;
  bench.step();
  bench.step();
}

// The writer could begin.
TEST_P(ResultArea, NoneStartsDuringASoftReset) {
  DmaBench bench(GetParam(), 9);
  begin_long_soft_reset(bench);
  for (int clocks = 0; clocks < 20; ++clocks) {
    bench.start_results(kFirst, 1 << 16);
    ASSERT_TRUE(bench.status.clearing);
    EXPECT_FALSE(bench.status.result_running || bench.status.result_busy) << clocks;
  }
  ASSERT_TRUE(bench.run_until([&] { return !bench.status.clearing; }, 1000));
  bench.offer_results(4, 4);
  bench.run(100);
  EXPECT_FALSE(bench.status.result_running);
  EXPECT_TRUE(bench.memory.writes().empty());
  EXPECT_TRUE(bench.write_errors().empty());
  EXPECT_EQ(bench.faults(), "");
}

// Results that are offered then are not taken: a full area does not overflow of them.
TEST_P(ResultArea, NothingComesDuringASoftReset) {
  DmaBench bench(GetParam(), 11);
  bench.start_results(kFirst, 4 * kBeat);
  bench.offer_results(4, 4);
  ASSERT_TRUE(bench.writes(kFirst, 0, 4));
  begin_long_soft_reset(bench);
  bench.offer_results(8, 8);
  for (int clocks = 0; clocks < 20; ++clocks) {
    bench.step();
    ASSERT_TRUE(bench.status.clearing);
    EXPECT_FALSE(bench.status.result_overflow) << clocks;
    EXPECT_EQ(bench.results_waiting(), 8u);
  }
  bench.forget_results();
  ASSERT_TRUE(bench.end_soft_reset());
  EXPECT_EQ(bench.faults(), "");
}

}  // namespace
}  // namespace hwffd::test
