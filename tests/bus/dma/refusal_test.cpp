// What must not be asked for is refused before its first address, and windows are exact to the
// byte.
#include <gtest/gtest.h>

#include "dma_bench.hpp"

namespace hwffd::test {
namespace {

class Refusal : public PerDmaSize {};
HWFFD_FOR_EACH_DMA_SIZE(Refusal);

struct Case {
  Descriptor descriptor;
  unsigned code;
};

/// A good packet, the bad one, a good one: the engine stops at the bad one, and goes on once it has
/// been mended.
void expect_refused(const DmaSize& size, const Case& bad, tb::AxiMemory::Range window) {
  SCOPED_TRACE(testing::Message() << std::hex << bad.descriptor.address << " length "
                                  << bad.descriptor.length << " flags " << bad.descriptor.flags);
  DmaBench bench(size, bad.code);
  bench.memory.set_latency({1, 7});
  bench.set_windows(window, {1, 0});
  bench.place_ring(kRing, 3);
  bench.put_packet(kPackets, 21);
  bench.put_descriptor(bad.descriptor);
  bench.put_descriptor({kPackets, 64, 0});
  bench.start_ring();
  ASSERT_TRUE(bench.run_until([&] { return !bench.status.ring_running; }, 2000));
  EXPECT_TRUE(bench.run_until_idle(500));
  EXPECT_TRUE(only(bench.read_errors(), bad.code, bench.descriptor_address(1)));
  EXPECT_EQ(bench.status.ring_tail, 1);
  bench.run(50);
  EXPECT_EQ(bench.packet_difference(), "");
  std::uint64_t beats = 0;
  for (const auto& read : bench.memory.reads()) {
    const bool ring = read.address >= kRing && read.address < kRing + 8 * kBeat;
    const bool packet = read.address >= kPackets && read.address < kPackets + 21 * kBeat;
    EXPECT_TRUE(ring || packet) << std::hex << read.address;
    beats += packet ? read.beats : 0;
  }
  EXPECT_EQ(beats, 21u);

  // A second start finds the same fault, a mended descriptor goes through.
  bench.start_ring();
  ASSERT_TRUE(bench.run_until([&] { return bench.read_errors().size() == 2; }, 2000));
  EXPECT_EQ(bench.read_errors()[1].code, bad.code);
  ASSERT_TRUE(bench.run_until_idle());
  bench.set_software_head(1);
  bench.put_packet(kPackets + 0x40, 9);
  bench.put_packet(kPackets + 0x1000, 3);
  ASSERT_TRUE(bench.run_ring());
  EXPECT_EQ(bench.packet_difference(), "");
  EXPECT_EQ(bench.status.ring_tail, 3);
  EXPECT_EQ(bench.read_errors().size(), 2u);
  EXPECT_EQ(bench.faults(), "");
}

TEST_P(Refusal, EveryKindOfBadDescriptor) {
  const tb::AxiMemory::Range all{0, ~std::uint64_t{0}};
  const Case cases[] = {
      {{kPackets, 0, 0}, kZeroLength},
      {{0, 0, 0}, kZeroLength},
      {{kPackets + 1, 64, 0}, kMisaligned},
      {{kPackets + 8, 64, 0}, kMisaligned},
      {{kPackets + 15, 0, 0}, kMisaligned},
      {{kPackets, 1, 0}, kMisaligned},
      {{kPackets, 8, 0}, kMisaligned},
      {{kPackets, 63, 0}, kMisaligned},
      {{kPackets, 0xffffffff, 0}, kMisaligned},
      {{0 - kBeat, 32, 0}, kWraps},
      {{0 - 1000 * kBeat, 1001 * kBeat, 0}, kWraps},
      {{0 - kBeat, 0xfffffff0, 0}, kWraps},
      {{0xffffffff00000020, 0xfffffff0, 0}, kWraps},
      {{kPackets, 64, 1}, kFlags},
      {{kPackets, 64, 0x80000000}, kFlags},
      {{kPackets, 0, 0x100}, kFlags},
  };
  for (const Case& bad : cases) expect_refused(GetParam(), bad, all);
}

/// Packets that wait for room when the bad descriptor is seen are read all the same.
TEST_P(Refusal, WhatWaitsBeforeABadDescriptorIsRead) {
  const Case cases[] = {{{kPackets, 0, 0}, kZeroLength},
                        {{kPackets + 8, 64, 0}, kMisaligned},
                        {{0 - kBeat, 32, 0}, kWraps},
                        {{kPackets, 64, 1}, kFlags}};
  for (const Case& bad : cases) {
    DmaBench bench(GetParam(), bad.code);
    bench.packet_throttle = tb::make_throttle("sparse", 1);
    bench.place_ring(kRing, 4);
    for (std::uint64_t packet = 0; packet < 4; ++packet) {
      bench.put_packet(kPackets + packet * 0x4000, bench.size().depth);
    }
    bench.put_descriptor(bad.descriptor);
    bench.put_descriptor({kPackets, 64, 0});
    bench.start_ring();
    ASSERT_TRUE(bench.run_until([&] { return !bench.status.ring_running; }, 20000)) << bad.code;
    ASSERT_TRUE(bench.run_until_idle());
    EXPECT_EQ(bench.status.ring_tail, 4) << bad.code;
    EXPECT_EQ(bench.packet_difference(), "") << bad.code;
    EXPECT_TRUE(only(bench.read_errors(), bad.code, bench.descriptor_address(4)));
    EXPECT_EQ(bench.faults(), "");
  }
}

TEST_P(Refusal, OutsideTheReadWindow) {
  const tb::AxiMemory::Range window{kRing, kPackets + 0x1fff};
  const std::uint64_t end = kPackets + 0x2000;
  const Case cases[] = {
      {{0, 16, 0}, kOutside},
      {{kRing - kBeat, 16, 0}, kOutside},
      {{kRing - kBeat, 64, 0}, kOutside},
      {{end, 16, 0}, kOutside},
      {{end - kBeat, 32, 0}, kOutside},
      {{kRing, 0xfffffff0, 0}, kOutside},
      {{kPackets + 0x1'0000'0000, 16, 0}, kOutside},
      {{kPackets + 0x8000'0000'0000'0000, 16, 0}, kOutside},
      {{0 - kBeat, 16, 0}, kOutside},
  };
  for (const Case& bad : cases) expect_refused(GetParam(), bad, window);
}

/// The code with which a packet of `beats` at `address` ends, or 0.
unsigned read_code(const DmaSize& size, tb::AxiMemory::Range window, std::uint64_t address,
                   std::uint64_t beats) {
  DmaBench bench(size, 5);
  bench.set_windows({0, ~std::uint64_t{0}}, {1, 0});
  bench.place_ring(address, 0);
  bench.put_packet(address, beats);
  // The window counts for the packet alone: a ring of two lies inside where the packet does.
  bench.place_ring(address, 1);
  bench.memory.set_beat(
      address, {static_cast<std::uint32_t>(address), static_cast<std::uint32_t>(address >> 32),
                static_cast<std::uint32_t>(beats * kBeat), 0});
  bench.set_windows(window, {1, 0});
  bench.controls.ring_head = 1;
  bench.controls.ring_start = true;
  bench.run(400);
  EXPECT_EQ(bench.checker.violations(), 0u);
  EXPECT_EQ(bench.packets().size(), bench.read_errors().empty() ? beats : 0);
  return bench.read_errors().empty() ? 0 : bench.read_errors()[0].code;
}

TEST_P(Refusal, TheReadWindowIsExactToTheByte) {
  const std::uint64_t at = 0x40000, beats = 6, last = at + beats * kBeat - 1;
  const auto code = [&](std::uint64_t first_byte, std::uint64_t last_byte) {
    return read_code(GetParam(), {first_byte, last_byte}, at, beats);
  };
  EXPECT_EQ(code(at, last), 0u);
  EXPECT_EQ(code(at - 1, last + 1), 0u);
  for (std::uint64_t short_by = 1; short_by <= 17; ++short_by) {
    EXPECT_EQ(code(at, last - short_by), kOutside) << short_by;
    EXPECT_EQ(code(at + short_by, last), kOutside) << short_by;
  }
  EXPECT_EQ(code(last, at), kOutside);  // an empty window
}

TEST_P(Refusal, TheRingLiesInTheReadWindow) {
  const std::uint64_t ring = 0x40000;
  const auto code = [&](std::uint64_t base, tb::AxiMemory::Range window) -> unsigned {
    DmaBench bench(GetParam(), 6);
    bench.place_ring(ring, 2);
    bench.put_packet(ring, 2);
    bench.controls.ring_base = base;
    bench.set_windows(window, {1, 0});
    bench.start_ring();
    bench.run(100);
    if (bench.read_errors().empty()) return 0;
    EXPECT_TRUE(bench.memory.reads().empty());
    EXPECT_EQ(bench.read_errors()[0].address, base);
    EXPECT_FALSE(bench.status.ring_running);
    return bench.read_errors()[0].code;
  };
  const tb::AxiMemory::Range exact{ring, ring + 63};
  EXPECT_EQ(code(ring, exact), 0u);
  EXPECT_EQ(code(ring, {ring + 1, ring + 63}), kOutside);
  EXPECT_EQ(code(ring, {ring, ring + 62}), kOutside);
  EXPECT_EQ(code(ring + 64, exact), kOutside);
  EXPECT_EQ(code(ring - 64, exact), kOutside);
  EXPECT_EQ(code(ring + 16, exact), kMisaligned);
  EXPECT_EQ(code(ring + 1, exact), kMisaligned);
  EXPECT_EQ(code(ring + 32, {0, ~std::uint64_t{0}}), kMisaligned);
}

// ---- the result area

unsigned area_code(const DmaSize& size, tb::AxiMemory::Range window, std::uint64_t base,
                   std::uint32_t bytes) {
  DmaBench bench(size, 7);
  bench.set_windows({1, 0}, window);
  bench.start_results(base, bytes);
  bench.offer_results(4, 1);
  bench.run(60);
  EXPECT_EQ(bench.faults(), "");
  if (bench.write_errors().empty()) {
    EXPECT_EQ(bench.results_in_memory(base, 0, bytes / kBeat), bytes / kBeat);
    EXPECT_EQ(bench.memory.changed_outside({{base, base + bytes - 1}}), 0u);
    return 0;
  }
  EXPECT_EQ(bench.write_errors().size(), 1u);
  EXPECT_EQ(bench.write_errors()[0].address, base);
  EXPECT_TRUE(bench.memory.writes().empty());
  EXPECT_FALSE(bench.status.result_running);
  const unsigned code = bench.write_errors()[0].code;
  // The results have waited for an area that is allowed.
  bench.set_windows({1, 0}, {0, ~std::uint64_t{0}});
  bench.start_results(0x5000, 64);
  EXPECT_TRUE(bench.run_until([&] { return bench.status.result_count == 4; }, 200));
  EXPECT_EQ(bench.results_in_memory(0x5000, 0, 4), 4u);
  EXPECT_EQ(bench.memory.changed_outside({{0x5000, 0x503f}}), 0u);
  return code;
}

TEST_P(Refusal, EveryKindOfBadArea) {
  const tb::AxiMemory::Range all{0, ~std::uint64_t{0}};
  EXPECT_EQ(area_code(GetParam(), all, 0x1000, 64), 0u);
  EXPECT_EQ(area_code(GetParam(), all, 0 - 64, 64), 0u);
  EXPECT_EQ(area_code(GetParam(), all, 0x1000, 0), kZeroLength);
  EXPECT_EQ(area_code(GetParam(), all, 0x1000, 15), kMisaligned);
  EXPECT_EQ(area_code(GetParam(), all, 0x1004, 64), kMisaligned);
  EXPECT_EQ(area_code(GetParam(), all, 0 - 64, 80), kWraps);
  EXPECT_EQ(area_code(GetParam(), all, 0 - kBeat, 0xfffffff0), kWraps);
}

TEST_P(Refusal, TheWriteWindowIsExactToTheByte) {
  const std::uint64_t base = 0x1'0000'1fc0;
  const auto code = [&](std::uint64_t first, std::uint64_t last) {
    return area_code(GetParam(), {first, last}, base, 64);
  };
  EXPECT_EQ(code(base, base + 63), 0u);
  EXPECT_EQ(code(base + 1, base + 63), kOutside);
  EXPECT_EQ(code(base, base + 62), kOutside);
  EXPECT_EQ(code(base + 16, base + 100), kOutside);
  EXPECT_EQ(code(0, base + 15), kOutside);
  EXPECT_EQ(code(base + 63, base), kOutside);
}

}  // namespace
}  // namespace hwffd::test
