// What is read while nobody takes packets: as many beats as there is room for, and descriptors
// ahead.
#include <gtest/gtest.h>

#include "asking.hpp"

namespace hwffd::test {
namespace {

constexpr std::uint64_t kNoEnd = 1000000;

class StalledPackets : public PerDmaSize {};
HWFFD_FOR_EACH_DMA_SIZE(StalledPackets);

TEST_P(StalledPackets, AreReadWhileThereIsRoomForTheWholeBurst) {
  const std::uint64_t depth = GetParam().depth;
  const std::uint64_t blocks = DmaBench(GetParam(), 0).blocks();
  for (std::uint64_t room = blocks; room <= 4; room += blocks) {
    for (std::uint64_t beats = blocks; beats <= 4; beats += blocks) {
      SCOPED_TRACE(testing::Message() << beats << " beats where there is room for " << room);
      DmaBench bench(GetParam(), room);
      bench.packet_throttle = tb::Throttle::shut_after(1, kNoEnd);
      bench.put_packet(kPackets, depth - room);
      bench.put_packet(kPackets + 0x4000, beats);
      bench.start_ring();
      bench.run(4 * depth + 200);
      EXPECT_EQ(asked_for(bench).beats, depth - room + (beats <= room ? beats : 0));
      bench.packet_throttle = tb::Throttle::always();
      ASSERT_TRUE(bench.run_until_idle());
      EXPECT_TRUE(bench.exact(2));
    }
  }
}

// However many packets the ring had before; the one that fills the queue has its descriptor, too.
TEST_P(StalledPackets, HaveDescriptorsFetchedAhead) {
  const std::uint64_t depth = GetParam().depth;
  for (std::uint64_t taken = 0; taken < 6; ++taken) {
    DmaBench bench(GetParam(), taken);
    bench.place_ring(kRing, 4);
    bench.put_packets(taken, 3);
    ASSERT_TRUE(bench.run_ring());
    bench.packet_throttle = tb::Throttle::shut_after(1, kNoEnd);
    for (std::uint64_t i = taken; i < 15; ++i) bench.put_packet(kPackets + i * 0x4000, depth);
    bench.ring_doorbell();
    bench.run(4 * depth + 400);
    EXPECT_EQ(asked_for(bench).descriptors, taken + 1 + GetParam().descriptors)
        << taken << " taken";
    bench.packet_throttle = tb::Throttle::always();
    ASSERT_TRUE(bench.run_until_idle());
    EXPECT_TRUE(bench.exact(15));
  }
}

}  // namespace
}  // namespace hwffd::test
