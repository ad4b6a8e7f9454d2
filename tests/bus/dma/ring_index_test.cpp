// Indices of the ring in all their bits: where a fault is reported and where a start goes on, in
// the same ring or in a smaller one.
#include <gtest/gtest.h>

#include "dma_bench.hpp"

namespace hwffd::test {
namespace {

using testing::AssertionResult;

constexpr unsigned kLargest = 15;  // log2 of the entries
constexpr std::uint64_t kLargeRing = 0x80000;

unsigned in_ring(unsigned index, unsigned entries_log2) {
  return index & ((1u << entries_log2) - 1);
}

/// Reads packets of one beat until the tail of the largest ring is `index`.
void advance(DmaBench& bench, unsigned index) {
  bench.place_ring(kLargeRing, kLargest);
  if (index == 0) return;
  for (unsigned i = 0; i < index; ++i) {
    bench.put_descriptor({kPackets, kBeat, 0});
    bench.expect_packet(kPackets, 1);
  }
  bench.start_ring();
  ASSERT_TRUE(bench.run_until_idle(1000000));
  ASSERT_TRUE(bench.exact(index));
  bench.forget_packets();
}

/// A start finds a bad descriptor at `index`, says so and stops there.
void expect_refused(DmaBench& bench, unsigned index, const Descriptor& bad, unsigned code) {
  bench.set_software_head(static_cast<std::uint16_t>(index));
  bench.put_descriptor(bad);
  ASSERT_TRUE(bench.refuses(index, code));
}

/// The descriptor at `index`, mended, is where the next start goes on.
void expect_read(DmaBench& bench, unsigned index) {
  bench.set_software_head(static_cast<std::uint16_t>(index));
  bench.put_packet(kPackets + 0x100, 3);
  EXPECT_TRUE(bench.reads(bench.software_head()));
}

/// From a tail of `index` on, through rings of half the size each, which lose a bit of it each.
void halve_rings(unsigned index, const Descriptor& bad, unsigned code) {
  DmaBench bench(small_dma_size(), index + code);
  advance(bench, index);
  for (unsigned log2 = kLargest; log2 > 0; --log2) {
    SCOPED_TRACE(testing::Message() << "index " << index << ", 2^" << log2 << " entries");
    bench.place_ring(kLargeRing, log2);
    expect_refused(bench, in_ring(index, log2), bad, code);
    ASSERT_FALSE(testing::Test::HasFailure());
  }
  expect_read(bench, in_ring(index, 1));
}

// Both values of every bit: 0x2AAA and 0x5555.
TEST(RingIndex, OfADescriptorThatIsRefused) {
  halve_rings(0x2AAA, {kPackets, 0, 0}, kZeroLength);
  halve_rings(0x5555, {kPackets + 8, kBeat, 0}, kMisaligned);
  for (const unsigned index : {0x2AAAu, 0x5555u}) {
    halve_rings(index, {kPackets, kBeat, 1}, kFlags);
  }
}

// Through no ring between.
TEST(RingIndex, OfAMuchSmallerRing) {
  constexpr unsigned index = (1u << kLargest) - 1;
  for (unsigned log2 = 1; log2 < kLargest; ++log2) {
    SCOPED_TRACE(testing::Message() << "2^" << log2 << " entries");
    DmaBench bench(small_dma_size(), log2);
    advance(bench, index);
    bench.place_ring(kLargeRing, log2);
    expect_refused(bench, in_ring(index, log2), {kPackets, 0, 0}, kZeroLength);
    expect_read(bench, in_ring(index, log2));
  }
}

TEST(RingIndex, OfAStartInTheSameRing) {
  for (const unsigned index : {0x2AAAu, 0x5555u}) {
    DmaBench bench(small_dma_size(), index);
    advance(bench, index);
    expect_refused(bench, index, {kPackets, kBeat, 1}, kFlags);
    expect_read(bench, index);
  }
}

// Up to its last entry, then to its first.
TEST(RingIndex, OfEachRingThatGoesAround) {
  for (unsigned log2 = 1; log2 < kLargest; ++log2) {
    SCOPED_TRACE(testing::Message() << "2^" << log2 << " entries");
    DmaBench bench(small_dma_size(), log2);
    const unsigned last = (1u << log2) - 1;
    advance(bench, last - 1);
    bench.place_ring(kLargeRing, log2);
    bench.set_software_head(static_cast<std::uint16_t>(last - 1));
    bench.put_packet(kPackets, 2);
    ASSERT_TRUE(bench.reads(last));
    bench.put_packet(kPackets + 0x100, 2);
    if (log2 > 1) bench.put_packet(kPackets + 0x200, 2);
    EXPECT_TRUE(bench.reads(bench.software_head()));
  }
}

// A start checks all of its ring and no more.
TEST(RingWindow, EndsWithTheRing) {
  for (unsigned log2 = 1; log2 <= kLargest; ++log2) {
    const std::uint64_t last = kLargeRing + (kBeat << log2) - 1;
    for (const bool whole : {true, false}) {
      SCOPED_TRACE(testing::Message() << "2^" << log2 << " entries, whole: " << whole);
      DmaBench bench(small_dma_size(), log2);
      bench.set_windows({kLargeRing, whole ? last : last - 1}, kNowhere);
      bench.place_ring(kLargeRing, log2);
      ASSERT_TRUE(bench.run_ring());
      EXPECT_EQ(bench.status.ring_running, whole);
      EXPECT_TRUE(whole ? AssertionResult(bench.read_errors().empty())
                        : only(bench.read_errors(), kOutside, kLargeRing));
    }
  }
}

}  // namespace
}  // namespace hwffd::test
