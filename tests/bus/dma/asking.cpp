#include "asking.hpp"

namespace hwffd::test {

unsigned ask_read(DmaBench& bench, tb::AxiMemory::Range window, std::uint64_t ring,
                  unsigned entries_log2, std::uint64_t packet, std::uint64_t beats) {
  bench.set_windows(window, kNowhere);
  bench.place_ring(ring, entries_log2);
  bench.put_packet(packet, beats);
  bench.start_ring();
  bench.run(60);
  EXPECT_EQ(bench.checker.violations(), 0u);
  const bool good = bench.read_errors().empty();
  EXPECT_EQ(bench.packets().size(), good ? beats : 0);
  if (good) return 0;
  EXPECT_EQ(bench.read_errors()[0].address, ring);  // that of its first entry, too
  EXPECT_FALSE(bench.status.ring_running);
  return bench.read_errors()[0].code;
}

unsigned ask_area(DmaBench& bench, tb::AxiMemory::Range window, std::uint64_t base,
                  std::uint32_t bytes, std::uint64_t results) {
  constexpr std::uint64_t kNext = 0x5000;
  bench.set_windows(kNowhere, window);
  bench.start_results(base, bytes);
  bench.offer_results(results, 1);
  bench.run(60);
  EXPECT_EQ(bench.faults(), "");
  const bool good = bench.write_errors().empty();
  const std::uint64_t at = good ? base : kNext;
  const unsigned code = good ? 0 : bench.write_errors()[0].code;
  if (!good) {
    EXPECT_TRUE(only(bench.write_errors(), code, base));
    EXPECT_TRUE(bench.memory.writes().empty());
    EXPECT_FALSE(bench.status.result_running);
    bench.set_windows(kNowhere, kEverywhere);
    bench.start_results(kNext, static_cast<std::uint32_t>(results * kBeat));
  }
  EXPECT_TRUE(bench.writes(at, 0, results));
  EXPECT_EQ(bench.memory.changed_outside({{at, at + results * kBeat - 1}}), 0u);
  return code;
}

Asked asked_for(const DmaBench& bench) {
  Asked asked;
  for (const auto& read : bench.memory.reads()) {
    const bool packet = read.address >= kPackets;
    asked.descriptors += packet ? 0 : 1;
    asked.beats += packet ? read.beats : 0;
  }
  return asked;
}

}  // namespace hwffd::test
