// Two faults close together: the first one is reported, and stops what comes behind it.
#include <gtest/gtest.h>

#include <algorithm>

#include "dma_bench.hpp"

namespace hwffd::test {
namespace {

class TwoFaults : public PerDmaSize {};
HWFFD_FOR_EACH_DMA_SIZE(TwoFaults);

/// A packet of `beats`, then two bad descriptors; the first one is mended before the second start.
void expect_in_order(const DmaSize& size, const BadDescriptor& first, const BadDescriptor& second,
                     std::uint64_t beats, std::uint64_t latency) {
  SCOPED_TRACE(testing::Message() << "codes " << first.code << ", " << second.code << " behind "
                                  << beats << " beats, latency " << latency);
  DmaBench bench(size, latency);
  bench.memory.set_latency({latency, latency});
  bench.set_windows(kReadable, kNowhere);
  bench.put_packet(kPackets, beats);
  bench.put_descriptor(first.descriptor);
  bench.put_descriptor(second.descriptor);
  EXPECT_TRUE(bench.refuses(1, first.code));
  bench.set_software_head(1);
  bench.put_packet(kPackets + 0x1000, beats);
  bench.set_software_head(3);
  EXPECT_TRUE(bench.refuses(2, second.code));
  EXPECT_TRUE(bench.exact());
}

TEST_P(TwoFaults, BadDescriptorsAreReportedInTheirOrder) {
  for (const BadDescriptor& first : bad_descriptors()) {
    for (const BadDescriptor& second : bad_descriptors()) {
      for (const std::uint64_t beats : {1, 9}) {
        for (const std::uint64_t latency : {1, 2, 3, 7}) {
          expect_in_order(GetParam(), first, second, beats, latency);
          ASSERT_FALSE(HasFailure());
        }
      }
    }
  }
}

/// What a bad descriptor and a bus error in the packet before it led to.
struct Meeting {
  bool bus_first;
  std::uint64_t apart;  ///< clocks between both reports, 0 where there was one
};

/// Beat `failing` of a packet fails while the bad descriptor behind it is looked at. The packet has
/// three bursts at least, so that its first beats come while its last address still waits.
Meeting meet(const DmaSize& size, const BadDescriptor& bad, std::uint64_t failing,
             std::uint64_t latency) {
  constexpr std::uint64_t kStart = kPackets + 0x1000 - 8 * kBeat;
  DmaBench bench(size, latency);
  bench.memory.set_latency({latency, latency});
  bench.set_windows(kReadable, kNowhere);
  bench.put_packet(kStart, 16 + size.max_burst);
  bench.put_descriptor(bad.descriptor);
  const std::uint64_t beat = kStart + failing * kBeat;
  const std::uint64_t failed = std::max(kStart, beat - beat % (size.max_burst * kBeat));
  bench.memory.fail_read_at(failed, (beat - failed) / kBeat, cores::kAxiSlverr);
  bench.start_ring();
  EXPECT_TRUE(bench.run_until_error(500));
  const std::uint64_t first = bench.cycle();
  const bool bus_first = bench.read_errors()[0].code == kSlaveError;
  const std::size_t reports = bus_first ? 1 : 2;
  EXPECT_TRUE(bench.run_until([&] { return bench.read_errors().size() >= reports; }, 500));
  const std::uint64_t apart = bench.cycle() - first;
  EXPECT_TRUE(bench.run_until_idle());
  bench.run(10);

  const std::vector<DmaError>& errors = bench.read_errors();
  EXPECT_EQ(errors.size(), reports);  // a packet that had begun is read to its end
  EXPECT_EQ(errors[reports - 1].code, kSlaveError);
  EXPECT_EQ(errors[reports - 1].address, failed);
  if (!bus_first) {
    EXPECT_EQ(errors[0].code, bad.code);
    EXPECT_EQ(errors[0].address, bench.descriptor_address(1));
  }
  EXPECT_EQ(bench.packets().size(), failing / bench.blocks() * bench.blocks());
  EXPECT_EQ(bench.status.ring_tail, 0);
  EXPECT_FALSE(bench.status.ring_running);
  EXPECT_EQ(bench.faults(), "");
  return {bus_first, apart};
}

// The failing beat moves by a clock each, from before the refusal to behind it.
TEST_P(TwoFaults, ABusErrorAroundARefusal) {
  for (const BadDescriptor& bad : bad_descriptors()) {
    unsigned bus_first = 0, next_clock = 0;
    for (std::uint64_t latency = 1; latency <= 8; ++latency) {
      for (std::uint64_t failing = 0; failing < 20; ++failing) {
        SCOPED_TRACE(testing::Message()
                     << "code " << bad.code << ", beat " << failing << ", latency " << latency);
        const Meeting met = meet(GetParam(), bad, failing, latency);
        ASSERT_FALSE(HasFailure());
        bus_first += met.bus_first ? 1 : 0;
        next_clock += !met.bus_first && met.apart == 1 ? 1 : 0;
      }
    }
    EXPECT_GT(bus_first, 0u) << "code " << bad.code;
    // Where a FIFO holds no more than two bursts, the last address waits until the beats before it
    // have left, and no data is on its way.
    if (GetParam().depth > 2 * GetParam().max_burst) {
      EXPECT_GT(next_clock, 0u) << "code " << bad.code << ": no bus error just behind the refusal";
    }
  }
}

}  // namespace
}  // namespace hwffd::test
