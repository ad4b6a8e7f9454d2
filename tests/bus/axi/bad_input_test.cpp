// Bad input through the registers, a test a row of the table: the bit in ERROR_STATUS, the count,
// the first record, an end, and the next run exact. What the results look like is tested in
// tests/system/bad_input_test.cpp; bus errors and soft resets have files of their own.
#include <gtest/gtest.h>

#include "axi_run.hpp"
#include "hwffd/stream/blending.hpp"

namespace hwffd::test {
namespace {

constexpr std::uint64_t kBeat = cores::kAxiBeatBytes;

struct Record {
  std::uint32_t packet = 0;
  std::uint32_t beat = 0;
  std::uint64_t address = 0;
};

class AxiBadInput : public PerAxiConfiguration {
 protected:
  std::vector<VertexBeat> vertices(std::size_t count) {
    return random_vertices(run_.codec(), run_.random(), lattice_.dims, count);
  }

  /// Coefficients, the lattice and so many vertices.
  void send_vertices(std::size_t count) {
    run_.send_bspline();
    run_.send(lattice_packet(lattice_));
    run_.send(vertices_packet(vertices(count)));
  }
  /// `count` errors of one code and no other, the first with that record.
  void expect_errors(unsigned code, std::uint32_t count, const Record& record) {
    const CoreErrors errors = run_.driver().take_errors();
    EXPECT_EQ(errors.status, 1U << code);
    EXPECT_EQ(errors.count, count);
    ASSERT_TRUE(errors.first.has_value());
    EXPECT_EQ(errors.first->code, code);
    EXPECT_EQ(errors.first->packet, record.packet);
    EXPECT_EQ(errors.first->beat, record.beat);
    EXPECT_EQ(errors.first->address, record.address);
    run_.driver().clear_counters();
    EXPECT_FALSE(run_.driver().take_errors().first.has_value());
  }
  void expect_good_run() {
    EXPECT_TRUE(run_.good_run());
    EXPECT_TRUE(run_.clean());
  }
  /// The packet as number 3 of a run, before a good one; then its errors and a good run.
  void expect_packet_error(const std::vector<Beat>& packet, unsigned code, std::uint32_t count,
                           std::uint32_t beat) {
    ASSERT_TRUE(run_.soft_reset());  // packets count from 0
    send_vertices(2);
    run_.send(packet);
    run_.send(vertices_packet(vertices(3)));
    ASSERT_TRUE(run_.go());
    expect_errors(code, count, {3, beat, 0});
    expect_good_run();
  }
  /// Starts what was prepared; the DMA refuses it with that code and address.
  void expect_refusal(unsigned code, std::uint64_t address) {
    ASSERT_TRUE(run_.wait());
    EXPECT_FALSE(run_.driver().stopped());
    expect_errors(code, 1, {0, 0, address});
    ASSERT_TRUE(run_.soft_reset());
    expect_good_run();
  }
  /// A descriptor like that after a good packet: the packet gives its results, then the run ends.
  void expect_descriptor_refused(std::uint64_t address, std::uint32_t bytes, std::uint32_t flags,
                                 unsigned code) {
    send_vertices(4);
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
  /// An area like that, past the checks of the driver.
  void expect_area_refused(std::uint64_t base, std::uint32_t bytes, unsigned code) {
    run_.send_bspline();
    run_.forget_expected();
    auto& port = run_.system();
    port.write32(HWFFD_RESULT_BASE_LO_OFFSET, static_cast<std::uint32_t>(base));
    port.write32(HWFFD_RESULT_BASE_HI_OFFSET, static_cast<std::uint32_t>(base >> 32));
    port.write32(HWFFD_RESULT_SIZE_OFFSET, bytes);
    run_.driver().start();
    expect_refusal(code, base);
  }

  AxiRun run_{GetParam(), 1, "bernoulli"};
  LatticeWords lattice_ = random_lattice(run_.codec(), run_.random(), 6);
};

TEST_P(AxiBadInput, UnknownOpcode) {
  std::vector<Beat> packet = vertices_packet(vertices(3));
  packet[0].words[0] = 0x77;
  expect_packet_error(packet, kUnknownOpcode, 1, 0);
}

TEST_P(AxiBadInput, PacketTooShort) {
  for (const std::vector<Beat>& whole :
       {lattice_packet(lattice_), vertices_packet(vertices(5)),
        coefficients_packet(watertight_bspline(run_.codec()), run_.codec())}) {
    for (const std::size_t beats : {std::size_t{1}, std::size_t{2}, whole.size() - 1}) {
      std::vector<Beat> packet(whole.begin(), whole.begin() + static_cast<std::ptrdiff_t>(beats));
      packet.back().last = true;
      expect_packet_error(packet, kPacketShort, 1, static_cast<std::uint32_t>(beats - 1));
    }
  }
}

TEST_P(AxiBadInput, PacketTooLong) {
  for (std::vector<Beat> packet : {lattice_packet(lattice_), vertices_packet(vertices(5))}) {
    const auto beat = static_cast<std::uint32_t>(packet.size());  // the first one too many
    packet.back().last = false;
    packet.resize(packet.size() + 3);
    packet.back().last = true;
    expect_packet_error(packet, kPacketLong, 1, beat);
  }
}

TEST_P(AxiBadInput, VerticesBeforeCoefficients) {
  run_.send(interleaved_packet(make_stimulus("random", run_.codec(), 2, 1)));
  ASSERT_TRUE(run_.go());
  EXPECT_EQ(run_.result_word(0, 3) >> 16, kStatusUnloaded >> 16);
  expect_errors(kNoCoefficients, 2, {0, kVertexBeats, 0});
  expect_good_run();
}

TEST_P(AxiBadInput, VerticesBeforeALattice) {
  run_.send_bspline();
  run_.send(vertices_packet(vertices(4)));
  ASSERT_TRUE(run_.go());
  EXPECT_EQ(run_.result_word(3, 3) >> 16, kStatusUnloaded >> 16);
  expect_errors(kNoLattice, 4, {1, 1, 0});
  expect_good_run();
}

TEST_P(AxiBadInput, LatticeOfBadDimensions) {
  for (const std::uint32_t word : {0x040403U, 0x110404U, 0U}) {
    std::vector<Beat> packet = lattice_packet(lattice_);
    packet[0].words[2] = word;
    expect_packet_error(packet, kLatticeSize, 1, 0);
  }
}

TEST_P(AxiBadInput, CoordinateThatIsNoNumber) {
  if (!run_.codec().is_float()) GTEST_SKIP() << "fixed point has none";
  for (const std::uint32_t word : {0x7FC00000U, 0xFF800001U, 0x7F800000U, 0xFF800000U}) {
    std::vector<VertexBeat> stray = vertices(3);
    stray[1].local[0] = word;
    expect_packet_error(vertices_packet(stray), kCoordinateNan, 1, 2);
  }
}

TEST_P(AxiBadInput, CoordinateOutside) {
  const std::uint32_t word = run_.codec().is_float() ? 0xBF800000U : 0x80000001U;
  for (const OutsideMode mode : {OutsideMode::kClamp, OutsideMode::kBlank}) {
    std::vector<VertexBeat> stray = vertices(3);
    stray[1].local[2] = word;
    expect_packet_error(vertices_packet(stray, mode), kCoordinateOutside, 1, 2);
  }
}

TEST_P(AxiBadInput, CellOutsideTheLattice) {
  for (const OutsideMode mode : {OutsideMode::kClamp, OutsideMode::kPass, OutsideMode::kBlank}) {
    std::vector<VertexBeat> stray = vertices(3);
    stray[2].cell[1] = lattice_.dims[1] - 3;
    expect_packet_error(vertices_packet(stray, mode), kCellOutside, 1, 3);
  }
}

TEST_P(AxiBadInput, LastFaceIsInside) {
  run_.send_bspline();
  run_.send(lattice_packet(lattice_));
  std::vector<VertexBeat> face = vertices(3);
  for (int axis = 0; axis < 3; ++axis) {
    face[1].cell[axis] = lattice_.dims[axis] - 4;
    face[1].local[axis] = run_.codec().coordinate(1);
  }
  run_.send(vertices_packet(face));
  ASSERT_TRUE(run_.go());
  EXPECT_EQ(run_.result_word(1, 3) >> 16, 0U);
  EXPECT_EQ(run_.driver().take_errors().status, 0U);
  EXPECT_TRUE(run_.clean());
}

TEST_P(AxiBadInput, FixedPointSaturates) {
  if (run_.codec().is_float()) GTEST_SKIP() << "binary32 does not saturate";
  AxisWords axis;
  for (auto& function : axis.word) function = {0x7FFFFFFF, 0, 0, 0};  // four weights of almost 2
  run_.send(coefficients_packet({axis, axis, axis}));
  LatticeWords lattice = lattice_;
  for (auto& point : lattice.points) point = {0x7FFFFFFF, 0x80000000, 0x40000000};
  run_.send(lattice_packet(lattice));
  run_.send(vertices_packet(vertices(1)));
  ASSERT_TRUE(run_.go());
  EXPECT_EQ(run_.result_word(0, 3) >> 16, kStatusSaturated >> 16);
  const CoreErrors errors = run_.driver().take_errors();
  EXPECT_EQ(errors.status, 1U << kSaturated);
  EXPECT_EQ(errors.count, 1U);
  ASSERT_TRUE(errors.first.has_value());
  EXPECT_EQ(errors.first->code, static_cast<unsigned>(kSaturated));
  expect_good_run();
}

/// Vertices before a reload see the old values, those after it the new ones.
TEST_P(AxiBadInput, ReloadedWhileVerticesAreInFlight) {
  run_.send_bspline();
  for (int load = 0; load < 7; ++load) {
    lattice_ = random_lattice(run_.codec(), run_.random(), 5);
    run_.send(lattice_packet(lattice_));
    run_.send(vertices_packet(vertices(3)));
    run_.send_bspline();
    run_.send(vertices_packet(vertices(3)));
  }
  ASSERT_TRUE(run_.go());
  EXPECT_EQ(run_.checked(), 42U);
  EXPECT_EQ(run_.driver().take_errors().status, 0U);
  EXPECT_TRUE(run_.clean());
}

TEST_P(AxiBadInput, RegisterUnmappedReadOnlyOrLocked) {
  tb::AxiSystem& port = run_.system();
  EXPECT_THROW(port.read32(0xFFC), RegisterError);
  EXPECT_EQ(port.try_write(0xFFC, ~0U), cores::kSlvErr);
  EXPECT_EQ(port.try_write(HWFFD_RING_TAIL_OFFSET, 5), cores::kSlvErr);
  const std::uint32_t limit = port.read32(HWFFD_READ_WINDOW_LIMIT_LO_OFFSET);
  EXPECT_EQ(port.try_write(HWFFD_READ_WINDOW_LIMIT_LO_OFFSET, 0), cores::kSlvErr);
  EXPECT_EQ(port.read32(HWFFD_READ_WINDOW_LIMIT_LO_OFFSET), limit);
  EXPECT_EQ(run_.driver().take_errors().status, 0U);
  expect_good_run();
}

TEST_P(AxiBadInput, StartWhileBusy) {
  send_vertices(200);
  run_.start();
  EXPECT_THROW(run_.driver().start(), DriverError);
  const std::uint32_t irq = run_.driver().take_interrupts();
  EXPECT_NE(irq & HWFFD_IRQ_STATE_REFUSED_MASK, 0U);
  ASSERT_TRUE(run_.finish()) << "the run under way is not touched";
  EXPECT_EQ(run_.driver().take_errors().status, 0U);
  expect_good_run();
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
  expect_good_run();
}

TEST_P(AxiBadInput, DescriptorOfLengthZero) {
  expect_descriptor_refused(kBuffers.base, 0, 0, kDmaZero);
}

TEST_P(AxiBadInput, DescriptorMisaligned) {
  expect_descriptor_refused(kBuffers.base + 8, 32, 0, kDmaMisaligned);
  expect_descriptor_refused(kBuffers.base, 24, 0, kDmaMisaligned);
}

TEST_P(AxiBadInput, DescriptorBeyondTheLastAddress) {
  expect_descriptor_refused(0xFFFFFFFFFFFFFFF0, 32, 0, kDmaWrap);
}

TEST_P(AxiBadInput, DescriptorOutsideTheWindow) {
  expect_descriptor_refused(kReadWindow.base - kBeat, 32, 0, kDmaWindow);
  expect_descriptor_refused(kReadWindow.limit + 1 - kBeat, 32, 0, kDmaWindow);
  expect_descriptor_refused(kWriteWindow.base, 32, 0, kDmaWindow);
}

TEST_P(AxiBadInput, DescriptorWithFlags) {
  expect_descriptor_refused(kBuffers.base, 32, 1, kDmaDescriptor);
}

/// Packets that wait when the descriptor behind them is seen end as they should.
TEST_P(AxiBadInput, DescriptorWithFlagsBehindPacketsThatWait) {
  send_vertices(600);
  run_.send(vertices_packet(vertices(200)));
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
  send_vertices(40);
  run_.start(25);
  ASSERT_TRUE(run_.wait());
  EXPECT_EQ(run_.driver().result_count(), 25U);
  EXPECT_EQ(run_.results_in_memory(), 25U);
  run_.forget_expected();
  expect_errors(kResultOverflow, 1, {0, 0, 0});
  expect_good_run();
}

HWFFD_FOR_EACH_AXI_CONFIGURATION(AxiBadInput);

}  // namespace
}  // namespace hwffd::test
