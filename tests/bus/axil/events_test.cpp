// The errors of the core and of the DMA as events of the registers: bits, places, addresses.
#include <gtest/gtest.h>

#include <cstdint>

#include "Vbus_events.h"
#include "hwffd/registers.h"
#include "hwffd/tb/sim.hpp"

namespace hwffd::test {
namespace {

struct Raised {
  std::uint32_t events, packet, beat;
  bool located;
  std::uint64_t address;
};

class EventBench {
 public:
  EventBench() : sim_(1) {
    auto& dut = sim_.dut();
    dut.rst = 1;
    dut.core_packet_i = 11;
    dut.core_beat_i = 22;
    dut.read_error_address_i = 0x1'0000'0000;
    dut.write_error_address_i = 0x2'0000'0000;
    dut.result_overflow_i = 0;
    sim_.tick();
    dut.rst = 0;
  }
  /// Code 0: none.
  Raised raise(unsigned core, unsigned read, unsigned write, bool overflow = false,
               unsigned timeout = 0) {
    auto& dut = sim_.dut();
    dut.core_event_i = static_cast<SData>(core);
    dut.read_error_i = read != 0;
    dut.read_error_code_i = static_cast<CData>(read);
    dut.write_error_i = write != 0;
    dut.write_error_code_i = static_cast<CData>(write);
    dut.result_overflow_i = overflow;
    dut.timeout_i = static_cast<CData>(timeout);
    dut.eval();
    const Raised raised{dut.error_event_o, dut.error_packet_o, dut.error_beat_o,
                        dut.error_address_valid_o != 0, dut.error_address_o};
    sim_.tick();
    return raised;
  }

 private:
  tb::Sim<Vbus_events> sim_;
};

/// What a code of the DMA is called in the registers.
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

TEST(Events, TheCoresKeepTheirPlaces) {
  EventBench bench;
  for (unsigned bit = 0; bit < 10; ++bit) {
    const Raised raised = bench.raise(1u << bit, 0, 0);
    EXPECT_EQ(raised.events, 1u << bit);
    EXPECT_EQ(raised.packet, 11u);
    EXPECT_EQ(raised.beat, 22u);
    EXPECT_FALSE(raised.located);
  }
  EXPECT_EQ(HWFFD_ERROR_STATUS_LATTICE_SIZE_SHIFT, 5);
  EXPECT_EQ(HWFFD_ERROR_STATUS_SATURATED_SHIFT, 9);
  EXPECT_EQ(bench.raise(0, 0, 0).events, 0u);
}

TEST(Events, TheDmasHaveTheirNamesAndTheAddressOfTheLowest) {
  EventBench bench;
  for (unsigned read = 0; read <= 8; ++read) {
    for (unsigned write = 0; write < 8; ++write) {
      const Raised raised = bench.raise(0, read, write);
      const std::uint32_t of_read = named(read, true);
      const std::uint32_t of_write = named(write, false);
      EXPECT_EQ(raised.events, of_read | of_write);
      EXPECT_EQ(raised.packet, 0u);
      EXPECT_EQ(raised.beat, 0u);
      const bool any = read != 0 || write != 0;
      const bool by_read = read != 0 && (write == 0 || of_read <= of_write);
      EXPECT_EQ(raised.located, any);
      if (any) {
        EXPECT_EQ(raised.address, by_read ? 0x1'0000'0000 : 0x2'0000'0000) << read << " " << write;
      }
      const Raised with_core = bench.raise(0x200, read, write);
      EXPECT_EQ(with_core.events, of_read | of_write | 0x200);
      EXPECT_EQ(with_core.packet, 11u);
      EXPECT_EQ(with_core.located, any);
    }
  }
}

TEST(Events, EachChannelThatIsLateHasItsBit) {
  EventBench bench;
  const std::uint32_t masks[] = {
      HWFFD_ERROR_STATUS_TIMEOUT_AR_MASK, HWFFD_ERROR_STATUS_TIMEOUT_R_MASK,
      HWFFD_ERROR_STATUS_TIMEOUT_AW_MASK, HWFFD_ERROR_STATUS_TIMEOUT_W_MASK,
      HWFFD_ERROR_STATUS_TIMEOUT_B_MASK};
  for (unsigned channel = 0; channel < 5; ++channel) {
    const Raised raised = bench.raise(0, 0, 0, false, 1u << channel);
    EXPECT_EQ(raised.events, masks[channel]);
    EXPECT_FALSE(raised.located);
  }
}

TEST(Events, AFullAreaIsOneEvent) {
  EventBench bench;
  for (unsigned round = 0; round < 2; ++round) {
    EXPECT_EQ(bench.raise(0, 0, 0, true).events, HWFFD_ERROR_STATUS_RESULT_OVERFLOW_MASK);
    for (unsigned i = 0; i < 5; ++i) EXPECT_EQ(bench.raise(0, 0, 0, true).events, 0u);
    EXPECT_EQ(bench.raise(0, 0, 0, false).events, 0u);
  }
}

}  // namespace
}  // namespace hwffd::test
