// Every byte arrives, in both directions at once, and no other byte is touched.
#include <gtest/gtest.h>

#include <algorithm>
#include <tuple>

#include "dma_bench.hpp"

namespace hwffd::test {
namespace {

constexpr std::uint64_t kHigh = 0x9'0000'0ff0;  // 16 bytes below a border of 4 KB
using Ranges = std::vector<tb::AxiMemory::Range>;

tb::AxiMemory::Range range(std::uint64_t address, std::uint64_t beats) {
  return {address, address + beats * kBeat - 1};
}

class Sized : public PerDmaSize {};
HWFFD_FOR_EACH_DMA_SIZE(Sized);

// ---- the throttle matrix

using Row = std::tuple<DmaSize, std::string, std::string>;
class Matrix : public testing::TestWithParam<Row> {};
INSTANTIATE_TEST_SUITE_P(Dma, Matrix,
                         testing::Combine(testing::ValuesIn(dma_sizes()),
                                          testing::ValuesIn(tb::throttle_names()),
                                          testing::ValuesIn(tb::throttle_names())),
                         by_name);

TEST_P(Matrix, PacketsAndResultsTogether) {
  const auto& [size, bus, stream] = GetParam();
  for (std::uint64_t seed = 1; seed <= 3; ++seed) {
    DmaBench bench(size, tb::derive_seed(tb::seed_from_environment(1), seed));
    set_all_throttles(bench, bus, stream);
    bench.memory.set_latency({1, seed * 20});
    bench.place_ring(kRing, 4);
    Ranges touched = {range(kRing, 16)};
    std::uint64_t at = kPackets;
    for (int i = 0; i < 8; ++i) {
      const std::uint64_t beats = bench.random().between(1, i == 3 ? 1000 : 60);
      at = (at + 8192) / 4096 * 4096 - kBeat * bench.random().between(0, 20);
      bench.put_packet(at, beats);
      touched.push_back(range(at, beats));
      at += (beats + 1) * kBeat;
    }
    const std::uint64_t results = bench.random().between(300, 700);
    bench.offer_results(results, bench.random().between(1, 90));
    bench.set_windows({kRing, at}, {kHigh, kHigh + 1000 * kBeat - 1});
    bench.start_results(kHigh, 1000 * kBeat);
    bench.start_ring();
    const auto done = [&] { return bench.results_waiting() == 0 && bench.status.idle; };
    ASSERT_TRUE(bench.run_until(done));
    bench.run(20);

    EXPECT_TRUE(bench.exact(8));
    EXPECT_EQ(bench.accepted_results().size(), results);
    EXPECT_EQ(bench.results_in_memory(kHigh, 0, results), results);
    EXPECT_EQ(bench.status.result_count, results);
    touched.push_back(range(kHigh, results));
    EXPECT_EQ(bench.memory.changed_outside(touched), 0u);
    EXPECT_TRUE(bench.read_errors().empty() && bench.write_errors().empty());
  }
}

// ---- lengths and borders

TEST_P(Sized, EveryLengthAroundABorder) {
  std::vector<std::uint64_t> lengths;
  for (std::uint64_t n = 1; n <= 36; ++n) lengths.push_back(n);
  for (std::uint64_t n : {63, 64, 65, 255, 256, 257, 511, 512, 513, 1000}) lengths.push_back(n);
  DmaBench bench(GetParam(), 7);
  bench.memory.set_latency({1, 12});
  bench.place_ring(kRing, 6);
  bench.start_ring();
  for (std::uint64_t before : {0, 1, 2, 3, 17, 255}) {
    for (std::uint64_t beats : lengths) {
      bench.put_packet(kPackets + 4096 - before * kBeat, beats);
      bench.ring_doorbell();
      ASSERT_TRUE(bench.run_until_idle());
    }
  }
  EXPECT_TRUE(bench.exact());
}

TEST_P(Sized, ThePacketEndsWithTheAddressSpace) {
  DmaBench bench(GetParam(), 8);
  bench.place_ring(0, 3);
  bench.put_packet(0 - 300 * kBeat, 300);
  for (std::uint64_t beats : {5, 1}) {
    bench.put_descriptor({0 - beats * kBeat, static_cast<std::uint32_t>(beats * kBeat), 0});
    bench.expect_packet(0 - beats * kBeat, beats);
  }
  EXPECT_TRUE(bench.reads(3));
}

TEST_P(Sized, TheAreaMayEndWithTheAddressSpace) {
  DmaBench bench(GetParam(), 9);
  const std::uint64_t base = 0 - 40 * kBeat;
  bench.start_results(base, 40 * kBeat);
  bench.offer_results(40);
  EXPECT_TRUE(bench.writes(base, 0, 40));
  EXPECT_FALSE(bench.status.result_overflow);
}

// ---- the ring

TEST_P(Sized, TheRingGoesAround) {
  for (unsigned entries_log2 : {1u, 2u, 3u, 5u}) {
    DmaBench bench(GetParam(), entries_log2);
    bench.memory.set_latency({1, 9});
    bench.place_ring(kRing - kRing % (kBeat << entries_log2), entries_log2);
    bench.start_ring();
    const unsigned mask = (1u << entries_log2) - 1;
    for (int i = 0; i < 100; ++i) {
      const auto room = [&] {
        return ((bench.software_head() + 1u) & mask) != bench.status.ring_tail;
      };
      ASSERT_TRUE(bench.run_until(room));
      bench.put_packet(kPackets + 4096u * i, 1 + i % 7);
      bench.ring_doorbell();
      bench.step();
    }
    ASSERT_TRUE(bench.run_until_idle());
    EXPECT_TRUE(bench.exact(100 & mask));
  }
}

TEST(Ring, TheLargestRing) {
  DmaBench bench(small_dma_size(), 3);
  bench.place_ring(0x80000, 15);
  bench.put_packet(kPackets, 3);
  for (unsigned i = 1; i < 32767; ++i) {
    bench.put_descriptor({kPackets, 3 * kBeat, 0});
    bench.expect_packet(kPackets, 3);
  }
  bench.start_ring();
  ASSERT_TRUE(bench.run_until_idle(2000000));
  EXPECT_EQ(bench.status.ring_tail, 32767);
  bench.put_packet(kPackets + 0x100, 2);  // in the last entry
  bench.put_packet(kPackets + 0x200, 2);  // in the first
  bench.ring_doorbell();
  ASSERT_TRUE(bench.run_until_idle());
  EXPECT_TRUE(bench.exact(1));
  bench.put_descriptor({kPackets, kBeat, 1});  // in the second
  bench.ring_doorbell();
  ASSERT_TRUE(bench.run_until_stopped());
  EXPECT_TRUE(only(bench.read_errors(), kFlags, bench.descriptor_address(1)));
  EXPECT_TRUE(bench.exact(1));
}

// The number of a bad descriptor is counted from the start on.
TEST(Ring, ABadDescriptorBehindTheStart) {
  std::vector<unsigned> indices = {0x2AAA, 0x5555};
  for (unsigned index = 1; index < 140; ++index) indices.push_back(index);
  for (unsigned k = 8; k < 15; ++k) indices.insert(indices.end(), {(1u << k) - 1, (1u << k) + 4});
  for (const unsigned index : indices) {
    SCOPED_TRACE(testing::Message() << index);
    DmaBench bench(small_dma_size(), index);
    bench.place_ring(0x80000, 15);
    for (unsigned i = 0; i < index; ++i) {
      bench.put_descriptor({kPackets, kBeat, 0});
      bench.expect_packet(kPackets, 1);
    }
    bench.put_descriptor({kPackets, 0, 0});
    bench.start_ring();
    ASSERT_TRUE(bench.run_until_stopped(1000000));
    EXPECT_TRUE(only(bench.read_errors(), kZeroLength, bench.descriptor_address(index)));
    EXPECT_TRUE(bench.exact(index));
  }
}

TEST_P(Sized, AStartWhileRunningChangesNothing) {
  DmaBench bench(GetParam(), 4);
  bench.memory.set_latency({5, 5});
  bench.place_ring(kRing, 4);
  bench.put_packets(10, 20);
  bench.start_ring();
  while (!bench.status.idle || bench.packets().empty()) {
    bench.controls.ring_start = true;
    bench.step();
    ASSERT_LT(bench.cycle(), 5000u);
  }
  EXPECT_EQ(bench.packet_difference(), "");
}

TEST_P(Sized, AStartWithNothingLeftTakesTheRingAsItIsNow) {
  DmaBench bench(GetParam(), 14);
  bench.put_packets(3, 5);
  ASSERT_TRUE(bench.run_ring());
  EXPECT_TRUE(bench.status.ring_running);
  bench.place_ring(kRing + 0x400, 5);
  bench.set_software_head(bench.status.ring_tail);
  bench.controls.ring_start = true;
  bench.step();  // the head moves a clock later, as behind registers
  bench.put_packets(6, 5);
  bench.ring_doorbell();
  ASSERT_TRUE(bench.run_until_idle());
  EXPECT_TRUE(bench.exact(9));
  // One that is not aligned is refused as at the first start.
  bench.controls.ring_base = kRing + 16;
  bench.controls.ring_start = true;
  bench.run(3);
  EXPECT_TRUE(only(bench.read_errors(), kMisaligned, kRing + 16));
  EXPECT_FALSE(bench.status.ring_running);
  EXPECT_EQ(bench.faults(), "");
}

// ---- bursts

TEST_P(Sized, FullBurstsOfALongPacket) {
  DmaBench bench(GetParam(), 13);
  const std::uint64_t burst = bench.size().max_burst;
  bench.place_ring(kRing, 1);
  bench.put_packet(kPackets + kBeat, 8 * burst);
  ASSERT_TRUE(bench.reads(1));
  const auto& reads = bench.memory.reads();
  ASSERT_EQ(reads.size(), 10u);  // the descriptor, and nine, since it starts beside a border
  EXPECT_EQ(reads[1].beats, burst - 1);
  for (std::size_t i = 2; i < 9; ++i) EXPECT_EQ(reads[i].beats, burst);
  EXPECT_EQ(reads[9].beats, bench.blocks());
}

// What has waited for the sink leaves in consecutive clocks.
TEST_P(Sized, NoGapBehindAStall) {
  DmaBench bench(GetParam(), 15);
  const std::uint64_t beats = std::min<std::uint64_t>(bench.size().depth - 2, 12);
  bench.packet_throttle = tb::Throttle::shut_after(1, 1000);  // willing in the first clock only
  bench.put_packet(kPackets, 1);
  bench.start_ring();
  bench.run(100);
  bench.put_packet(kPackets + 0x1000, beats - 1);
  bench.ring_doorbell();
  bench.run(200);
  ASSERT_TRUE(bench.packets().empty());
  bench.packet_throttle = tb::Throttle::always();
  bench.run(beats);
  EXPECT_EQ(bench.packets().size(), beats);
  EXPECT_TRUE(bench.exact());
}

TEST_P(Sized, FullBurstsWhileResultsKeepComing) {
  DmaBench bench(GetParam(), 5);
  const std::uint64_t burst = bench.size().max_burst;
  bench.start_results(0x10000, 1 << 20);
  bench.offer_results(8 * burst);
  ASSERT_TRUE(bench.writes(0x10000, 0, 8 * burst));
  ASSERT_EQ(bench.memory.writes().size(), 8u);
  for (const auto& write : bench.memory.writes()) EXPECT_EQ(write.beats, burst);
}

TEST_P(Sized, AShortBurstTakesAllThatWaits) {
  for (std::uint64_t results = 1; results <= GetParam().max_burst; ++results) {
    DmaBench bench(GetParam(), results);
    bench.start_results(0x10000, 1 << 20);
    bench.offer_results(results, results);
    ASSERT_TRUE(bench.writes(0x10000, 0, results));
    ASSERT_EQ(bench.memory.writes().size(), 1u) << results;
    EXPECT_EQ(bench.memory.writes()[0].beats, results);
  }
}

// What lies behind a border of bursts goes out at once, with a guard behind the data before it.
TEST_P(Sized, NoBorderDelaysTheEndOfAPacket) {
  constexpr std::uint64_t soon = 5;
  const std::uint64_t burst = GetParam().max_burst;
  const std::uint64_t beats = GetParam().width == 64 ? 2 : 1;  // of 16 bytes, at most
  const bool guarded = GetParam().guard() != 0;
  for (std::uint64_t before = 1; before < burst; ++before) {
    DmaBench bench(GetParam(), before);
    const std::uint64_t base = 0x10000 + (burst - before) * kBeat;
    bench.start_results(base, 1 << 16);
    bench.offer_results(before + 1, before + 1);
    ASSERT_TRUE(bench.writes(base, 0, before + 1));
    const auto& writes = bench.memory.writes();
    ASSERT_EQ(writes.size(), 2u);
    EXPECT_LE(writes[1].cycle - writes[0].cycle,
              guarded ? std::max(soon, before * beats + 1) : soon);
  }
}

/// A slave that takes no address sees all data of the bursts that may be open; nothing is lost.
TEST_P(Sized, WriteDataMayComeBeforeItsAddress) {
  DmaBench bench(GetParam(), 14);
  tb::AxiThrottles throttles;
  throttles.aw = tb::Throttle::shut_after(1, 400);  // willing in the first clock only
  bench.memory.set_throttles(throttles);
  bench.start_results(0x20000, 1 << 16);
  bench.offer_results(8, 4);
  bench.run(100);
  EXPECT_TRUE(bench.memory.writes().empty());
  EXPECT_EQ(bench.memory.write_beats() * bench.size().width / 128, 4u)
      << "all of the burst whose address waits";
  bench.memory.set_throttles({});
  EXPECT_TRUE(bench.writes(0x20000, 0, 8));
}

/// A slave that is ready for nothing before it sees it: nobody waits for the other.
TEST_P(Sized, ReadyMayWaitForValid) {
  DmaBench bench(GetParam(), 16);
  bench.memory.let_ready_wait_for_valid();
  bench.start_results(0x20000, 1 << 16);
  bench.offer_results(40, 7);
  bench.put_packets(5, 9);
  bench.start_ring();
  ASSERT_TRUE(bench.run_until([&] { return bench.results_waiting() == 0 && bench.status.idle; }));
  EXPECT_TRUE(bench.exact(5));
  EXPECT_TRUE(bench.writes(0x20000, 0, 40));
}

TEST_P(Sized, NoResultStaysBehind) {
  DmaBench bench(GetParam(), 6);
  bench.start_results(0x10000, 1 << 16);
  bench.run(10);
  const auto wait = [&](std::uint64_t packet) {
    const std::uint64_t writes = bench.memory.writes().size();
    bench.offer_results(1, packet);
    const std::uint64_t start = bench.cycle();
    bench.run_until([&] { return bench.memory.writes().size() > writes; }, 100);
    return bench.cycle() - start;
  };
  const std::uint64_t way = 5 + bench.size().guard();
  for (unsigned i = 0; i < 8; i += 2) {
    EXPECT_EQ(wait(1), way);  // `last`: accepted, counted, measured, address raised, taken
    // None: FLUSH_CLOCKS on top, unless it fills the burst.
    EXPECT_EQ(wait(0), (i + 2) % bench.size().max_burst == 0 ? way : way + 16);
  }
  bench.run(20);
  EXPECT_EQ(bench.status.result_count, 8u);
  EXPECT_EQ(bench.faults(), "");
}

TEST_P(Sized, WhatIsBeyondTheAreaIsDroppedAndFlagged) {
  for (const std::uint64_t surplus : {0, 1, 2, 700}) {
    for (const std::uint64_t capacity : {1, 3, 40, 256, 300}) {
      DmaBench bench(GetParam(), surplus + capacity);
      set_all_throttles(bench, "bernoulli", "bursts");
      bench.start_results(kHigh, static_cast<std::uint32_t>(capacity * kBeat));
      bench.offer_results(capacity + surplus, 9);
      const auto done = [&] { return bench.results_waiting() == 0 && bench.status.idle; };
      ASSERT_TRUE(bench.run_until(done));
      bench.run(30);
      EXPECT_EQ(bench.status.result_overflow, surplus != 0);
      EXPECT_EQ(bench.status.result_count, capacity);
      EXPECT_EQ(bench.results_in_memory(kHigh, 0, capacity), capacity);
      EXPECT_EQ(bench.memory.changed_outside({range(kHigh, capacity)}), 0u);
      // The next area starts with the next result.
      const std::uint64_t second = kHigh + (capacity + 3) * kBeat;
      const std::uint64_t first = bench.accepted_results().size();
      bench.start_results(second, 10 * kBeat);
      bench.run(2);
      EXPECT_FALSE(bench.status.result_overflow);
      bench.offer_results(5);
      ASSERT_TRUE(bench.writes(second, first, 5));
      EXPECT_EQ(bench.memory.changed_outside({range(kHigh, capacity), range(second, 5)}), 0u);
    }
  }
}

TEST_P(Sized, ResultsWaitForAnArea) {
  DmaBench bench(GetParam(), 12);
  bench.run(10);
  bench.offer_results(2000, 10);
  bench.run(bench.size().depth);
  EXPECT_EQ(bench.accepted_results().size(), bench.size().depth) << "one in each clock";
  bench.run(1000);
  EXPECT_EQ(bench.accepted_results().size(), bench.size().depth + 1)
      << "one waits behind the memory";
  EXPECT_TRUE(bench.memory.writes().empty());
  bench.start_results(0x20000, 2000 * kBeat);
  EXPECT_TRUE(bench.writes(0x20000, 0, 2000));
  EXPECT_EQ(bench.memory.writes().front().beats, bench.size().max_burst);
}

}  // namespace
}  // namespace hwffd::test
