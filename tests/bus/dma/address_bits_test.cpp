// Addresses and windows in all their 64 bits: each bit decides, is held and is reported.
#include <gtest/gtest.h>

#include "asking.hpp"

namespace hwffd::test {
namespace {

constexpr std::uint64_t kAll = ~std::uint64_t{0};

class AddressBits : public PerDmaSize {};
HWFFD_FOR_EACH_DMA_SIZE(AddressBits);

std::uint64_t bit(unsigned k) { return std::uint64_t{1} << k; }

/// The bits from `k` on kept, those below all 0 or all 1.
std::uint64_t zeros_below(std::uint64_t address, unsigned k) { return address & ~(bit(k) - 1); }
std::uint64_t ones_below(std::uint64_t address, unsigned k) { return address | (bit(k) - 1); }

// ---- windows

/// What is asked for in a window: the code with which it ends, or 0.
using Ask = unsigned (*)(DmaBench& bench, tb::AxiMemory::Range window, std::uint64_t address);

const Ask kAsks[] = {
    [](DmaBench& bench, tb::AxiMemory::Range window, std::uint64_t ring) {
      return ask_read(bench, window, ring, 1, ring, 2);
    },
    // A packet, whose ring lies at the end of the address space that the window does not cut.
    [](DmaBench& bench, tb::AxiMemory::Range window, std::uint64_t packet) {
      const std::uint64_t ring = window.first == 0 ? 0 : zeros_below(kAll, 5);
      return ask_read(bench, window, ring, 1, packet, 2);
    },
    [](DmaBench& bench, tb::AxiMemory::Range window, std::uint64_t area) {
      return ask_area(bench, window, area, 2 * kBeat, 2);
    }};

/// Windows in which bit `k` alone lets something in or keeps it out, since all bits below it say
/// the opposite. The bits above are those of `any`.
void expect_bit_decides(Ask ask, const DmaSize& size, unsigned k, std::uint64_t any) {
  SCOPED_TRACE(testing::Message() << "bit " << k << " of " << std::hex << any);
  const std::uint64_t aligned = zeros_below(any, 5);
  const std::uint64_t low = aligned & ~bit(k), high = aligned | bit(k);
  const std::uint64_t some = k > 5 ? low | bit(5) : low;  // below the bit not all 0
  const auto code = [&](tb::AxiMemory::Range window, std::uint64_t address) {
    DmaBench bench(size, address);
    return ask(bench, window, address);
  };
  EXPECT_EQ(code({zeros_below(high, k), kAll}, some), kOutside);
  EXPECT_EQ(code({0, zeros_below(high, k)}, some), 0u);
  EXPECT_EQ(code({0, ones_below(low, k)}, high), kOutside);
  EXPECT_EQ(code({ones_below(low, k), kAll}, zeros_below(high, k)), 0u);
}

TEST_P(AddressBits, EachDecidesInAWindow) {
  tb::Random random(21);
  for (unsigned k = 5; k < 64; ++k) {
    const std::uint64_t any = random.bits();
    for (const Ask ask : kAsks) {
      for (const std::uint64_t base : {any, ~any}) expect_bit_decides(ask, GetParam(), k, base);
    }
    ASSERT_FALSE(HasFailure());
  }
}

// ---- error addresses

/// Pairs of megabytes for ring, packet and result area whose bases differ in every bit.
std::vector<std::uint64_t> opposite_places() {
  tb::Random random(22);
  std::vector<std::uint64_t> places;
  for (int pair = 0; pair < 8; ++pair) {
    const std::uint64_t any = random.bits();
    for (const std::uint64_t base : {any, ~any}) places.push_back(zeros_below(base, 20));
  }
  return places;
}
constexpr std::uint64_t kAreaPlace = 0x82000;

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
  ASSERT_TRUE(bench.run_until_error(500));
  ASSERT_TRUE(bench.run_until_idle());
  EXPECT_TRUE(only(bench.read_errors(), wrong.code, wrong.reported));
  EXPECT_EQ(bench.faults(), "");
}

TEST_P(AddressBits, EachIsReportedOfARead) {
  for (const std::uint64_t ring : opposite_places()) {
    SCOPED_TRACE(testing::Message() << "at " << std::hex << ring);
    const std::uint64_t border = ring + 0x41000, packet = border - 8 * kBeat;
    const std::uint64_t none = ring + kAreaPlace;
    expect_read_error(GetParam(), {ring + 16, {packet, 256, 0}, none, kMisaligned, ring + 16});
    expect_read_error(GetParam(), {ring, {packet, 0, 0}, none, kZeroLength, ring});
    expect_read_error(GetParam(), {ring, {packet, 256, 1}, none, kFlags, ring});
    expect_read_error(GetParam(), {ring, {packet, 256, 0}, ring, kSlaveError, ring});
    expect_read_error(GetParam(), {ring, {packet, 256, 0}, packet, kSlaveError, packet});
    expect_read_error(GetParam(), {ring, {packet, 256, 0}, border, kSlaveError, border});
  }
}

void expect_write_error(const DmaSize& size, std::uint64_t area, std::uint32_t bytes,
                        unsigned code) {
  SCOPED_TRACE(testing::Message() << "at " << std::hex << area);
  DmaBench bench(size, area);
  bench.memory.fail_write(0, cores::kAxiSlverr);
  bench.start_results(area, bytes);
  bench.offer_results(16, 16);
  ASSERT_TRUE(bench.run_until_error(500));
  bench.run(100);
  EXPECT_TRUE(only(bench.write_errors(), code, area));
  EXPECT_EQ(bench.faults(), "");
}

TEST_P(AddressBits, EachIsReportedOfAWrite) {
  for (const std::uint64_t place : opposite_places()) {
    const std::uint64_t area = place + kAreaPlace;
    for (const std::uint64_t at : {area, area + 0x550, area + 0xAA0}) {
      expect_write_error(GetParam(), at, 256, kSlaveError);
    }
    expect_write_error(GetParam(), area, 0, kZeroLength);
    for (const unsigned low : {1, 2, 4, 8, 5, 10, 15}) {
      expect_write_error(GetParam(), area + low, 256, kMisaligned);
      expect_write_error(GetParam(), area, 256 + low, kMisaligned);
    }
  }
}

// Bits that are 1 together.
TEST_P(AddressBits, AnyAreReported) {
  tb::Random random(25);
  for (int i = 0; i < 40; ++i) {
    const std::uint64_t any = random.bits(), ring = zeros_below(~any, 20);
    const std::uint64_t packet = zeros_below(any, 4);
    const Descriptor descriptor{packet, 16, 0};
    expect_read_error(GetParam(), {ring, descriptor, packet, kSlaveError, packet});
    expect_write_error(GetParam(), packet, 256, kSlaveError);
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
    EXPECT_TRUE(bench.reads(1));
    bench.start_results(start, kBeats * kBeat);
    bench.offer_results(kBeats, kBeats);
    ASSERT_TRUE(bench.writes(start, 0, kBeats));
  }
}

}  // namespace
}  // namespace hwffd::test
