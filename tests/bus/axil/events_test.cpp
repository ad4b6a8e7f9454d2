// The errors of the core and of the DMA as events of the registers: bits, places, addresses; by
// their names in the registers, under all errors at once and alone.
#include "hwffd/stream/events.hpp"

#include <gtest/gtest.h>

#include <cstdint>
#include <set>
#include <type_traits>

#include "Vbus_events.h"
#include "hwffd/registers.h"
#include "hwffd/tb/random.hpp"
#include "hwffd/tb/sim.hpp"

namespace hwffd::test {
namespace {

/// What a code of the DMA is called in the registers; 0 is none.
std::uint32_t named(unsigned code, bool read) {
  const std::uint32_t response =
      read ? HWFFD_ERROR_STATUS_DMA_READ_RESPONSE_MASK : HWFFD_ERROR_STATUS_DMA_WRITE_RESPONSE_MASK;
  const std::uint32_t masks[] = {0,
                                 HWFFD_ERROR_STATUS_DMA_ZERO_MASK,
                                 HWFFD_ERROR_STATUS_DMA_MISALIGNED_MASK,
                                 HWFFD_ERROR_STATUS_DMA_WRAP_MASK,
                                 HWFFD_ERROR_STATUS_DMA_WINDOW_MASK,
                                 HWFFD_ERROR_STATUS_DMA_DESCRIPTOR_MASK,
                                 response,
                                 response,
                                 HWFFD_ERROR_STATUS_DMA_RING_MASK};
  return masks[code];
}

constexpr std::uint32_t kLate[] = {
    HWFFD_ERROR_STATUS_TIMEOUT_AR_MASK, HWFFD_ERROR_STATUS_TIMEOUT_R_MASK,
    HWFFD_ERROR_STATUS_TIMEOUT_AW_MASK, HWFFD_ERROR_STATUS_TIMEOUT_W_MASK,
    HWFFD_ERROR_STATUS_TIMEOUT_B_MASK};

/// Errors of the two halves of the DMA in a clock; 0 is none.
struct DmaErrors {
  unsigned read = 0, write = 0;
  std::uint64_t read_address = 0, write_address = 0;

  static DmaErrors any(tb::Random& random) {
    DmaErrors errors;
    if (random.chance(0.5)) errors.read = static_cast<unsigned>(random.between(1, 8));
    if (random.chance(0.5)) errors.write = static_cast<unsigned>(random.between(1, 7));
    errors.read_address = random.bits();
    errors.write_address = random.bits();
    return errors;
  }

  /// Codes without an error are anything.
  void drive(Vbus_events& dut, tb::Random& random) const {
    dut.read_error_i = read != 0;
    dut.read_error_code_i = static_cast<CData>(read != 0 ? read : random.below(9));
    dut.read_error_address_i = read_address;
    dut.write_error_i = write != 0;
    dut.write_error_code_i = static_cast<CData>(write != 0 ? write : random.below(8));
    dut.write_error_address_i = write_address;
  }
};

TEST(Events, HaveTheirNamesAndThePlaceOfTheLowest) {
  tb::Random random(tb::seed_from_environment(1));
  tb::Sim<Vbus_events> sim(1);
  Vbus_events& dut = sim.dut();
  dut.rst = 1;
  dut.result_overflow_i = 0;
  sim.tick();
  dut.rst = 0;
  bool was_full = false;
  std::uint32_t core = 0, core_packet = 0, core_beat = 0;  // of the clock before
  DmaErrors dma;                                           // of the clock before
  std::set<std::uint32_t> alone;
  constexpr std::uint32_t kAny = (1U << kStreamEvents) - 1;
  for (int clock = 0; clock < 200'000; ++clock) {
    const DmaErrors next_dma = DmaErrors::any(random);
    const auto next_core = static_cast<std::uint32_t>(
        random.chance(0.5)
            ? 0
            : random.pick({1U << random.below(kStreamEvents), random.word() & kAny}));
    const unsigned late = random.chance(0.5) ? 0 : random.word() & 31;
    const bool full = random.chance(was_full ? 0.8 : 0.2);
    dut.core_event_i = static_cast<std::decay_t<decltype(dut.core_event_i)>>(next_core);
    dut.core_packet_i = random.word();
    dut.core_beat_i = random.word();
    next_dma.drive(dut, random);
    dut.result_overflow_i = full;
    dut.timeout_i = static_cast<CData>(late);
    sim.tick();

    const std::uint32_t of_read = named(dma.read, true), of_write = named(dma.write, false);
    // Of the core the first, then those of the DMA, then the others of the core.
    constexpr std::uint32_t kFirst = (2U << event::kSaturated) - 1;
    const std::uint32_t of_core = (core & kFirst) | core >> (event::kSaturated + 1)
                                                                << event::kPagePoints;
    std::uint32_t events = of_core | of_read | of_write;
    for (unsigned channel = 0; channel < 5; ++channel) {
      if ((late >> channel & 1) != 0) events |= kLate[channel];
    }
    if (full && !was_full) events |= HWFFD_ERROR_STATUS_RESULT_OVERFLOW_MASK;  // once an area
    ASSERT_EQ(dut.error_event_o, events) << "clock " << clock;
    ASSERT_EQ(dut.error_any_o != 0, events != 0) << "clock " << clock;
    const std::uint32_t lowest = events & (~events + 1);
    ASSERT_EQ(dut.error_packet_o, (lowest & of_core) != 0 ? core_packet : 0) << "clock " << clock;
    ASSERT_EQ(dut.error_beat_o, (lowest & of_core) != 0 ? core_beat : 0) << "clock " << clock;
    const bool any = dma.read != 0 || dma.write != 0;
    ASSERT_EQ(dut.error_address_valid_o != 0, any);
    const bool by_read = dma.read != 0 && (dma.write == 0 || of_read <= of_write);
    if (any) {
      ASSERT_EQ(dut.error_address_o, by_read ? dma.read_address : dma.write_address)
          << "codes " << dma.read << " and " << dma.write;
    }
    if ((events & (events - 1)) == 0) alone.insert(events);
    was_full = full;
    core = next_core;
    dma = next_dma;
    core_packet = dut.core_packet_i;
    core_beat = dut.core_beat_i;
  }
  EXPECT_EQ(alone.size(), kErrors + 1U) << "none, and each of them";
  EXPECT_EQ(HWFFD_ERROR_STATUS_LATTICE_SIZE_SHIFT, 5);
  EXPECT_EQ(HWFFD_ERROR_STATUS_SATURATED_SHIFT, 9);
}

}  // namespace
}  // namespace hwffd::test
