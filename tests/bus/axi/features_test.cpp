// A core without some of its features: the registers say so, the driver refuses before it sends,
// and the core drops what comes all the same.
#include <gtest/gtest.h>

#include "Vaxi_positions.h"
#include "axi_run.hpp"
#include "hwffd/cores/verilated_axi_core.hpp"
#include "hwffd/stream/blending.hpp"

namespace hwffd::test {
namespace {

constexpr std::uint32_t kPositions = model::kResidentFeature;

/// tests/bus/axi/CMakeLists.txt.
class Positions : public ::testing::Test {
 protected:
  static const Configuration& row() { return find_configuration("basic-fx18-overlapped"); }

  AxiRun run_{row(),
              std::make_unique<cores::VerilatedAxiCore<Vaxi_positions>>(1),
              1,
              "mixed",
              {kPositions}};
};

TEST_F(Positions, AreAllThatTheRegistersSay) {
  const CoreIdentity core = run_.driver().probe();
  EXPECT_EQ(core.features, kPositions);
  EXPECT_EQ(core.points_axis, static_cast<unsigned>(kAxisPoints));
  EXPECT_EQ(core.pages, 2U);
  EXPECT_EQ(core.spans, 1U);
}

/// Interrupts of packets and descriptors are not there: their bits stay 0.
TEST_F(Positions, HaveNoInterruptOfAPacket) {
  constexpr std::uint32_t kMarks = HWFFD_IRQ_STATE_PACKET_MASK | HWFFD_IRQ_STATE_DESCRIPTOR_MASK;
  run_.driver().enable_interrupts(~0U);
  EXPECT_EQ(run_.system().read32(HWFFD_IRQ_ENABLE_OFFSET) & kMarks, 0U);
  run_.driver().test_interrupts(kMarks);
  EXPECT_EQ(run_.driver().take_interrupts(), 0U);
  EXPECT_THROW(run_.driver().descriptor(0x1000, 16, true), DriverError);
  run_.send_scene(3);
  ASSERT_TRUE(run_.go());
  EXPECT_TRUE(run_.clean());
}

/// Refused by the driver; sent anyway, an event each, and what comes behind them is exact.
TEST_F(Positions, NothingElseIsSent) {
  run_.send_scene(9);
  const std::vector<std::vector<Beat>> refused = {
      coefficients_packet(watertight_bspline(run_.codec()), run_.codec(),
                          Functions::kDerivativesToo),
      vertices_packet(run_.vertices(3), OutsideMode::kClamp, Results::kDerivatives),
      vertices_packet(run_.vertices(3), OutsideMode::kClamp, Results::kDeterminant),
      interleaved_packet(make_stimulus("random", run_.codec(), 2, 1))};
  for (const std::vector<Beat>& packet : refused) {
    EXPECT_THROW(run_.driver().check(packet.front().words), DriverError);
    run_.send(packet);
  }
  const std::vector<Beat> good = vertices_packet(run_.vertices(20));
  EXPECT_NO_THROW(run_.driver().check(good.front().words));
  run_.send(good);
  ASSERT_TRUE(run_.go());
  EXPECT_EQ(run_.checked(), 29U);
  EXPECT_EQ(run_.model().events()[event::kUnknownOpcode], refused.size());
  FirstError first;
  first.code = event::kUnknownOpcode;
  first.packet = 3;
  EXPECT_TRUE(run_.only_error(first, refused.size()));
  EXPECT_TRUE(run_.clean());
}

}  // namespace
}  // namespace hwffd::test
