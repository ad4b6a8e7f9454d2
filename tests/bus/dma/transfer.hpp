#pragma once

#include <utility>

#include "dma_bench.hpp"

namespace hwffd::test {

/// Both halves of the engine at work: packets by address and beats, results into an area.
struct Transfer {
  std::vector<std::pair<std::uint64_t, std::uint64_t>> packets;
  std::uint64_t results;

  void start(DmaBench& bench, std::uint64_t area) const {
    bench.place_ring(kRing, 3);
    for (const auto& [address, beats] : packets) bench.put_packet(address, beats);
    bench.offer_results(results, 7);
    bench.place_area(area, static_cast<std::uint32_t>(results * kBeat));
    bench.start_ring();
  }
  bool done(const DmaBench& bench) const {
    return bench.status.idle && bench.results_waiting() == 0 &&
           bench.status.result_count == results &&
           bench.packets().size() == bench.expected().size();
  }
  /// After a soft reset: another one is exact.
  void expect_next(DmaBench& bench) const {
    bench.forget_packets();
    bench.forget_results();
    start(bench, kArea + 0x1000);
    EXPECT_TRUE(bench.run_until([&] { return done(bench); }, 5000));
    EXPECT_TRUE(bench.exact());
    EXPECT_EQ(bench.results_in_memory(kArea + 0x1000, 0, results), results);
  }
};

}  // namespace hwffd::test
