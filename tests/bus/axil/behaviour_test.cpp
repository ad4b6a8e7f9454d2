// Pulses, sticky bits, starts, counters, errors and the interrupt.
#include <gtest/gtest.h>

#include <cstring>

#include "named.hpp"
#include "register_bench.hpp"

namespace hwffd::test {
namespace {

std::uint32_t offset_of(const std::string& path) { return register_field(path).offset; }
std::uint32_t bit_of(const std::string& path) { return register_field(path).mask(); }

// ---- pulses

TEST(Pulse, IsOneClock) {
  RegisterBench bench(1);
  bench.set("WINDOW_LOCK", 1);
  const char* ports[] = {"control_start_o", "control_soft_reset_o", "control_clear_counters_o"};
  for (unsigned bits = 0; bits < 8; ++bits) {
    std::uint64_t before[3];
    for (unsigned i = 0; i < 3; ++i) before[i] = bench.high_clocks(ports[i]);
    bench.set("CONTROL", bits);
    bench.steps(6);
    for (unsigned i = 0; i < 3; ++i) {
      EXPECT_EQ(bench.high_clocks(ports[i]) - before[i], bits >> i & 1) << ports[i] << bits;
    }
    EXPECT_EQ(bench.get("CONTROL"), 0u);
  }
}

TEST(Pulse, NeedsItsStrobe) {
  RegisterBench bench(2);
  bench.set("WINDOW_LOCK", 1);
  for (const std::uint8_t strobe : {0, 2, 4, 8, 14}) {
    EXPECT_EQ(bench.write(offset_of("CONTROL.start"), ~0u, strobe), cores::kOkay);
  }
  bench.steps(3);
  EXPECT_EQ(bench.high_clocks("control_start_o"), 0u);
  EXPECT_EQ(bench.high_clocks("control_soft_reset_o"), 0u);
}

// ---- sticky bits against a set in the same clock

struct Sticky {
  std::string name() const {
    return std::string(path).replace(std::strchr(path, '.') - path, 1, "_");
  }
  const char* path;
  const char* port;
  std::uint64_t value;
};

class EachSticky : public testing::TestWithParam<Sticky> {};
INSTANTIATE_TEST_SUITE_P(Bits, EachSticky,
                         testing::Values(Sticky{"STATUS.done", "status_done_set_i", 1},
                                         Sticky{"ERROR_STATUS.unknown_opcode", "error_event_i", 1},
                                         Sticky{"ERROR_STATUS.result_overflow", "error_event_i",
                                                0x20000},
                                         Sticky{"ERROR_FIRST.valid", "error_event_i", 0x10},
                                         Sticky{"IRQ_STATE.done", "status_done_set_i", 1},
                                         Sticky{"IRQ_STATE.error", "error_event_i", 2}),
                         test::by_name);

TEST_P(EachSticky, IsSetByTheHardwareAndClearedByOne) {
  const Sticky& sticky = GetParam();
  RegisterBench bench(3);
  const auto is_set = [&] { return bench.is_set(sticky.path); };
  EXPECT_FALSE(is_set());
  bench.pulse(sticky.port, sticky.value);
  EXPECT_TRUE(is_set());
  bench.write(offset_of(sticky.path), ~bit_of(sticky.path));
  EXPECT_TRUE(is_set());
  bench.write(offset_of(sticky.path), 0);
  EXPECT_TRUE(is_set());
  const unsigned byte = register_field(sticky.path).low / 8;
  bench.write(offset_of(sticky.path), ~0u, static_cast<std::uint8_t>(0xF & ~(1u << byte)));
  EXPECT_TRUE(is_set());
  bench.write(offset_of(sticky.path), bit_of(sticky.path), static_cast<std::uint8_t>(1u << byte));
  EXPECT_FALSE(is_set());
}

TEST_P(EachSticky, WinsOverAClearInTheSameClock) {
  const Sticky& sticky = GetParam();
  unsigned earlier = 0;
  unsigned same = 0;
  unsigned later = 0;
  for (unsigned at = 0; at < 10; ++at) {
    RegisterBench bench(4);
    bench.pulse(sticky.port, sticky.value);  // it was set before
    const std::uint64_t pulse = bench.clock() + at;
    bench.each_clock(
        [&] { bench.inputs()[sticky.port] = bench.clock() == pulse ? sticky.value : 0; });
    bench.set_bit(sticky.path);
    while (bench.clock() <= pulse) bench.step();
    EXPECT_EQ(bench.is_set(sticky.path), pulse >= bench.write_clock()) << at;
    (pulse < bench.write_clock() ? earlier : pulse == bench.write_clock() ? same : later) += 1;
  }
  EXPECT_GT(earlier, 0u);
  EXPECT_EQ(same, 1u);
  EXPECT_GT(later, 0u);
}

// ---- start

/// Clocks of start so far, after one was asked for.
std::uint64_t starts(RegisterBench& bench) {
  bench.set_bit("CONTROL.start");
  bench.steps(3);
  return bench.high_clocks("control_start_o");
}

/// A start that must be refused.
void expect_refused(RegisterBench& bench, const std::string& reason) {
  const std::uint64_t before = bench.high_clocks("control_start_o");
  bench.set_bit("STATUS.start_refused");
  bench.set_bit("IRQ_STATE.refused");
  EXPECT_EQ(starts(bench), before) << reason;
  EXPECT_TRUE(bench.is_set("STATUS.start_refused")) << reason;
  EXPECT_EQ(bench.get("IRQ_STATE"), bit_of("IRQ_STATE.refused")) << reason;
}

TEST(Start, IsRefusedWhileBusyOrStopped) {
  for (const char* reason : {"status_busy_i", "status_stopped_i"}) {
    RegisterBench bench(5);
    bench.set("WINDOW_LOCK", 1);
    bench.inputs()[reason] = 1;
    expect_refused(bench, reason);
    bench.inputs()[reason] = 0;
    EXPECT_EQ(bench.get("STATUS"), bit_of("STATUS.start_refused"));
    EXPECT_EQ(starts(bench), 1u);
    EXPECT_EQ(bench.get("STATUS"), bit_of("STATUS.start_refused"));  // until cleared
    bench.set_bit("STATUS.start_refused");
    EXPECT_EQ(bench.get("STATUS"), 0u);
  }
}

TEST(Start, NeedsTheLock) {
  RegisterBench bench(5);
  expect_refused(bench, "not locked");
  bench.set("WINDOW_LOCK", 1);
  EXPECT_EQ(starts(bench), 1u);
  bench.reset();
  expect_refused(bench, "reset takes the lock away");
}

TEST(Start, TwiceInSuccessiveClocksIsOnce) {
  RegisterBench bench(6);
  bench.set("WINDOW_LOCK", 1);
  std::uint64_t start_clock = 0;
  bench.each_clock([&] {  // busy from the clock after the pulse on, as the hardware must
    if (start_clock != 0 && bench.clock() > start_clock) bench.inputs()["status_busy_i"] = 1;
    if (bench.output("control_start_o") != 0) start_clock = bench.clock();
  });
  for (unsigned i = 0; i < 4; ++i) bench.driver().write({offset_of("CONTROL.start"), 1, 0xF});
  bench.run();
  bench.steps(3);
  EXPECT_EQ(bench.high_clocks("control_start_o"), 1u);
  const auto& answers = bench.driver().write_responses();
  ASSERT_EQ(answers.size(), 5u);                       // the lock's is the first
  EXPECT_EQ(answers[4].cycle - answers[1].cycle, 3u);  // they were successive
  EXPECT_TRUE(bench.is_set("STATUS.start_refused"));
}

// ---- counters

TEST(Counter, CountsClocksOfItsEvent) {
  const char* names[] = {"VERTICES", "STALLS", "BUSY"};
  const char* ports[] = {"counter_vertices_event_i", "counter_stalls_event_i",
                         "counter_busy_event_i"};
  for (unsigned which = 0; which < 3; ++which) {
    RegisterBench bench(7);
    bench.inputs()[ports[which]] = 1;
    bench.steps(1000);
    bench.inputs()[ports[which]] = 0;
    bench.steps(10);
    for (unsigned other = 0; other < 3; ++other) {
      const std::string name = std::string("COUNTER_") + names[other];
      EXPECT_EQ(bench.get(name + "_LO"), other == which ? 1000u : 0u) << name;
      EXPECT_EQ(bench.get(name + "_HI"), 0u);
    }
    bench.set_bit("CONTROL.clear_counters");
    EXPECT_EQ(bench.get(std::string("COUNTER_") + names[which] + "_LO"), 0u);
  }
}

// ---- errors

struct Error {
  std::uint64_t events;
  std::uint32_t packet, beat;
  std::uint64_t address;
};

void raise(RegisterBench& bench, const Error& error) {
  bench.inputs()["error_packet_i"] = error.packet;
  bench.inputs()["error_beat_i"] = error.beat;
  bench.inputs()["error_address_i"] = error.address;
  bench.inputs()["error_address_valid_i"] = error.address != 0 ? 1 : 0;
  bench.pulse("error_event_i", error.events);
  bench.inputs()["error_address_valid_i"] = 0;
  bench.inputs()["error_packet_i"] = ~0u;
}

void expect_first(RegisterBench& bench, unsigned code, const Error& error) {
  EXPECT_EQ(bench.get("ERROR_FIRST"), bit_of("ERROR_FIRST.valid") | code);
  EXPECT_EQ(bench.get("ERROR_PACKET"), error.packet);
  EXPECT_EQ(bench.get("ERROR_BEAT"), error.beat);
  EXPECT_EQ(bench.get("ERROR_ADDRESS_LO"), static_cast<std::uint32_t>(error.address));
  EXPECT_EQ(bench.get("ERROR_ADDRESS_HI"), static_cast<std::uint32_t>(error.address >> 32));
}

TEST(Errors, EachCodeHasItsBit) {
  for (unsigned code = 0; code < 18; ++code) {
    RegisterBench bench(8);
    const Error error{std::uint64_t{1} << code, 100 + code, 7, 0x123456789ABCDEF0u};
    raise(bench, error);
    EXPECT_EQ(bench.get("ERROR_STATUS"), 1u << code);
    EXPECT_EQ(bench.get("ERROR_COUNT"), 1u);
    EXPECT_EQ(bench.get("IRQ_STATE"), bit_of("IRQ_STATE.error"));
    expect_first(bench, code, error);
  }
}

TEST(Errors, TheFirstIsKeptUntilItIsCleared) {
  RegisterBench bench(9);
  const Error first{0x8420, 1, 2, 3};  // several at once: the lowest code
  const Error second{0x0001, 4, 5, 6};
  raise(bench, first);
  raise(bench, second);
  expect_first(bench, 5, first);
  EXPECT_EQ(bench.get("ERROR_COUNT"), 4u);
  EXPECT_EQ(bench.get("ERROR_STATUS"), 0x8421u);
  bench.set("ERROR_STATUS", 0x8400);
  EXPECT_EQ(bench.get("ERROR_STATUS"), 0x0021u);
  expect_first(bench, 5, first);  // has nothing to do with the status
  bench.set_bit("ERROR_FIRST.valid");
  EXPECT_EQ(bench.get("ERROR_FIRST"), 5u);
  const Error third{0x1000, 9, 8, 7};
  raise(bench, third);
  expect_first(bench, 12, third);
  EXPECT_EQ(bench.get("ERROR_COUNT"), 5u);
  bench.set_bit("CONTROL.clear_counters");
  EXPECT_EQ(bench.get("ERROR_COUNT"), 0u);
  expect_first(bench, 12, third);
}

TEST(Errors, AnErrorWithoutAnAddressHidesNone) {
  RegisterBench bench(9);
  raise(bench, {0x0200, 1, 2, 0});
  expect_first(bench, 9, {0x0200, 1, 2, 0});
  raise(bench, {0x8000, 0, 0, 0x1'2345'6780});
  expect_first(bench, 9, {0x0200, 1, 2, 0x1'2345'6780});
  raise(bench, {0x10000, 0, 0, 0xFFF0});  // the second with an address
  raise(bench, {0x0001, 7, 7, 0});
  expect_first(bench, 9, {0x0200, 1, 2, 0x1'2345'6780});
  bench.set_bit("ERROR_FIRST.valid");
  raise(bench, {0x0004, 3, 4, 0});
  expect_first(bench, 2, {0x0004, 3, 4, 0});
}

TEST(Errors, OneInTheClockOfTheClearIsRecorded) {
  for (unsigned at = 0; at < 8; ++at) {
    RegisterBench bench(10);
    raise(bench, {0x2, 1, 1, 1});
    const std::uint64_t pulse = bench.clock() + at;
    bench.each_clock([&] {
      bench.inputs()["error_event_i"] = bench.clock() == pulse ? 0x40 : 0;
      bench.inputs()["error_packet_i"] = 77;
    });
    bench.set_bit("ERROR_FIRST.valid");
    while (bench.clock() <= pulse) bench.step();
    const std::uint64_t acted = bench.write_clock();
    EXPECT_EQ(bench.get("ERROR_FIRST"), pulse < acted ? 1u : 6u | bit_of("ERROR_FIRST.valid"));
    EXPECT_EQ(bench.get("ERROR_PACKET"), pulse < acted ? 1u : 77u);
  }
}

// ---- interrupt

TEST(Interrupt, FollowsStateAndEnable) {
  for (unsigned enable = 0; enable < 8; ++enable) {
    for (unsigned state = 0; state < 8; ++state) {
      RegisterBench bench(11);
      bench.set("IRQ_ENABLE", enable);
      bench.set("IRQ_TEST", state);
      bench.steps(2);
      EXPECT_EQ(bench.get("IRQ_STATE"), state);
      EXPECT_EQ(bench.output("irq_o"), (enable & state) != 0 ? 1u : 0u);
      EXPECT_EQ(bench.get("STATUS"), 0u);
      bench.set("IRQ_STATE", state);
      bench.steps(2);
      EXPECT_EQ(bench.get("IRQ_STATE"), 0u);
      EXPECT_EQ(bench.output("irq_o"), 0u);
    }
  }
}

TEST(Interrupt, IsSeparateFromWhatCausedIt) {
  RegisterBench bench(12);
  bench.set_bit("IRQ_ENABLE.done");
  bench.pulse("status_done_set_i");
  bench.steps(2);
  EXPECT_EQ(bench.output("irq_o"), 1u);
  bench.set_bit("STATUS.done");
  EXPECT_EQ(bench.get("IRQ_STATE"), bit_of("IRQ_STATE.done"));
  bench.pulse("status_done_set_i");
  bench.set_bit("IRQ_STATE.done");
  bench.steps(2);
  EXPECT_EQ(bench.output("irq_o"), 0u);
  EXPECT_EQ(bench.get("STATUS"), bit_of("STATUS.done"));
}

}  // namespace
}  // namespace hwffd::test
