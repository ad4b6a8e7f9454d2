// At least 95 % of the bus, or of the streams where those are narrower, with 30 clocks from an
// address to its first answer.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "dma_bench.hpp"

namespace hwffd::test {
namespace {

struct Rate {
  double read, write;
  std::uint64_t reads, writes;  // most outstanding
};

/// Packet beats and result beats a clock over `clocks` in the middle of a long transfer; a bus of
/// 64 bits needs two clocks for each.
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
  const double width = static_cast<double>(size.width) / 128;
  const double span = static_cast<double>(clocks) * std::min(1.0, width);
  const Rate rate{static_cast<double>(bench.packets().size() - packets) / span,
                  width * static_cast<double>(bench.memory.write_beats() - results) / span,
                  bench.checker.most_reads(), bench.checker.most_writes()};
  EXPECT_TRUE(bench.checker.reports().empty());
  fmt::print("{}, packets of {} beats: R {:.2f} %, W {:.2f} %, at most {} and {} bursts\n",
             size.name, packet_beats, 100 * rate.read, 100 * rate.write, rate.reads, rate.writes);
  return rate;
}

struct Case {
  const char* name;
  DmaSize size;
  std::uint64_t packet_beats;
};
void PrintTo(const Case& tried, std::ostream* out) { *out << tried.name; }
class FullBandwidth : public testing::TestWithParam<Case> {};
INSTANTIATE_TEST_SUITE_P(, FullBandwidth,
                         testing::Values(Case{"LongPackets", dma_sizes()[0], 1000},
                                         Case{"PacketsOfOneVertexEach", dma_sizes()[0], 50},
                                         Case{"TwoLongBursts", {"pair", 256, 512, 2}, 1000},
                                         Case{"FourBurstsOf16", dma_sizes()[1], 1000},
                                         Case{"Narrow", dma_sizes()[3], 1000},
                                         Case{"NarrowPacketsOfOneVertexEach", dma_sizes()[3], 50},
                                         Case{"Wide", dma_sizes()[4], 1000}),
                         by_name);

TEST_P(FullBandwidth, OfBothDirections) {
  const Rate rate = measure(GetParam().size, GetParam().packet_beats);
  EXPECT_GE(rate.read, 0.95);
  EXPECT_GE(rate.write, 0.95);
  EXPECT_GT(rate.reads, 1u);
  EXPECT_GT(rate.writes, 1u);
}

/// Two requests of five clocks, and what eight bursts outstanding cannot hide of the latency.
TEST(Bandwidth, ShortPacketsTakeLittleMoreThanTwelveClocks) {
  for (const std::uint64_t beats : {1, 4, 9}) {
    EXPECT_LE(static_cast<double>(beats) / measure(dma_sizes()[0], beats).read, 12.25);
  }
}

TEST(Bandwidth, TwoBurstsOfFourCannot) { EXPECT_LT(measure(small_dma_size(), 1000).read, 0.30); }

/// Clocks from `start` to the one in which that holds.
template <class Condition>
std::uint64_t clocks_until(DmaBench& bench, std::uint64_t start, Condition condition) {
  EXPECT_TRUE(bench.run_until(condition, 100));
  return bench.cycle() - start;
}

/// Clocks from a start to the first packet beat that is taken, where the memory answers after one.
TEST(Bandwidth, LatencyOfAnIdleBus) {
  for (const std::uint64_t beats : {1, 2, 16}) {
    DmaBench bench(dma_sizes()[0], 2);
    bench.place_ring(0x10000, 2);
    bench.put_packet(0x20000, beats);
    const std::uint64_t start = bench.cycle() + 1;
    bench.start_ring();
    const auto& reads = bench.memory.reads();
    EXPECT_EQ(clocks_until(bench, start, [&] { return reads.size() == 1; }), 13u) << "descriptor";
    EXPECT_EQ(clocks_until(bench, start, [&] { return reads.size() == 2; }), 24u) << "address";
    EXPECT_EQ(clocks_until(bench, start, [&] { return !bench.packets().empty(); }), 30u);
  }
}

/// Clocks from a marked result that is taken to its address, its data and its count.
TEST(Bandwidth, LatencyOfAResult) {
  DmaBench bench(dma_sizes()[0], 3);
  bench.start_results(0x20000, 1 << 12);
  bench.run(20);
  bench.offer_results(1, 1);
  const std::uint64_t taken =
      clocks_until(bench, 0, [&] { return bench.accepted_results().size() == 1; });
  const auto& memory = bench.memory;
  EXPECT_EQ(clocks_until(bench, taken, [&] { return memory.writes().size() == 1; }), 4u);
  EXPECT_EQ(clocks_until(bench, taken, [&] { return memory.write_beats() == 1; }), 6u);
  EXPECT_EQ(clocks_until(bench, taken, [&] { return bench.status.result_count == 1; }), 9u);
}

}  // namespace
}  // namespace hwffd::test
