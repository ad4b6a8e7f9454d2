// Error responses of the bus: both directions stop, what is open is completed, the address is there
// to read, a start is refused, and after a soft reset everything goes on exactly.
#include <gtest/gtest.h>

#include "axi_run.hpp"

namespace hwffd::test {
namespace {

class AxiBusError : public PerAxiConfiguration {
 protected:
  /// A good packet, then one of `beats` beats in one burst; after it one that must not be sent.
  struct Prepared {
    std::uint64_t descriptor, packet;
    std::size_t results_before;
  };
  Prepared prepare(AxiRun& run) {
    run.send_scene(3);
    Prepared prepared{run.ring().next_descriptor(), 0, run.expected().size()};
    const std::uint64_t page = (run.ring().next_buffer() | 0xFFF) + 1;
    run.ring().set_next_buffer(page);  // so that it is one burst
    prepared.packet = page;
    run.send_vertices(kVertices);
    run.send_vertices(3);
    return prepared;
  }
  /// What every bus error leaves behind.
  void expect_stopped(AxiRun& run, unsigned code, std::uint64_t address) {
    ASSERT_TRUE(run.wait());
    EXPECT_TRUE(run.driver().stopped());
    const CoreErrors errors = run.driver().take_errors();
    // A packet that was cut is too short for the core.
    EXPECT_EQ(errors.status & ~(1U << kPacketShort), 1U << code);
    ASSERT_TRUE(errors.first.has_value());
    EXPECT_EQ(errors.first->address, address);
    EXPECT_TRUE(run.system().memory.quiet()) << "open bursts are completed";
    EXPECT_THROW(run.driver().start(), DriverError) << "stopped";
    const std::size_t reads = run.system().memory.reads().size();
    run.system().run(100);
    EXPECT_EQ(run.system().memory.reads().size(), reads) << "no address after the error";
  }
  void expect_restart(AxiRun& run) {
    run.system().memory.fail_nothing();
    ASSERT_TRUE(run.soft_reset());
    EXPECT_FALSE(run.driver().stopped());
    run.driver().take_errors();
    EXPECT_TRUE(run.good_run());
  }

  static constexpr std::size_t kVertices = 12;
};

TEST_P(AxiBusError, OnEveryBeatOfAPacket) {
  AxiRun run(GetParam(), 1, "bernoulli");
  for (std::size_t beat = 0; beat <= kVertices; ++beat) {
    const Prepared prepared = prepare(run);
    const bool slave = beat % 2 == 0;
    run.system().memory.fail_read_at(prepared.packet, beat,
                                     slave ? cores::kAxiSlverr : cores::kAxiDecerr);
    run.start();
    expect_stopped(run, kDmaReadResponse, prepared.packet);
    // No more results than vertices before the error; those that are counted are right.
    const std::size_t whole = prepared.results_before + (beat == 0 ? 0 : beat - 1);
    EXPECT_LE(run.driver().result_count(), whole) << beat;
    EXPECT_GE(run.results_in_memory(), run.driver().result_count()) << beat;
    EXPECT_LE(run.driver().pending(), 2U);
    expect_restart(run);
  }
  EXPECT_TRUE(run.clean());
}

TEST_P(AxiBusError, OnADescriptor) {
  AxiRun run(GetParam(), 2, "bernoulli");
  const Prepared prepared = prepare(run);
  run.system().memory.fail_read_at(prepared.descriptor, 0, cores::kAxiDecerr);
  run.start();
  expect_stopped(run, kDmaReadResponse, prepared.descriptor);
  EXPECT_LE(run.driver().result_count(), prepared.results_before);
  EXPECT_GE(run.results_in_memory(), run.driver().result_count());
  EXPECT_GE(run.driver().pending(), 2U) << "the tail stays at it, or before";
  expect_restart(run);
  EXPECT_TRUE(run.clean());
}

TEST_P(AxiBusError, OnEveryBurstOfResults) {
  AxiRun run(GetParam(), 3, "bernoulli");
  for (std::uint64_t burst = 0; burst < 3; ++burst) {  // a burst a packet at least
    prepare(run);
    const std::size_t first = run.system().memory.writes().size();
    run.system().memory.fail_write(burst, burst == 1 ? cores::kAxiDecerr : cores::kAxiSlverr);
    run.start();
    ASSERT_TRUE(run.wait());
    const auto& writes = run.system().memory.writes();
    ASSERT_GT(writes.size(), first + burst);
    const std::uint64_t address = writes[first + burst].address;
    expect_stopped(run, kDmaWriteResponse, address);
    // The count stays at the beats before the burst that failed.
    EXPECT_EQ(run.driver().result_count(), (address - run.area()) / kBeat);
    EXPECT_GE(run.results_in_memory(), run.driver().result_count());
    expect_restart(run);
  }
  EXPECT_TRUE(run.clean());
}

/// A run that a failed write ends is over when reads are, too.
TEST_P(AxiBusError, OnAWriteWhileReadsAreOpen) {
  AxiRun run(GetParam(), 5);
  tb::AxiThrottles slow;
  slow.r = tb::Throttle::shut_after(40, 150);
  run.system().memory.set_throttles(slow);
  run.send_bspline();
  run.send_lattice(4);
  for (int packet = 0; packet < 3; ++packet) run.send_vertices(150);
  run.system().memory.fail_write(0, cores::kAxiSlverr);
  run.start();
  ASSERT_TRUE(run.wait());
  EXPECT_TRUE(run.driver().stopped());
  EXPECT_TRUE(run.system().memory.quiet());
  expect_restart(run);
  EXPECT_TRUE(run.clean());
}

/// Errors in both directions, at random moments under random waiting.
TEST_P(AxiBusError, InBothDirections) {
  for (std::uint64_t seed = 1; seed <= 6; ++seed) {
    AxiRun run(GetParam(), seed, "mixed");
    prepare(run);
    run.system().memory.fail_read(run.random().below(8), 0, cores::kAxiSlverr);
    run.system().memory.fail_write(run.random().below(2), cores::kAxiDecerr);
    run.start();
    ASSERT_TRUE(run.wait()) << seed;
    EXPECT_TRUE(run.driver().stopped()) << seed;
    const std::uint32_t bus = 1U << kDmaReadResponse | 1U << kDmaWriteResponse;
    EXPECT_NE(run.driver().take_errors().status & bus, 0U) << seed;
    expect_restart(run);
    EXPECT_TRUE(run.clean()) << seed;
  }
}

HWFFD_FOR_EACH_AXI_CONFIGURATION(AxiBusError);

}  // namespace
}  // namespace hwffd::test
