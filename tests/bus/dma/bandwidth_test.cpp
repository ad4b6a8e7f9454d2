// At least 95 % of the bus, with 30 clocks from an address to its first answer.
#include <gtest/gtest.h>

#include <cstdio>

#include "dma_bench.hpp"

namespace hwffd::test {
namespace {

struct Rate {
  double read, write;
  std::uint64_t reads, writes;  // most outstanding
};

/// Packet beats and result beats a clock over `clocks` in the middle of a long transfer.
Rate measure(const DmaSize& size, std::uint64_t packet_beats, std::uint64_t clocks = 20000) {
  DmaBench bench(size, 1);
  bench.memory.set_latency({30, 30});
  bench.place_ring(0x10000, 12);
  bench.put_packet(0x1000000 + 3 * kBeat, packet_beats);
  for (std::uint64_t i = 1; i < 4095; ++i) {
    bench.put_descriptor(
        {0x1000000 + 3 * kBeat, static_cast<std::uint32_t>(packet_beats * kBeat), 0});
  }
  bench.offer_results(clocks + 4000);
  bench.start_results(0x4000000, 1u << 30);
  bench.start_ring();
  bench.run(1000);
  const std::uint64_t packets = bench.packets().size();
  const std::uint64_t results = bench.memory.write_beats();
  bench.run(clocks);
  const double span = static_cast<double>(clocks);
  const Rate rate{static_cast<double>(bench.packets().size() - packets) / span,
                  static_cast<double>(bench.memory.write_beats() - results) / span,
                  bench.checker.most_reads(), bench.checker.most_writes()};
  EXPECT_TRUE(bench.checker.reports().empty());
  std::printf("%s, packets of %llu beats: R %.2f %%, W %.2f %%, at most %llu and %llu bursts\n",
              size.name.c_str(), static_cast<unsigned long long>(packet_beats), 100 * rate.read,
              100 * rate.write, static_cast<unsigned long long>(rate.reads),
              static_cast<unsigned long long>(rate.writes));
  return rate;
}

TEST(Bandwidth, LongPackets) {
  const Rate rate = measure(dma_sizes()[0], 1000);
  EXPECT_GE(rate.read, 0.95);
  EXPECT_GE(rate.write, 0.95);
  EXPECT_GT(rate.reads, 1u);
  EXPECT_GT(rate.writes, 1u);
}

TEST(Bandwidth, PacketsOfOneVertexEach) {
  const Rate rate = measure(dma_sizes()[0], 50);
  EXPECT_GE(rate.read, 0.95);
  EXPECT_GE(rate.write, 0.95);
}

/// Two requests of five clocks, and what eight bursts outstanding cannot hide of the latency.
TEST(Bandwidth, ShortPacketsTakeTwelveClocksAtMost) {
  for (const std::uint64_t beats : {1, 4, 9}) {
    EXPECT_LE(static_cast<double>(beats) / measure(dma_sizes()[0], beats).read, 12.0);
  }
}

TEST(Bandwidth, TwoLongBurstsAreEnoughForLongPackets) {
  const Rate rate = measure({"pair", 256, 512, 2}, 1000);
  EXPECT_GE(rate.read, 0.95);
  EXPECT_GE(rate.write, 0.95);
}

TEST(Bandwidth, BurstsOf16AndFourOutstanding) {
  const Rate rate = measure(dma_sizes()[1], 1000);
  EXPECT_GE(rate.read, 0.95);
  EXPECT_GE(rate.write, 0.95);
}

TEST(Bandwidth, TwoBurstsOfFourCannot) {
  const Rate rate = measure(dma_sizes()[2], 1000);
  EXPECT_LT(rate.read, 0.30);
}

/// Clocks from a start to the first packet beat that is taken, where the memory answers after one.
TEST(Bandwidth, LatencyOfAnIdleBus) {
  for (const std::uint64_t beats : {1, 2, 16}) {
    DmaBench bench(dma_sizes()[0], 2);
    bench.place_ring(0x10000, 2);
    bench.put_packet(0x20000, beats);
    const std::uint64_t start = bench.cycle();
    bench.start_ring();
    ASSERT_TRUE(bench.run_until([&] { return bench.memory.reads().size() == 1; }, 100));
    const std::uint64_t descriptor = bench.cycle() - 1 - start;
    ASSERT_TRUE(bench.run_until([&] { return bench.memory.reads().size() == 2; }, 100));
    const std::uint64_t data = bench.cycle() - 1 - start;
    ASSERT_TRUE(bench.run_until([&] { return !bench.packets().empty(); }, 100));
    const std::uint64_t first = bench.cycle() - 1 - start;
    std::printf("start to descriptor's address %llu, to data's %llu, to first beat of %llu: %llu\n",
                static_cast<unsigned long long>(descriptor), static_cast<unsigned long long>(data),
                static_cast<unsigned long long>(beats), static_cast<unsigned long long>(first));
    EXPECT_EQ(descriptor, 6u);
    EXPECT_EQ(data, 14u);
    EXPECT_EQ(first, 18u);
  }
}

/// Clocks from a marked result that is taken to its address, its data and its count.
TEST(Bandwidth, LatencyOfAResult) {
  DmaBench bench(dma_sizes()[0], 3);
  bench.start_results(0x20000, 1 << 12);
  bench.run(20);
  bench.offer_results(1, 1);
  ASSERT_TRUE(bench.run_until([&] { return bench.accepted_results().size() == 1; }, 100));
  const std::uint64_t taken = bench.cycle();
  ASSERT_TRUE(bench.run_until([&] { return bench.memory.writes().size() == 1; }, 100));
  const std::uint64_t address = bench.cycle() - taken;
  ASSERT_TRUE(bench.run_until([&] { return bench.memory.write_beats() == 1; }, 100));
  const std::uint64_t data = bench.cycle() - taken;
  ASSERT_TRUE(bench.run_until([&] { return bench.status.result_count == 1; }, 100));
  const std::uint64_t count = bench.cycle() - taken;
  std::printf("result taken to its address %llu, to its data %llu, to its count %llu\n",
              static_cast<unsigned long long>(address), static_cast<unsigned long long>(data),
              static_cast<unsigned long long>(count));
  EXPECT_EQ(address, 2u);
  EXPECT_EQ(data, 4u);
  EXPECT_EQ(count, 6u);
}

}  // namespace
}  // namespace hwffd::test
