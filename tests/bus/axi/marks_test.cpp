// A core that counts and interrupts a packet: FEATURES bit 6, with pages.
#include <gtest/gtest.h>

#include "marks_core.hpp"

namespace hwffd::test {
namespace {

constexpr std::uint32_t kPacket = HWFFD_IRQ_STATE_PACKET_MASK;
constexpr std::uint32_t kDescriptor = HWFFD_IRQ_STATE_DESCRIPTOR_MASK;

class AxiMarks : public testing::TestWithParam<std::string> {
 protected:
  void load() {
    run_.send_bspline();
    lattice_ = random_lattice(run_.codec(), run_.random(), {5, 5, 5});
    run_.send(page_packet(1, lattice_));
  }
  void send_vertices(std::size_t count, bool counted, bool interrupt) {
    PageVertices how;
    how.count = counted;
    how.interrupt = interrupt;
    how.every = counted;
    run_.send(page_vertices_packet(
        1, random_vertices(run_.codec(), run_.random(), lattice_.dims, count), how));
  }

  LatticeWords lattice_;
  AxiRun run_ = marks_run(GetParam());
};
INSTANTIATE_TEST_SUITE_P(, AxiMarks, testing::Values("always", "mixed", "bernoulli"),
                         [](const auto& name) { return name.param; });

/// The unit with the count is one of the results in memory, and of RESULT_COUNT.
TEST_P(AxiMarks, CountsAreInMemory) {
  load();
  for (const std::size_t vertices : {1, 4, 9}) send_vertices(vertices, true, false);
  ASSERT_TRUE(run_.go());
  EXPECT_EQ(run_.checked(), 1U + 4 + 9 + 3);
  for (const auto& [at, count] : {std::pair{1U, 1U}, {6U, 4U}, {16U, 9U}}) {
    EXPECT_EQ(run_.result_word(at, 0), count);
    EXPECT_EQ(run_.result_word(at, 3), ~0U);
  }
  EXPECT_EQ(run_.driver().take_interrupts() & (kPacket | kDescriptor), 0U);
  EXPECT_TRUE(run_.clean());
}

/// The interrupt comes while the run goes on, when all results of that packet are in memory.
TEST_P(AxiMarks, APacketInterrupts) {
  load();
  run_.driver().enable_interrupts(kPacket);
  send_vertices(5, false, false);
  send_vertices(4, true, true);
  send_vertices(40, false, false);
  run_.start();
  for (int i = 0; i < 50'000 && !run_.system().interrupt(); ++i) run_.system().run(1);
  ASSERT_TRUE(run_.system().interrupt());
  const std::uint64_t right = run_.results_in_memory();
  EXPECT_GE(right, 10U);
  EXPECT_LT(right, run_.expected().size()) << "before the end of the run";
  EXPECT_GE(run_.driver().result_count(), 10U);
  EXPECT_EQ(run_.driver().take_interrupts() & (kPacket | kDescriptor), kPacket);
  EXPECT_FALSE(run_.system().interrupt());
  ASSERT_TRUE(run_.finish());
  EXPECT_EQ(run_.driver().take_interrupts() & (kPacket | kDescriptor), 0U) << "once";
  EXPECT_TRUE(run_.clean());
}

/// The flag of a descriptor tells of its packet, which has been read.
TEST_P(AxiMarks, ADescriptorInterrupts) {
  load();
  run_.driver().enable_interrupts(kDescriptor);
  send_vertices(3, false, false);
  // The last one's descriptor once more, with the flag.
  Driver& driver = run_.driver();
  const std::uint64_t at = run_.ring().next_descriptor() - cores::kAxiBeatBytes;
  const cores::AxiData words = run_.system().memory.beat(at);
  run_.system().memory.set_beat(at, driver.descriptor(words[0], words[2], true));
  send_vertices(60, false, false);
  run_.start();
  for (int i = 0; i < 50'000 && !run_.system().interrupt(); ++i) run_.system().run(1);
  ASSERT_TRUE(run_.system().interrupt());
  EXPECT_LE(driver.pending(), 1U);
  EXPECT_EQ(driver.take_interrupts() & (kPacket | kDescriptor), kDescriptor);
  ASSERT_TRUE(run_.finish());
  EXPECT_EQ(driver.take_interrupts() & (kPacket | kDescriptor), 0U);
  EXPECT_TRUE(run_.clean());
}

TEST_P(AxiMarks, AnyPacketsAndThenAGoodRun) {
  load();
  for (int packet = 0; packet < 12; ++packet) {
    send_vertices(1 + run_.random().below(4), packet % 2 == 0, packet % 3 == 0);
    if (packet % 4 == 0) run_.send(random_packets(run_.codec(), run_.random(), 2));
  }
  ASSERT_TRUE(run_.go());
  EXPECT_EQ(run_.driver().take_errors().status, run_.model().error_status());
  EXPECT_TRUE(run_.ends_well());
}

}  // namespace
}  // namespace hwffd::test
