// Bad input through the registers, a test a row of the table: the bit in ERROR_STATUS, the count,
// the first record, an end, and the next run exact. What the results look like is tested in
// tests/system/bad_input_test.cpp; bus errors and soft resets have files of their own.
#include <gtest/gtest.h>

#include "axi_run.hpp"

namespace hwffd::test {
namespace {

class AxiBadInput : public PerAxiConfiguration {
 protected:
  /// The packet as number 3 of a run, before a good one; then its errors and a good run.
  void expect_packet_error(const LatticeWords& lattice, const std::vector<Beat>& packet,
                           unsigned code, std::uint32_t beat) {
    ASSERT_TRUE(run_.soft_reset());  // packets count from 0
    run_.send_bspline();
    run_.send(lattice);
    run_.send_vertices(2);
    run_.send(packet);
    run_.send_vertices(3);
    ASSERT_TRUE(run_.go());
    EXPECT_TRUE(run_.only_error({code, 3, beat, 0}));
    EXPECT_TRUE(run_.ends_well());
  }
  /// Starts what was prepared; the DMA refuses it with that code and address.
  void expect_refusal(unsigned code, std::uint64_t address) {
    ASSERT_TRUE(run_.wait());
    EXPECT_FALSE(run_.driver().stopped());
    EXPECT_TRUE(run_.only_error({code, 0, 0, address}));
    ASSERT_TRUE(run_.soft_reset());
    EXPECT_TRUE(run_.ends_well());
  }
  /// A descriptor like that after a good packet: the packet gives its results, then the run ends.
  void expect_descriptor_refused(std::uint64_t address, std::uint32_t bytes, std::uint32_t flags,
                                 unsigned code) {
    run_.send_scene(4, 6);
    expect_put_refused(address, bytes, flags, code);
  }
  void expect_put_refused(std::uint64_t address, std::uint32_t bytes, std::uint32_t flags,
                          unsigned code) {
    const std::uint64_t descriptor = run_.ring().next_descriptor();
    run_.ring().put_descriptor(address, bytes, flags);
    ASSERT_TRUE(run_.go());
    EXPECT_EQ(run_.driver().pending(), 1U);
    expect_refusal(code, descriptor);
  }
  void expect_area_refused(std::uint64_t base, std::uint32_t bytes, unsigned code) {
    run_.send_bspline();
    run_.forget_expected();
    run_.start_in(base, bytes);
    expect_refusal(code, base);
  }

  AxiRun run_{GetParam(), 1, "bernoulli"};
};

TEST_P(AxiBadInput, Packets) {
  const LatticeWords lattice = random_lattice(run_.codec(), run_.random(), 6);
  for (const BadPacket& bad : bad_packets(run_.codec(), run_.random(), lattice)) {
    SCOPED_TRACE(bad.name);
    expect_packet_error(lattice, bad.packet, bad.code, bad.beat);
  }
}

TEST_P(AxiBadInput, VerticesBeforeCoefficients) {
  run_.send(interleaved_packet(make_stimulus("random", run_.codec(), 2, 1)));
  ASSERT_TRUE(run_.go());
  EXPECT_EQ(run_.result_word(0, 3) >> 16, kStatusUnloaded >> 16);
  EXPECT_TRUE(run_.only_error({kNoCoefficients, 0, kVertexBeats, 0}, 2));
  EXPECT_TRUE(run_.ends_well());
}

TEST_P(AxiBadInput, VerticesBeforeALattice) {
  run_.send_bspline();
  run_.send(vertices_packet(random_vertices(run_.codec(), run_.random(), {4, 4, 4}, 4)));
  ASSERT_TRUE(run_.go());
  EXPECT_EQ(run_.result_word(3, 3) >> 16, kStatusUnloaded >> 16);
  EXPECT_TRUE(run_.only_error({kNoLattice, 1, 1, 0}, 4));
  EXPECT_TRUE(run_.ends_well());
}

TEST_P(AxiBadInput, CellOutsideTheLattice) {
  const LatticeWords lattice = random_lattice(run_.codec(), run_.random(), 6);
  for (const OutsideMode mode : {OutsideMode::kClamp, OutsideMode::kPass, OutsideMode::kBlank}) {
    std::vector<VertexBeat> stray = random_vertices(run_.codec(), run_.random(), lattice.dims, 3);
    stray[2].cell[1] = lattice.dims[1] - 3;
    expect_packet_error(lattice, vertices_packet(stray, mode), kCellOutside, 3);
  }
}

TEST_P(AxiBadInput, FixedPointSaturates) {
  if (run_.codec().is_float()) GTEST_SKIP() << "binary32 does not saturate";
  AxisWords axis;
  for (auto& function : axis.word) function = {0x7FFFFFFF, 0, 0, 0};  // four weights of almost 2
  run_.send(coefficients_packet({axis, axis, axis}));
  LatticeWords lattice = random_lattice(run_.codec(), run_.random(), 6);
  for (auto& point : lattice.points) point = {0x7FFFFFFF, 0x80000000, 0x40000000};
  run_.send(lattice);
  run_.send_vertices(1);
  ASSERT_TRUE(run_.go());
  EXPECT_EQ(run_.result_word(0, 3) >> 16, kStatusSaturated >> 16);
  const CoreErrors errors = run_.driver().take_errors();  // at a place that depends on the pipeline
  EXPECT_EQ(errors.status, 1U << kSaturated);
  EXPECT_EQ(errors.count, 1U);
  ASSERT_TRUE(errors.first.has_value());
  EXPECT_EQ(errors.first->code, unsigned{kSaturated});
  EXPECT_TRUE(run_.ends_well());
}

TEST_P(AxiBadInput, StartWhileBusy) {
  run_.send_scene(200, 6);
  run_.start();
  EXPECT_THROW(run_.driver().start(), DriverError);
  const std::uint32_t irq = run_.driver().take_interrupts();
  EXPECT_NE(irq & HWFFD_IRQ_STATE_REFUSED_MASK, 0U);
  ASSERT_TRUE(run_.finish()) << "the run under way is not touched";
  EXPECT_EQ(run_.driver().take_errors().status, 0U);
  EXPECT_TRUE(run_.ends_well());
}

TEST_P(AxiBadInput, StartBeforeTheLock) {
  run_.system().reset();
  run_.system().allow({}, {});  // nothing may go out
  Driver& driver = run_.driver();
  driver.set_windows(kReadWindow, kWriteWindow);
  run_.ring().open();
  run_.send_bspline();
  EXPECT_THROW(driver.start(), DriverError);
  run_.system().run(200);
  EXPECT_EQ(driver.pending(), 1U);
  EXPECT_EQ(run_.system().utilisation().clocks(), 0U);
  driver.lock_windows();
  run_.system().allow(kReadWindow, kWriteWindow);
  ASSERT_TRUE(run_.go()) << "the packet was still there";
  EXPECT_TRUE(run_.ends_well());
}

TEST_P(AxiBadInput, Descriptors) {
  expect_descriptor_refused(kBuffers.base, 0, 0, kDmaZero);
  expect_descriptor_refused(kBuffers.base + 8, 32, 0, kDmaMisaligned);
  expect_descriptor_refused(kBuffers.base, 24, 0, kDmaMisaligned);
  expect_descriptor_refused(0xFFFFFFFFFFFFFFF0, 32, 0, kDmaWrap);
  expect_descriptor_refused(kReadWindow.base - kBeat, 32, 0, kDmaWindow);
  expect_descriptor_refused(kReadWindow.limit + 1 - kBeat, 32, 0, kDmaWindow);
  expect_descriptor_refused(kWriteWindow.base, 32, 0, kDmaWindow);
  expect_descriptor_refused(kBuffers.base, 32, 1, kDmaDescriptor);
}

/// Packets that wait when the descriptor behind them is seen end as they should.
TEST_P(AxiBadInput, DescriptorWithFlagsBehindPacketsThatWait) {
  run_.send_scene(600, 6);
  run_.send_vertices(200);
  expect_put_refused(kBuffers.base, 32, 1, kDmaDescriptor);
}

TEST_P(AxiBadInput, RingOffItsSizeOrOutsideTheWindow) {
  const std::pair<std::uint32_t, unsigned> bad[] = {{kRing.base + kBeat, kDmaMisaligned},
                                                    {kRing.base - 0x200, kDmaWindow}};
  for (const auto& [base, code] : bad) {
    ASSERT_TRUE(run_.soft_reset());
    run_.system().write32(HWFFD_RING_BASE_LO_OFFSET, base);
    run_.send_bspline();
    run_.start();
    expect_refusal(code, base);
  }
}

TEST_P(AxiBadInput, ResultAreaRefused) {
  expect_area_refused(kWriteWindow.base, 0, kDmaZero);
  expect_area_refused(kWriteWindow.base + 4, 32, kDmaMisaligned);
  expect_area_refused(kWriteWindow.base, 40, kDmaMisaligned);
  expect_area_refused(0xFFFFFFFFFFFFFFF0, 32, kDmaWrap);
  expect_area_refused(kWriteWindow.base - kBeat, 32, kDmaWindow);
  expect_area_refused(kWriteWindow.limit + 1 - kBeat, 32, kDmaWindow);
  expect_area_refused(kBuffers.base, 32, kDmaWindow);
}

/// Results that the area has no room for are dropped; nothing behind it is touched.
TEST_P(AxiBadInput, ResultAreaTooSmall) {
  run_.send_scene(40, 6);
  run_.start(25);
  ASSERT_TRUE(run_.wait());
  EXPECT_EQ(run_.driver().result_count(), 25U);
  EXPECT_EQ(run_.results_in_memory(), 25U);
  run_.forget_expected();
  EXPECT_TRUE(run_.only_error({kResultOverflow, 0, 0, 0}));
  EXPECT_TRUE(run_.ends_well());
}

HWFFD_FOR_EACH_AXI_CONFIGURATION(AxiBadInput);

}  // namespace
}  // namespace hwffd::test
