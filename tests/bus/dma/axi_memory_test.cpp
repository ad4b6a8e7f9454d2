// The memory model alone, driven by hand.
#include "hwffd/tb/axi_memory.hpp"

#include <gtest/gtest.h>

#include <algorithm>

namespace hwffd::tb {
namespace {

/// A master that does one thing at a time.
struct Hand {
  AxiMemory memory{3};
  cores::AxiPins pins;
  std::uint64_t cycle = 0;

  void step() {
    memory.drive(pins, cycle);
    memory.observe(pins, cycle++);
  }
  std::uint64_t address(cores::AxiAddressChannel& channel, std::uint64_t at, std::uint8_t len) {
    channel.valid = true;
    channel.address = at;
    channel.len = len;
    do step();
    while (!channel.ready);
    channel.valid = false;
    return cycle - 1;
  }
};

TEST(AxiMemory, GuardBytesAreRandomAndWatched) {
  AxiMemory memory(1);
  int equal = 0;
  for (std::uint64_t i = 0; i < 4096; ++i) equal += memory.byte(i) == memory.byte(i + 4096);
  EXPECT_LT(equal, 40);
  memory.set_beat(0xffffffffffffffe0, {1, 2, 3, 4});
  EXPECT_EQ(memory.beat(0xffffffffffffffe0), (cores::AxiData{1, 2, 3, 4}));
  EXPECT_EQ(memory.changed_outside({{0xffffffffffffffe0, 0xffffffffffffffef}}), 0u);
  EXPECT_GT(memory.changed_outside({{0xffffffffffffffe1, 0xffffffffffffffef}}), 0u);
  memory.set_byte(0x1234, static_cast<std::uint8_t>(memory.guard(0x1234) + 1));
  EXPECT_EQ(memory.changed_outside({{0xffffffffffffffe0, 0xffffffffffffffef}}), 1u);
}

TEST(AxiMemory, ReadyMayWaitForValid) {
  Hand hand;
  hand.memory.let_ready_wait_for_valid();
  for (int i = 0; i < 5; ++i) {
    hand.step();
    EXPECT_FALSE(hand.pins.ar.ready || hand.pins.aw.ready || hand.pins.w.ready);
  }
  for (bool* valid : {&hand.pins.ar.valid, &hand.pins.aw.valid, &hand.pins.w.valid}) {
    *valid = true;
    hand.step();
    EXPECT_FALSE(hand.pins.ar.ready || hand.pins.aw.ready || hand.pins.w.ready);
    hand.step();
    EXPECT_EQ(hand.pins.ar.ready, valid == &hand.pins.ar.valid);
    EXPECT_EQ(hand.pins.aw.ready, valid == &hand.pins.aw.valid);
    EXPECT_EQ(hand.pins.w.ready, valid == &hand.pins.w.valid);
    *valid = false;
    hand.step();
  }
}

TEST(AxiMemory, ReadsComeInOrderAfterTheLatency) {
  Hand hand;
  hand.memory.set_latency({30, 30});
  hand.memory.fail_read(1, 1, cores::kAxiDecerr);
  const std::uint64_t first = hand.address(hand.pins.ar, 0x100, 0);
  hand.address(hand.pins.ar, 0x200, 2);
  hand.pins.r.ready = true;
  std::vector<std::uint64_t> seen;
  for (int i = 0; i < 50; ++i) {
    hand.step();
    if (!hand.pins.r.valid) continue;
    seen.push_back(hand.cycle - 1 - first);
    const std::uint64_t n = seen.size();
    const cores::AxiData data = hand.memory.beat(n == 1 ? 0x100 : 0x200 + 16 * (n - 2));
    EXPECT_TRUE(std::equal(data.begin(), data.end(), hand.pins.r.data.begin()));
    EXPECT_EQ(hand.pins.r.last, n == 1 || n == 4);
    EXPECT_EQ(hand.pins.r.response, n == 3 ? cores::kAxiDecerr : cores::kAxiOkay);
  }
  EXPECT_EQ(seen, (std::vector<std::uint64_t>{30, 31, 32, 33}));
  EXPECT_TRUE(hand.memory.quiet());
}

TEST(AxiMemory, WritesAreKeptOrFail) {
  Hand hand;
  hand.memory.fail_write(1, cores::kAxiSlverr);
  hand.pins.b.ready = true;
  for (std::uint64_t burst = 0; burst < 2; ++burst) {
    hand.address(hand.pins.aw, 0x100 * burst, 1);
    for (std::uint32_t beat = 0; beat < 2; ++beat) {
      hand.pins.w = {true, false, {beat, 7, 7, 7}, 0xffff, beat == 1};
      hand.step();
    }
    hand.pins.w.valid = false;
    EXPECT_FALSE(hand.memory.quiet());
    hand.step();
    EXPECT_TRUE(hand.pins.b.valid);
    EXPECT_EQ(hand.pins.b.response, burst == 1 ? cores::kAxiSlverr : cores::kAxiOkay);
  }
  EXPECT_EQ(hand.memory.beat(0x10), (cores::AxiData{1, 7, 7, 7}));
  EXPECT_EQ(hand.memory.changed_outside({{0, 0x1f}}), 0u);
  EXPECT_EQ(hand.memory.writes().size(), 2u);
  EXPECT_EQ(hand.memory.writes()[1].address, 0x100u);
  EXPECT_EQ(hand.memory.writes()[1].beats, 2u);
}

}  // namespace
}  // namespace hwffd::tb
