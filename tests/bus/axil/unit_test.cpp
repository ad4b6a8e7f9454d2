// The register block without a bus. Counter and error record where they are full: they never are in
// a test that starts from reset, so here they start from Verilator's random state, with a seed that
// is near the edge.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <bitset>
#include <memory>

#include "Vbus_counter.h"
#include "Vbus_errors.h"
#include "Vbus_registers.h"
#include "Vbus_waits.h"
#include "hwffd/registers.h"
#include "hwffd/stream/events.hpp"
#include "hwffd/tb/random.hpp"
#include "hwffd/tb/sim.hpp"

namespace hwffd::test {
namespace {

constexpr std::uint64_t kSeeds = 20'000;

/// A unit that was never reset, whose count is at most `distance` below its 32-bit edge.
template <class VDut, class Low>
std::unique_ptr<tb::Sim<VDut>> near_the_edge(Low low, std::uint32_t distance) {
  for (std::uint64_t seed = 0; seed < kSeeds; ++seed) {
    auto sim = std::make_unique<tb::Sim<VDut>>(seed);
    sim->dut().rst = 0;
    sim->dut().clear_i = 0;
    sim->dut().eval();
    if (low(sim->dut()) > ~distance) return sim;
  }
  return nullptr;
}

TEST(Counter, CarriesIntoItsHighHalfAndLatchesIt) {
  auto sim = near_the_edge<Vbus_counter>([](auto& dut) { return dut.low_o; }, 1u << 20);
  ASSERT_NE(sim, nullptr);
  auto& dut = sim->dut();
  dut.event_i = dut.second_i = 0;
  dut.latch_i = 1;
  sim->tick();  // and an event of before is counted
  sim->tick();
  const std::uint32_t high = dut.high_o;
  dut.latch_i = 0;
  dut.event_i = 1;
  while (dut.low_o != ~0u) sim->tick();
  EXPECT_EQ(dut.high_o, high);
  dut.latch_i = 1;  // the low half is read in the last clock before the carry
  sim->tick();
  dut.latch_i = 0;
  EXPECT_EQ(dut.low_o, 0u);
  EXPECT_EQ(dut.high_o, high);  // as it was when the low half was read
  sim->tick();
  EXPECT_EQ(dut.low_o, 1u);
  EXPECT_EQ(dut.high_o, high);
  dut.latch_i = 1;
  sim->tick();
  EXPECT_EQ(dut.high_o, high + 1);
  dut.latch_i = 0;
  dut.clear_i = 1;  // with an event in the same clock
  sim->tick();
  EXPECT_EQ(dut.low_o, 0u);
  EXPECT_EQ(dut.high_o, high + 1);
  dut.event_i = 0;
  dut.clear_i = 0;
  sim->tick();
  EXPECT_EQ(dut.low_o, 1u);
  sim->tick();
  EXPECT_EQ(dut.low_o, 1u);
  dut.clear_i = 1;
  sim->tick();
  EXPECT_EQ(dut.low_o, 0u);
  dut.clear_i = 0;
  sim->tick();
  EXPECT_EQ(dut.low_o, 0u);
}

// From states that a run does not reach. They are read from the counter, so each bit must have been
// 0 and 1.
TEST(Counter, EqualsTheModelFromAnyState) {
  tb::Random random(1);
  std::uint64_t ones = 0, zeros = 0;
  for (std::uint64_t seed = 0; seed < 400; ++seed) {
    tb::Sim<Vbus_counter> sim(seed);
    auto& dut = sim.dut();
    dut.rst = 0;
    dut.event_i = dut.second_i = 0;
    dut.clear_i = 0;
    dut.latch_i = 1;
    sim.tick();  // an event of before is counted
    sim.tick();
    std::uint64_t count = std::uint64_t{dut.high_o} << 32 | dut.low_o;
    std::uint64_t latched = count;
    ones |= count;
    zeros |= ~count;
    unsigned events = 0;
    for (int clock = 0; clock < 50; ++clock) {
      dut.event_i = random.chance(0.5) ? 1 : 0;
      dut.second_i = random.chance(0.3) ? 1 : 0;
      dut.latch_i = random.chance(0.3) ? 1 : 0;
      dut.clear_i = random.chance(0.03) ? 1 : 0;
      dut.rst = random.chance(0.03) ? 1 : 0;
      const bool cleared = dut.rst != 0 || dut.clear_i != 0;
      latched = dut.rst != 0 ? 0 : dut.latch_i != 0 ? count : latched;
      count = cleared ? 0 : count + events;
      events = dut.rst != 0 ? 0U : 0U + dut.event_i + dut.second_i;
      sim.tick();
      ASSERT_EQ(dut.low_o, static_cast<std::uint32_t>(count)) << seed << ", clock " << clock;
      ASSERT_EQ(dut.high_o, static_cast<std::uint32_t>(latched >> 32))
          << seed << ", clock " << clock;
    }
  }
  EXPECT_EQ(ones, ~std::uint64_t{0});
  EXPECT_EQ(zeros, ~std::uint64_t{0});
}

/// What ffd_bus_errors keeps.
struct Record {
  std::uint32_t count = 0, code = 0, packet = 0, beat = 0;
  std::uint64_t address = 0;
  bool address_held = false;
  std::uint32_t events = 0;  // of the clock before, not yet counted

  void tick(const Vbus_errors& dut) {
    const bool record = dut.held_i == 0 && dut.any_i != 0;
    const bool locate = dut.address_valid_i != 0 && !(dut.held_i != 0 && address_held);
    const std::uint64_t sum = std::uint64_t{count} + events;
    count = dut.rst != 0 || dut.clear_i != 0
                ? 0
                : static_cast<std::uint32_t>(std::min<std::uint64_t>(sum, ~std::uint32_t{0}));
    events = dut.rst != 0 ? 0 : std::bitset<32>(dut.event_i).count();
    if (dut.rst != 0) {
      code = packet = beat = 0;
      address = 0;
      address_held = false;
      return;
    }
    if (record) {
      code = 0;
      while (code < 31 && (dut.event_i >> code & 1U) == 0) ++code;
      packet = dut.packet_i;
      beat = dut.beat_i;
    }
    if (record || locate) {
      address = dut.address_valid_i != 0 ? dut.address_i : 0;
      address_held = dut.address_valid_i != 0;
    }
  }
};

TEST(ErrorRecord, EqualsTheModelInEveryClock) {
  tb::Sim<Vbus_errors> sim(1);
  auto& dut = sim.dut();
  tb::Random random(1);
  Record record;
  for (int clock = 0; clock < 20'000; ++clock) {
    dut.rst = clock < 2 || random.chance(0.002) ? 1 : 0;
    dut.event_i =
        random.chance(0.5) ? 1U << random.below(16) | (random.word() & random.word()) % 65536 : 0;
    dut.any_i = dut.event_i != 0 ? 1 : 0;
    dut.packet_i = random.word();
    dut.beat_i = random.word();
    dut.address_valid_i = random.chance(0.4) ? 1 : 0;
    dut.address_i = std::uint64_t{random.word()} << 32 | random.word();
    dut.held_i = random.chance(0.4) ? 1 : 0;
    dut.clear_i = random.chance(0.01) ? 1 : 0;
    record.tick(dut);
    sim.tick();
    if (clock < 2) continue;
    ASSERT_EQ(dut.count_o, record.count) << "clock " << clock;
    ASSERT_EQ(dut.code_o, record.code) << "clock " << clock;
    ASSERT_EQ(dut.packet_o, record.packet) << "clock " << clock;
    ASSERT_EQ(dut.beat_o, record.beat) << "clock " << clock;
    ASSERT_EQ(dut.address_o, record.address) << "clock " << clock;
  }
}

TEST(ErrorRecord, CountStaysAtItsLargest) {
  auto sim = near_the_edge<Vbus_errors>([](auto& dut) { return dut.count_o; }, 1u << 24);
  ASSERT_NE(sim, nullptr);
  auto& dut = sim->dut();
  dut.held_i = 1;
  dut.event_i = 0xFFFF;
  dut.address_valid_i = 0;
  sim->tick();  // and events of before are counted
  while (dut.count_o < ~0u - 16) {
    const std::uint32_t before = dut.count_o;
    sim->tick();
    ASSERT_EQ(dut.count_o, before + 16);
  }
  for (unsigned i = 0; i < 20; ++i) sim->tick();
  EXPECT_EQ(dut.count_o, ~0u);
  dut.event_i = 1;
  sim->tick();
  sim->tick();
  EXPECT_EQ(dut.count_o, ~0u);
  dut.event_i = 0x0103;
  dut.clear_i = 1;
  sim->tick();
  EXPECT_EQ(dut.count_o, 0u);
  dut.event_i = 0;
  dut.clear_i = 0;
  sim->tick();
  EXPECT_EQ(dut.count_o, 3u);
  sim->tick();
  EXPECT_EQ(dut.count_o, 3u);
}

/// Every count, as it is counted here, wraps at 2^8; a clear and a reset of the bus in between.
TEST(Waits, AreCountedAndWrap) {
  tb::Sim<Vbus_waits> sim(1);
  tb::Random random(2);
  auto& dut = sim.dut();
  std::array<std::uint8_t, 5> counts{};
  std::array<std::uint64_t, 5> all{};
  unsigned reads = 0, writes = 0;
  dut.rst = 1;
  dut.open_rst_i = dut.clear_i = 0;
  for (int i = 0; i < 3; ++i) sim.tick();
  dut.rst = 0;
  const auto settle = [&] {  // what was counted is there
    dut.core_i = dut.read_begins_i = dut.read_ends_i = dut.write_begins_i = dut.write_ends_i = 0;
    dut.read_beat_i = dut.write_ends_i = 0;
    dut.open_rst_i = 1;
    for (int i = 0; i < 3; ++i) sim.tick();
    dut.open_rst_i = 0;
    reads = writes = 0;
  };
  for (int part = 0; part < 40; ++part) {
    for (int i = 0; i < 400; ++i) {
      dut.core_i = random.word() & 7;
      dut.read_begins_i = reads < 6 && random.chance(0.3);
      dut.read_beat_i = reads > 0 && random.chance(0.5);
      dut.read_ends_i = dut.read_beat_i && random.chance(0.4);
      dut.write_begins_i = writes < 6 && random.chance(0.45);
      dut.write_ends_i = writes > 0 && random.chance(0.4);
      const bool now[] = {(dut.core_i & 1) != 0, (dut.core_i & 2) != 0, (dut.core_i & 4) != 0,
                          reads > 0 && !dut.read_beat_i, writes > 0 && !dut.write_ends_i};
      for (unsigned k = 0; k < 5; ++k) {
        counts[k] = static_cast<std::uint8_t>(counts[k] + (now[k] ? 1 : 0));
        all[k] += now[k] ? 1 : 0;
      }
      reads += dut.read_begins_i - dut.read_ends_i;
      writes += dut.write_begins_i - dut.write_ends_i;
      sim.tick();
    }
    settle();
    for (unsigned k = 0; k < 5; ++k) EXPECT_EQ(dut.counts_o[k], counts[k]) << part << " " << k;
    if (part % 3 != 2) continue;
    dut.clear_i = 1;
    sim.tick();
    dut.clear_i = 0;
    counts = {};
    for (unsigned k = 0; k < 5; ++k) EXPECT_EQ(dut.counts_o[k], 0U);
  }
  for (const std::uint64_t count : all) EXPECT_GT(count, 1000U);
}

/// No bus that is there now writes in two clocks one after the other; the block itself refuses the
/// second start.
TEST(RegisterBlock, AStartInTheClockOfThePulseIsRefused) {
  tb::Sim<Vbus_registers> sim(1);
  auto& dut = sim.dut();
  const auto write = [&](unsigned offset, std::uint32_t data, unsigned clocks) {
    dut.s_write_word = offset / 4;
    dut.s_write_valid = 0;
    sim.tick();
    dut.s_write_valid = 1;
    dut.s_write_data = data;
    dut.s_write_strobe = 0xF;
    for (unsigned i = 0; i < clocks; ++i) sim.tick();
    dut.s_write_valid = 0;
  };
  const auto status = [&] {
    dut.s_read_word = HWFFD_STATUS_OFFSET / 4;
    sim.tick();
    dut.eval();
    return dut.s_read_data;
  };
  dut.rst = 1;
  dut.s_write_valid = dut.s_read_valid = 0;
  dut.status_busy_i = dut.status_idle_i = dut.status_stopped_i = dut.status_ring_running_i = 0;
  dut.status_done_set_i = 0;
  sim.tick();
  dut.rst = 0;
  while (dut.s_clearing) sim.tick();
  write(HWFFD_WINDOW_LOCK_OFFSET, 1, 1);
  write(HWFFD_CONTROL_OFFSET, HWFFD_CONTROL_START_MASK, 1);
  EXPECT_TRUE(dut.control_start_o);
  EXPECT_EQ(status(), 0u);
  write(HWFFD_CONTROL_OFFSET, HWFFD_CONTROL_START_MASK, 2);
  EXPECT_FALSE(dut.control_start_o) << "one pulse";
  EXPECT_EQ(status(), HWFFD_STATUS_START_REFUSED_MASK);
}

/// Bits of counts that no traffic of a test reaches, 22 and of errors 27 of them with both values:
/// an event of each kind in every clock.
TEST(RegisterBlock, CountsAreReadInTheirHighBits) {
  constexpr std::uint32_t kAllErrors = (1u << kErrors) - 1;
  tb::Sim<Vbus_registers> sim(2);
  auto& dut = sim.dut();
  const auto events = [&](bool now) {
    dut.counter_vertices_event_i = dut.counter_stalls_event_i = dut.counter_busy_event_i = now;
    dut.counter_vertices_second_i = dut.counter_stalls_second_i = dut.counter_busy_second_i = 0;
    dut.error_event_i = now ? kAllErrors : 0;
  };
  const auto get = [&](unsigned offset) {
    dut.s_read_word = offset / 4;
    sim.tick();
    dut.eval();
    return static_cast<std::uint32_t>(dut.s_read_data);
  };
  dut.rst = 1;
  dut.s_write_valid = dut.s_read_valid = 0;
  events(false);
  sim.tick();
  dut.rst = 0;
  while (dut.s_clearing) sim.tick();
  std::uint32_t clocks = 0;
  for (const std::uint32_t wanted : {0x92492u, 0x155555u, 0x2AAAAAu}) {
    events(true);
    for (; clocks < wanted; ++clocks) sim.tick();
    events(false);
    sim.tick();
    sim.tick();
    for (const unsigned offset : {HWFFD_COUNTER_VERTICES_LO_OFFSET, HWFFD_COUNTER_STALLS_LO_OFFSET,
                                  HWFFD_COUNTER_BUSY_LO_OFFSET}) {
      EXPECT_EQ(get(offset), clocks);
      EXPECT_EQ(get(offset + 4), 0u);
    }
    EXPECT_EQ(get(HWFFD_ERROR_COUNT_OFFSET), kErrors * clocks);
    EXPECT_EQ(get(HWFFD_ERROR_STATUS_OFFSET), kAllErrors);
  }
}

}  // namespace
}  // namespace hwffd::test
