// Addresses and windows in all their 64 bits: each bit decides, is held and is reported.
#include <gtest/gtest.h>

#include "dma_bench.hpp"

namespace hwffd::test {
namespace {

constexpr std::uint64_t kAll = ~std::uint64_t{0};
constexpr tb::AxiMemory::Range kEverywhere{0, kAll};
constexpr std::uint64_t kRingBytes = 2 * kBeat;  // of the smallest ring

class AddressBits : public PerDmaSize {};
HWFFD_FOR_EACH_DMA_SIZE(AddressBits);

std::uint64_t bit(unsigned k) { return std::uint64_t{1} << k; }

/// The bits from `k` on kept, those below all 0 or all 1.
std::uint64_t zeros_below(std::uint64_t address, unsigned k) { return address & ~(bit(k) - 1); }
std::uint64_t ones_below(std::uint64_t address, unsigned k) { return address | (bit(k) - 1); }

// ---- windows

/// What is asked for in a window: the code with which it ends, or 0.
using Ask = unsigned (*)(const DmaSize& size, tb::AxiMemory::Range window, std::uint64_t address);

unsigned code_of(const DmaBench& bench, const std::vector<DmaError>& errors) {
  EXPECT_EQ(bench.checker.violations(), 0u);
  return errors.empty() ? 0 : errors[0].code;
}

unsigned ask_ring(const DmaSize& size, tb::AxiMemory::Range window, std::uint64_t address) {
  DmaBench bench(size, address);
  bench.set_windows(window, {1, 0});
  bench.place_ring(address, 1);
  bench.start_ring();
  bench.run(3);
  return code_of(bench, bench.read_errors());
}

/// The ring lies at the end of the address space that the window does not cut.
unsigned ask_packet(const DmaSize& size, tb::AxiMemory::Range window, std::uint64_t address) {
  DmaBench bench(size, address);
  bench.set_windows(window, {1, 0});
  bench.place_ring(window.first == 0 ? 0 : zeros_below(kAll, 5), 1);
  bench.put_packet(address, kRingBytes / kBeat);
  bench.start_ring();
  bench.run(40);
  EXPECT_EQ(bench.packets().size(), bench.read_errors().empty() ? 2u : 0u);
  return code_of(bench, bench.read_errors());
}

unsigned ask_area(const DmaSize& size, tb::AxiMemory::Range window, std::uint64_t address) {
  DmaBench bench(size, address);
  bench.set_windows({1, 0}, window);
  bench.start_results(address, kRingBytes);
  bench.offer_results(2, 2);
  bench.run(40);
  EXPECT_EQ(bench.status.result_count, bench.write_errors().empty() ? 2u : 0u);
  return code_of(bench, bench.write_errors());
}

/// Windows in which bit `k` alone lets something in or keeps it out, since all bits below it say
/// the opposite. The bits above are those of `any`.
void expect_bit_decides(Ask ask, const DmaSize& size, unsigned k, std::uint64_t any) {
  SCOPED_TRACE(testing::Message() << "bit " << k << " of " << std::hex << any);
  const std::uint64_t aligned = zeros_below(any, 5);
  const std::uint64_t low = aligned & ~bit(k), high = aligned | bit(k);
  const std::uint64_t some = k > 5 ? low | bit(5) : low;  // below the bit not all 0
  EXPECT_EQ(ask(size, {zeros_below(high, k), kAll}, some), kOutside);
  EXPECT_EQ(ask(size, {0, zeros_below(high, k)}, some), 0u);
  EXPECT_EQ(ask(size, {0, ones_below(low, k)}, high), kOutside);
  EXPECT_EQ(ask(size, {ones_below(low, k), kAll}, zeros_below(high, k)), 0u);
}

TEST_P(AddressBits, EachDecidesInAWindow) {
  tb::Random random(21);
  for (unsigned k = 5; k < 64; ++k) {
    const std::uint64_t any = random.bits();
    expect_bit_decides(ask_ring, GetParam(), k, any);
    expect_bit_decides(ask_packet, GetParam(), k, any);
    expect_bit_decides(ask_area, GetParam(), k, any);
    ASSERT_FALSE(HasFailure());
  }
}

// ---- error addresses

/// Ring, packet and result area in a megabyte that begins at `base`.
struct Place {
  std::uint64_t base;
  std::uint64_t ring() const { return base; }
  std::uint64_t packet() const { return base + 0x40f80; }  // eight beats before a border of 4 KB
  std::uint64_t border() const { return base + 0x41000; }
  std::uint64_t area() const { return base + 0x82000; }
};

/// Pairs of places whose bases differ in every bit.
std::vector<Place> opposite_places() {
  tb::Random random(22);
  std::vector<Place> places;
  for (int pair = 0; pair < 8; ++pair) {
    const std::uint64_t any = random.bits();
    places.push_back({zeros_below(any, 20)});
    places.push_back({zeros_below(~any, 20)});
  }
  return places;
}

/// What is wrong with a transfer at a place, and what is to be reported of it.
struct Wrong {
  std::uint64_t ring;
  Descriptor descriptor;
  std::uint64_t failing;  ///< the read burst that fails there
  unsigned code;
  std::uint64_t reported;
};

void expect_read_error(const DmaSize& size, const Wrong& wrong) {
  DmaBench bench(size, wrong.ring);
  bench.memory.fail_read_at(wrong.failing, 0, cores::kAxiSlverr);
  bench.place_ring(wrong.ring, 4);
  bench.put_descriptor(wrong.descriptor);
  bench.start_ring();
  ASSERT_TRUE(bench.run_until([&] { return !bench.read_errors().empty(); }, 500));
  ASSERT_TRUE(bench.run_until_idle());
  EXPECT_TRUE(only(bench.read_errors(), wrong.code, wrong.reported));
  EXPECT_EQ(bench.faults(), "");
}

TEST_P(AddressBits, EachIsReportedOfARead) {
  for (const Place& place : opposite_places()) {
    SCOPED_TRACE(testing::Message() << "at " << std::hex << place.base);
    const std::uint64_t ring = place.ring(), packet = place.packet(), border = place.border();
    const std::uint64_t none = place.area();
    expect_read_error(GetParam(), {ring + 16, {packet, 256, 0}, none, kMisaligned, ring + 16});
    expect_read_error(GetParam(), {ring, {packet, 0, 0}, none, kZeroLength, ring});
    expect_read_error(GetParam(), {ring, {packet, 256, 1}, none, kFlags, ring});
    expect_read_error(GetParam(), {ring, {packet, 256, 0}, ring, kSlaveError, ring});
    expect_read_error(GetParam(), {ring, {packet, 256, 0}, packet, kSlaveError, packet});
    expect_read_error(GetParam(), {ring, {packet, 256, 0}, border, kSlaveError, border});
  }
}

TEST_P(AddressBits, EachIsReportedOfAWrite) {
  for (const Place& place : opposite_places()) {
    for (const bool refused : {false, true}) {
      SCOPED_TRACE(testing::Message() << "at " << std::hex << place.base);
      DmaBench bench(GetParam(), place.base);
      bench.memory.fail_write(0, cores::kAxiSlverr);
      bench.start_results(place.area(), refused ? 0 : 256);
      bench.offer_results(16, 16);
      ASSERT_TRUE(bench.run_until([&] { return !bench.write_errors().empty(); }, 500));
      bench.run(100);
      EXPECT_TRUE(only(bench.write_errors(), refused ? kZeroLength : kSlaveError, place.area()));
      EXPECT_EQ(bench.faults(), "");
    }
  }
}

// ---- addresses on the bus

// A packet and an area reach over an address that ends in a 1 and zeros, so that the next burst's
// address differs in all those bits from the one that waits.
TEST_P(AddressBits, EachIsHeldWhileItWaits) {
  constexpr std::uint64_t kBefore = 24, kBeats = 56;
  tb::Random random(23);
  for (unsigned k = 12; k < 64; ++k) {
    SCOPED_TRACE(testing::Message() << "bit " << k);
    const std::uint64_t any = random.bits();
    const std::uint64_t start = zeros_below(any | bit(k), k) - kBefore * kBeat;
    DmaBench bench(GetParam(), k);
    bench.set_bus_throttle("sparse");
    bench.set_windows(kEverywhere, {start, start + kBeats * kBeat - 1});
    bench.place_ring(zeros_below(~any, 20), 2);
    bench.put_packet(start, kBeats);
    ASSERT_TRUE(bench.run_ring());
    EXPECT_EQ(bench.packet_difference(), "");
    bench.start_results(start, kBeats * kBeat);
    bench.offer_results(kBeats, kBeats);
    ASSERT_TRUE(bench.run_until([&] { return bench.status.result_count == kBeats; }, 5000));
    EXPECT_EQ(bench.results_in_memory(start, 0, kBeats), kBeats);
    EXPECT_EQ(bench.faults(), "");
  }
}

}  // namespace
}  // namespace hwffd::test
