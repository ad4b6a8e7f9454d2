// Read data that nobody asked for is ignored, whatever it says.
#include <gtest/gtest.h>

#include <algorithm>

#include "dma_bench.hpp"

namespace hwffd::test {
namespace {

class Unasked : public PerDmaSize {};
HWFFD_FOR_EACH_DMA_SIZE(Unasked);

constexpr std::uint64_t kKinds = 8;

/// A beat of every response, last and not; nothing comes of them.
void expect_ignored(DmaBench& bench) {
  for (const auto response :
       {cores::kAxiOkay, cores::kAxiExOkay, cores::kAxiSlverr, cores::kAxiDecerr}) {
    for (const bool last : {false, true}) bench.memory.answer_unasked(response, last);
  }
  const std::size_t packets = bench.packets().size(), reads = bench.memory.reads().size();
  bench.run(40);
  EXPECT_EQ(bench.packets().size(), packets);
  EXPECT_EQ(bench.memory.reads().size(), reads);
  EXPECT_TRUE(bench.read_errors().empty());
  EXPECT_TRUE(bench.status.idle);
  bench.checker.restarted();  // no error of the engine's
}

// After reset, behind a descriptor, behind a packet, and each time the next packet is exact.
TEST_P(Unasked, ReadDataBetweenPackets) {
  DmaBench bench(GetParam(), 2);
  bench.place_ring(kRing, 4);
  expect_ignored(bench);
  bench.start_ring();
  for (std::uint64_t packet = 0; packet < 10; ++packet) {
    bench.put_packet(kPackets + packet * 0x1000, 1 + 3 * packet);
    bench.ring_doorbell();
    ASSERT_TRUE(bench.run_until_idle());
    EXPECT_EQ(bench.packet_difference(), "");
    expect_ignored(bench);
    ASSERT_FALSE(HasFailure());
  }
  EXPECT_EQ(bench.status.ring_tail, 10);
  EXPECT_EQ(bench.checker.violations(tb::AxiRule::kUnasked), 11 * kKinds);
  EXPECT_EQ(bench.checker.violations(), 11 * kKinds) << "a rule that the engine broke";
}

/// A slave that answers a fetch with more descriptors than there is room for: the rest is dropped.
TEST(RingSurplus, OfDescriptorsIsDropped) {
  const std::uint64_t room = small_dma_size().descriptors, depth = small_dma_size().depth;
  for (std::uint64_t surplus = room + 3; surplus < room + 9; ++surplus) {
    SCOPED_TRACE(testing::Message() << surplus << " more");
    DmaBench bench(small_dma_size(), 3);
    bench.packet_throttle =
        tb::Throttle::shut_after(1, 1000000);  // willing in the first clock only
    bench.put_packet(kPackets, 2 * depth);
    bench.start_ring();
    bench.run(2 * depth + 200);  // the packet waits for room, and no request is taken
    bench.memory.lengthen_read_at(bench.descriptor_address(1), surplus);
    for (std::uint64_t i = 0; i < 6; ++i) bench.put_packet(kPackets + i * 0x1000, 1);
    bench.controls.ring_head = 2;
    bench.run(100);
    bench.packet_throttle = tb::Throttle::always();
    bench.run(400);
    ASSERT_EQ(bench.packets().size(), 2 * depth + room + 2) << "one is asked for meanwhile";
    auto next = bench.expected().begin();
    for (const Beat& beat : bench.packets()) {  // those that are kept, in the order of the ring
      next = std::find(next, bench.expected().end(), beat);
      ASSERT_NE(next, bench.expected().end());
      ++next;
    }
  }
}

}  // namespace
}  // namespace hwffd::test
