// What must not be asked for is refused before its first address, and windows are exact to the
// byte.
#include <gtest/gtest.h>

#include "asking.hpp"

namespace hwffd::test {
namespace {

class Refusal : public PerDmaSize {};
HWFFD_FOR_EACH_DMA_SIZE(Refusal);

/// A good packet, the bad one, a good one: the engine stops at the bad one, and goes on once it has
/// been mended.
void expect_refused(const DmaSize& size, const BadDescriptor& bad, tb::AxiMemory::Range window) {
  SCOPED_TRACE(testing::Message() << std::hex << bad.descriptor.address << " length "
                                  << bad.descriptor.length << " flags " << bad.descriptor.flags);
  DmaBench bench(size, bad.code);
  bench.memory.set_latency({1, 7});
  bench.set_windows(window, kNowhere);
  bench.put_packet(kPackets, 21);
  bench.put_descriptor(bad.descriptor);
  bench.put_descriptor({kPackets, 64, 0});
  ASSERT_TRUE(bench.refuses(1, bad.code));
  bench.run(50);
  EXPECT_EQ(bench.packet_difference(), "");
  std::uint64_t beats = 0;
  for (const auto& read : bench.memory.reads()) {
    const bool ring = read.address >= kRing && read.address < kRing + 8 * kBeat;
    const bool packet = read.address >= kPackets && read.address < kPackets + 21 * kBeat;
    EXPECT_TRUE(ring || packet) << std::hex << read.address;
    beats += packet ? read.beats : 0;
  }
  EXPECT_EQ(beats, (20 / bench.blocks() + 1) * bench.blocks());

  // A second start finds the same fault, a mended descriptor goes through.
  ASSERT_TRUE(bench.refuses(1, bad.code));
  bench.set_software_head(1);
  bench.put_packet(kPackets + 0x40, 9);
  bench.put_packet(kPackets + 0x1000, 3);
  EXPECT_TRUE(bench.reads(3));
  EXPECT_EQ(bench.read_errors().size(), 1u);
}

TEST_P(Refusal, EveryKindOfBadDescriptor) {
  const BadDescriptor cases[] = {
      {{kPackets, 0, 0}, kZeroLength},      {{0, 0, 0}, kZeroLength},
      {{kPackets + 15, 0, 0}, kMisaligned}, {{kPackets, 1, 0}, kMisaligned},
      {{kPackets, 63, 0}, kMisaligned},     {{kPackets, 0xffffffff, 0}, kMisaligned},
      {{0 - kBeat, 32, 0}, kWraps},         {{0 - 1000 * kBeat, 1001 * kBeat, 0}, kWraps},
      {{0 - kBeat, 0xfffffff0, 0}, kWraps}, {{0xffffffff00000020, 0xfffffff0, 0}, kWraps},
      {{kPackets, 0, 0x100}, kFlags},
  };
  for (const BadDescriptor& bad : cases) expect_refused(GetParam(), bad, kEverywhere);
  for (unsigned bit = 0; bit < 32; ++bit) {
    expect_refused(GetParam(), {{kPackets, 64, 1u << bit}, kFlags}, kEverywhere);
  }
  for (const unsigned part : {1, 2, 4, 8}) {  // of a beat
    expect_refused(GetParam(), {{kPackets + part, 64, 0}, kMisaligned}, kEverywhere);
    expect_refused(GetParam(), {{kPackets, 64 + part, 0}, kMisaligned}, kEverywhere);
  }
}

/// The ring gets longer while the packet before the bad descriptor waits for room.
TEST_P(Refusal, NoDescriptorIsReadBehindBadFlags) {
  DmaBench bench(GetParam(), 1);
  bench.packet_throttle = tb::Throttle::shut_after(1, 1000000);  // willing in the first clock only
  bench.put_packet(kPackets, 2 * bench.size().depth);
  bench.put_descriptor({kPackets, 64, 0x80000000});
  bench.start_ring();
  bench.run(2 * bench.size().depth + 200);
  bench.put_descriptor({kPackets, 64, 0});
  bench.ring_doorbell();
  bench.run(50);
  bench.packet_throttle = tb::Throttle::always();
  ASSERT_TRUE(bench.run_until_stopped());
  EXPECT_EQ(asked_for(bench).descriptors, 2u);
  EXPECT_TRUE(only(bench.read_errors(), kFlags, bench.descriptor_address(1)));
  EXPECT_TRUE(bench.exact(1));
}

/// In whichever clock the ring gets longer: what is asked for is asked for before the error.
TEST_P(Refusal, NoDescriptorIsAskedForBesideBadFlags) {
  for (std::uint64_t delay = 0; delay < 40; ++delay) {
    SCOPED_TRACE(testing::Message() << delay << " clocks");
    DmaBench bench(GetParam(), delay);
    bench.put_descriptor({kPackets, 64, 0x80000000});
    bench.start_ring();
    bench.run(delay);
    bench.put_packet(kPackets, 4);
    bench.ring_doorbell();
    ASSERT_TRUE(bench.run_until_error());
    bench.run(bench.size().guard());
    const std::size_t reads = bench.memory.reads().size();
    bench.run(40);
    EXPECT_EQ(bench.memory.reads().size(), reads);
    EXPECT_TRUE(only(bench.read_errors(), kFlags, bench.descriptor_address(0)));
    EXPECT_TRUE(bench.packets().empty());
  }
}

/// Packets that wait for room when the bad descriptor is seen are read all the same.
TEST_P(Refusal, WhatWaitsBeforeABadDescriptorIsRead) {
  for (const BadDescriptor& bad : bad_descriptors()) {
    DmaBench bench(GetParam(), bad.code);
    bench.packet_throttle = tb::make_throttle("sparse", 1);
    bench.set_windows(kReadable, kNowhere);
    for (std::uint64_t packet = 0; packet < 4; ++packet) {
      bench.put_packet(kPackets + packet * 0x4000, bench.size().depth);
    }
    bench.put_descriptor(bad.descriptor);
    bench.put_descriptor({kPackets, 64, 0});
    ASSERT_TRUE(bench.refuses(4, bad.code)) << bad.code;
    EXPECT_TRUE(bench.exact()) << bad.code;
  }
}

TEST_P(Refusal, OutsideTheReadWindow) {
  const tb::AxiMemory::Range window{kRing, kPackets + 0x1fff};
  const std::uint64_t end = kPackets + 0x2000;
  const BadDescriptor cases[] = {
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
  for (const BadDescriptor& bad : cases) expect_refused(GetParam(), bad, window);
}

TEST_P(Refusal, TheReadWindowIsExactToTheByte) {
  const std::uint64_t at = 0x40000, beats = 6, last = at + beats * kBeat - 1;
  const auto code = [&](std::uint64_t first_byte, std::uint64_t last_byte) {
    DmaBench bench(GetParam(), 5);  // a ring of two lies inside where the packet does
    return ask_read(bench, {first_byte, last_byte}, at, 1, at, beats);
  };
  EXPECT_EQ(code(at, last), 0u);
  EXPECT_EQ(code(at - 1, last + 1), 0u);
  for (std::uint64_t short_by = 1; short_by <= 17; ++short_by) {
    EXPECT_EQ(code(at, last - short_by), kOutside) << short_by;
    EXPECT_EQ(code(at + short_by, last), kOutside) << short_by;
  }
  EXPECT_EQ(code(last, at), kOutside);  // an empty window
}

/// Of a ring without descriptors, too, the engine says so before it is idle.
TEST_P(Refusal, OfAnEmptyRing) {
  DmaBench bench(GetParam(), 1);
  bench.set_windows(kNowhere, kNowhere);
  bench.start_ring();
  bench.run(5);  // what was just started is seen
  ASSERT_TRUE(bench.run_until([&] { return bench.status.idle; }));
  EXPECT_TRUE(only(bench.read_errors(), kOutside, kRing));
}

/// In whichever clock a start is refused, also beside a head that comes and goes: nothing is asked
/// for behind it.
TEST_P(Refusal, OfAStartBesideADoorbell) {
  std::uint64_t refused = 0;
  for (int pulse = 1; pulse < 4; ++pulse) {
    for (int start = 0; start < 16; ++start) {
      SCOPED_TRACE(testing::Message() << pulse << " clocks, start in " << start);
      DmaBench bench(GetParam(), 1);
      bench.put_packets(1, 1);
      ASSERT_TRUE(bench.run_ring());
      for (int i = 0; i < 8; ++i) bench.put_descriptor({kPackets, kBeat, 0});
      for (int i = 0; i < 40 && bench.read_errors().empty(); ++i) {
        bench.controls.ring_head = i < 2 || i >= 2 + pulse ? 1 : 2;
        bench.controls.ring_start = i == start;
        bench.controls.ring_base = i == start ? kRing + 16 : kRing;
        bench.step();
      }
      if (bench.read_errors().empty()) continue;  // the ring was not at its end
      ++refused;
      const std::size_t reads = bench.memory.reads().size();
      bench.run(60);
      EXPECT_EQ(bench.memory.reads().size(), reads);
      EXPECT_EQ(bench.read_errors().size(), 1u);
      EXPECT_EQ(bench.read_errors()[0].code, kMisaligned);
    }
  }
  EXPECT_GT(refused, 6u);
}

TEST_P(Refusal, TheRingLiesInTheReadWindow) {
  const std::uint64_t ring = 0x40000;
  const auto code = [&](std::uint64_t base, tb::AxiMemory::Range window) -> unsigned {
    DmaBench bench(GetParam(), 6);
    const unsigned asked = ask_read(bench, window, base, 2, ring, 2);
    EXPECT_EQ(bench.memory.reads().empty(), asked != 0);
    return asked;
  };
  const tb::AxiMemory::Range exact{ring, ring + 63};
  EXPECT_EQ(code(ring, exact), 0u);
  EXPECT_EQ(code(ring, {ring + 1, ring + 63}), kOutside);
  EXPECT_EQ(code(ring, {ring, ring + 62}), kOutside);
  EXPECT_EQ(code(ring + 64, exact), kOutside);
  EXPECT_EQ(code(ring - 64, exact), kOutside);
  EXPECT_EQ(code(ring + 16, exact), kMisaligned);
  EXPECT_EQ(code(ring + 1, exact), kMisaligned);
  EXPECT_EQ(code(ring + 32, kEverywhere), kMisaligned);
}

// ---- the result area

unsigned area_code(const DmaSize& size, tb::AxiMemory::Range window, std::uint64_t base,
                   std::uint32_t bytes) {
  DmaBench bench(size, 7);
  return ask_area(bench, window, base, bytes, 4);
}

TEST_P(Refusal, EveryKindOfBadArea) {
  EXPECT_EQ(area_code(GetParam(), kEverywhere, 0x1000, 64), 0u);
  EXPECT_EQ(area_code(GetParam(), kEverywhere, 0 - 64, 64), 0u);
  EXPECT_EQ(area_code(GetParam(), kEverywhere, 0x1000, 0), kZeroLength);
  EXPECT_EQ(area_code(GetParam(), kEverywhere, 0x1000, 15), kMisaligned);
  EXPECT_EQ(area_code(GetParam(), kEverywhere, 0x1004, 64), kMisaligned);
  EXPECT_EQ(area_code(GetParam(), kEverywhere, 0 - 64, 80), kWraps);
  EXPECT_EQ(area_code(GetParam(), kEverywhere, 0 - kBeat, 0xfffffff0), kWraps);
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
