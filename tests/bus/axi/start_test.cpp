// What a start takes with it, and what it refuses: writes that follow it at once belong to the next
// run, a ring is one that its head fits.
#include <gtest/gtest.h>

#include "axi_run.hpp"

namespace hwffd::test {
namespace {

class AxiStart : public PerAxiConfiguration {};

/// A write takes effect at its response, so one whose response comes after that of the start does
/// not touch the run that the start began, however close it follows.
TEST_P(AxiStart, AWriteBehindItDoesNotMoveTheResults) {
  struct Write {
    std::uint32_t offset, value;
  };
  const std::vector<std::vector<Write>> behind = {
      {{HWFFD_RESULT_BASE_LO_OFFSET, static_cast<std::uint32_t>(kWriteWindow.base + 0x8000)}},
      {{HWFFD_RESULT_BASE_HI_OFFSET, 0x7}},
      {{HWFFD_RESULT_SIZE_OFFSET, 0}},
      {{HWFFD_RESULT_BASE_HI_OFFSET, 0x7}, {HWFFD_RESULT_BASE_LO_OFFSET, 0x40}}};
  for (const std::vector<Write>& writes : behind) {
    AxiRun run(GetParam(), 1);
    for (std::uint64_t clocks = 0; clocks <= 8; ++clocks) {
      run.send_scene(12);
      run.start({}, [&] {
        run.system().run(clocks);
        for (const Write& write : writes) run.system().post_write(write.offset, write.value);
      });
      ASSERT_TRUE(run.finish()) << std::hex << writes[0].offset << ", " << clocks << " clocks";
      EXPECT_EQ(run.driver().take_errors().status, 0U) << clocks;
    }
    EXPECT_TRUE(run.clean());
  }
}

/// Head 16 of 16 is none of its entries, and a ring of one entry, which stays unused, has none.
TEST_P(AxiStart, ARingWithoutItsHeadIsRefused) {
  struct Ring {
    unsigned log2_size, head;
  };
  AxiRun run(GetParam(), 2);
  ASSERT_TRUE(run.good_run());
  for (const Ring& ring : {Ring{4, 16}, {3, 8}, {3, 12}, {5, 0x8001}, {1, 2}, {0, 0}, {0, 1}}) {
    SCOPED_TRACE(testing::Message() << ring.head << " of 2^" << ring.log2_size);
    ASSERT_TRUE(run.soft_reset());
    run.system().write32(HWFFD_RING_LOG2_SIZE_OFFSET, ring.log2_size);
    run.system().write32(HWFFD_RING_HEAD_OFFSET, ring.head);
    const std::size_t reads = run.system().memory.reads().size();
    run.start(1);
    ASSERT_TRUE(run.wait());
    EXPECT_TRUE(run.only_error({kDmaRing, 0, 0, kRing.base}));
    EXPECT_FALSE(run.driver().stopped());
    EXPECT_EQ(run.system().memory.reads().size(), reads);
    EXPECT_EQ(run.driver().result_count(), 0U);
    ASSERT_TRUE(run.soft_reset());
    ASSERT_TRUE(run.good_run());
  }
  EXPECT_TRUE(run.clean());
}

/// Each bit of a head that the ring has not makes it wrong.
TEST_P(AxiStart, EachBitOfAHeadIsLookedAt) {
  AxiRun run(GetParam(), 3);
  for (unsigned bit = kRing.log2_size; bit < 16; ++bit) {
    ASSERT_TRUE(run.soft_reset());
    run.system().write32(HWFFD_RING_HEAD_OFFSET, 1U << bit);
    run.start(1);
    ASSERT_TRUE(run.wait());
    ASSERT_TRUE(run.only_error({kDmaRing, 0, 0, kRing.base})) << "bit " << bit;
  }
  ASSERT_TRUE(run.soft_reset());
  EXPECT_TRUE(run.ends_well());
}

/// Each bit of a ring's base that its size wants to be 0.
TEST_P(AxiStart, EachBitOfARingsBaseIsLookedAt) {
  AxiRun run(GetParam(), 4);
  for (unsigned bit = 0; bit < kRing.log2_size + 4; ++bit) {
    ASSERT_TRUE(run.soft_reset());
    const std::uint64_t base = kRing.base | std::uint64_t{1} << bit;
    run.system().write32(HWFFD_RING_BASE_LO_OFFSET, static_cast<std::uint32_t>(base));
    run.send_bspline();
    run.start(1);
    ASSERT_TRUE(run.wait());
    EXPECT_TRUE(run.only_error({kDmaMisaligned, 0, 0, base})) << "bit " << bit;
  }
  ASSERT_TRUE(run.soft_reset());
  EXPECT_TRUE(run.ends_well());
}

/// Each bit of the area's base and size.
TEST_P(AxiStart, EachBitOfAnAreaIsLookedAt) {
  AxiRun run(GetParam(), 5);
  const auto expect_refused = [&](std::uint64_t base, std::uint32_t bytes, unsigned code) {
    SCOPED_TRACE(testing::Message() << std::hex << base << ", " << bytes << " bytes");
    ASSERT_TRUE(run.soft_reset());
    run.start(1);
    ASSERT_TRUE(run.wait());
    ASSERT_EQ(run.driver().take_errors().status, 0U);
    run.start_in(base, bytes);
    ASSERT_TRUE(run.wait());
    EXPECT_TRUE(run.only_error({code, 0, 0, base}));
  };
  const std::uint64_t base = kWriteWindow.base;
  for (unsigned bit = 0; bit < 4; ++bit) {
    expect_refused(base | 1U << bit, 32, kDmaMisaligned);
    expect_refused(base, 32 | 1U << bit, kDmaMisaligned);
  }
  for (unsigned bit = 5; bit < 21; ++bit) {  // inside the window: larger than what comes
    ASSERT_TRUE(run.soft_reset());
    run.send_scene(1);
    run.start((std::uint64_t{1} << bit) / cores::kAxiBeatBytes);
    ASSERT_TRUE(run.finish()) << "bit " << bit;
  }
  for (unsigned bit = 21; bit < 32; ++bit) expect_refused(base, 1U << bit, kDmaWindow);
  for (unsigned bit = 21; bit < 64; ++bit) {
    expect_refused(base ^ std::uint64_t{1} << bit, 32, kDmaWindow);
  }
  ASSERT_TRUE(run.soft_reset());
  EXPECT_TRUE(run.ends_well());
}

/// What was in the ring before its head went wrong is worked off.
TEST_P(AxiStart, AHeadThatGoesWrongEndsTheRun) {
  unsigned refused = 0;
  for (std::uint64_t clocks = 1; clocks < 2000; clocks += 1 + clocks / 2) {
    AxiRun run(GetParam(), clocks);
    run.send_scene(12);
    run.start();
    run.system().run(clocks);
    const std::uint32_t head = run.system().read32(HWFFD_RING_HEAD_OFFSET);
    run.system().write32(HWFFD_RING_HEAD_OFFSET, head + (1U << kRing.log2_size) + 2);
    ASSERT_TRUE(run.wait());
    const std::uint32_t status = run.driver().take_errors().status;
    const bool late = run.results_in_memory() == run.expected().size();
    EXPECT_TRUE(status == 1U << kDmaRing || (status == 0 && late)) << status;
    EXPECT_GE(run.results_in_memory(), run.driver().result_count());
    refused += status != 0 ? 1 : 0;
    ASSERT_TRUE(run.soft_reset());
    EXPECT_TRUE(run.ends_well()) << clocks;
  }
  EXPECT_GT(refused, 5U);
}

/// Descriptors that come while a run ends are worked off before its end, or not before the next
/// start.
TEST_P(AxiStart, AHeadAtItsEndIsOfThisRunOrOfTheNext) {
  constexpr std::uint64_t kBefore = 60, kLate = 6;
  AxiRun whole(GetParam(), 6);
  whole.send_scene(3);
  whole.start();
  std::uint64_t end = 0;
  for (; !whole.system().interrupt() && end < 100'000; ++end) whole.system().run(1);
  unsigned of_next = 0;
  for (std::uint64_t clocks = end - kBefore; clocks < end; ++clocks) {
    SCOPED_TRACE(clocks);
    AxiRun run(GetParam(), 6);
    run.send_scene(3);
    run.start(3 + kLate);
    run.system().run(clocks);
    const std::vector<Beat> late = vertices_packet(run.vertices(kLate));
    run.ring().put(late);
    ASSERT_TRUE(run.wait());
    const unsigned pending = run.driver().pending();
    if (pending == 0) run.expect(late);
    ASSERT_TRUE(run.finish());
    if (pending == 0) continue;
    run.system().run(1000);
    EXPECT_EQ(run.driver().pending(), pending);
    EXPECT_EQ(run.driver().result_count(), 3U);
    run.expect(late);
    EXPECT_TRUE(run.go());
    ++of_next;
  }
  EXPECT_GT(of_next, 5U);
  EXPECT_LT(of_next, kBefore);
}

HWFFD_FOR_EACH_AXI_CONFIGURATION(AxiStart);

}  // namespace
}  // namespace hwffd::test
