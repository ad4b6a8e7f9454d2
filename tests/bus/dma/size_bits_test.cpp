// Lengths, sizes and numbers of entries in all their bits: each of them counts where a window ends.
// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <vector>

#include "asking.hpp"

namespace hwffd::test {
namespace {

constexpr std::uint64_t kBase = 0x1'0000'0000;
constexpr unsigned kLargestRing = 15;  // log2 of the entries

class SizeBits : public PerDmaSize {};
HWFFD_FOR_EACH_DMA_SIZE(SizeBits);

/// Sizes with a single bit, and with all others, in multiples of a beat.
std::vector<std::uint32_t> sizes_of_all_bits() {
  std::vector<std::uint32_t> sizes;
  for (unsigned k = 4; k < 32; ++k) {
    const std::uint32_t bit = std::uint32_t{1} << k;
    sizes.insert(sizes.end(), {bit, ~bit & 0xfffffff0});
  }
  return sizes;
}

/// What comes of a packet there, which has not come whole yet: its code, or 0.
unsigned code_of_packet(const DmaSize& size, std::uint32_t bytes, std::uint64_t last) {
  DmaBench bench(size, bytes);
  bench.set_windows({0, last}, kNowhere);
  bench.put_descriptor({kBase, bytes, 0});
  bench.start_ring();
  bench.run(60);
  EXPECT_EQ(bench.checker.violations(), 0u);
  if (!bench.read_errors().empty()) return bench.read_errors()[0].code;
  EXPECT_FALSE(bench.packets().empty());
  return 0;
}

/// A start that is refused before anything runs.
void expect_no_start(DmaBench& bench, unsigned code) {
  bench.start_ring();
  bench.run(2);
  EXPECT_TRUE(only(bench.read_errors(), code, bench.controls.ring_base));
  EXPECT_FALSE(bench.status.ring_running);
  bench.run(10);
  EXPECT_TRUE(bench.memory.reads().empty());
}

TEST_P(SizeBits, OfAPacket) {
  for (const std::uint32_t bytes : sizes_of_all_bits()) {
    SCOPED_TRACE(testing::Message() << std::hex << bytes);
    const std::uint64_t last = kBase + bytes - 1;
    EXPECT_EQ(code_of_packet(GetParam(), bytes, last), 0u);
    EXPECT_EQ(code_of_packet(GetParam(), bytes, last - 1), kOutside);
  }
}

TEST_P(SizeBits, OfAnArea) {
  const auto code = [](std::uint32_t bytes, std::uint64_t last) {
    DmaBench bench(GetParam(), bytes);
    return ask_area(bench, {0, last}, kBase, bytes, 1);
  };
  for (const std::uint32_t bytes : sizes_of_all_bits()) {
    SCOPED_TRACE(testing::Message() << std::hex << bytes);
    const std::uint64_t last = kBase + bytes - 1;
    EXPECT_EQ(code(bytes, last), 0u);
    EXPECT_EQ(code(bytes, last - 1), kOutside);
  }
}

TEST_P(SizeBits, OfARing) {
  const auto code = [](std::uint64_t ring, unsigned log2, std::uint64_t last) {
    DmaBench bench(GetParam(), log2);
    return ask_read(bench, {0, last}, ring, log2, 0x4000, 2);
  };
  for (unsigned log2 = 1; log2 <= kLargestRing; ++log2) {
    SCOPED_TRACE(testing::Message() << "2^" << log2 << " entries");
    const std::uint64_t bytes = kBeat << log2;
    EXPECT_EQ(code(kBase, log2, kBase + bytes - 1), 0u);
    EXPECT_EQ(code(kBase, log2, kBase + bytes - 2), kOutside);
    EXPECT_EQ(code(kBase + bytes, log2, kEverywhere.second), 0u);
    for (std::uint64_t bit = 1; bit < bytes; bit *= 2) {
      DmaBench bench(GetParam(), log2);
      bench.place_ring(kBase + bit, log2);
      expect_no_start(bench, kMisaligned);
    }
  }
}

TEST_P(SizeBits, OfARingOfOneEntry) {
  DmaBench bench(GetParam(), 1);
  bench.place_ring(kBase, 0);
  expect_no_start(bench, kBadRing);
}

TEST_P(SizeBits, OfAHeadBeyondItsRing) {
  for (unsigned log2 = 1; log2 <= kLargestRing; ++log2) {
    for (unsigned k = log2; k < 16; ++k) {
      SCOPED_TRACE(testing::Message() << "2^" << log2 << " entries, bit " << k);
      DmaBench bench(GetParam(), k);
      bench.place_ring(kBase, log2);
      bench.set_software_head(static_cast<std::uint16_t>(1u << k));
      expect_no_start(bench, kBadRing);
    }
  }
}

/// One that goes beyond it while the ring runs.
TEST_P(SizeBits, OfAHeadThatLeavesItsRing) {
  for (unsigned log2 = 1; log2 <= kLargestRing; ++log2) {
    for (unsigned k = log2; k < 16; ++k) {
      SCOPED_TRACE(testing::Message() << "2^" << log2 << " entries, bit " << k);
      DmaBench bench(GetParam(), k);
      bench.place_ring(kBase, log2);
      bench.put_packet(kPackets, 2);
      ASSERT_TRUE(bench.reads(1));
      EXPECT_TRUE(bench.status.ring_running);
      bench.set_software_head(static_cast<std::uint16_t>(1u << k));
      bench.ring_doorbell();
      ASSERT_TRUE(bench.run_until_error(100));
      ASSERT_TRUE(bench.run_until_stopped(100));
      EXPECT_FALSE(bench.status.ring_running);
      EXPECT_TRUE(only(bench.read_errors(), kBadRing, kBase));
      EXPECT_TRUE(bench.exact(1));
    }
  }
}

}  // namespace
}  // namespace hwffd::test
