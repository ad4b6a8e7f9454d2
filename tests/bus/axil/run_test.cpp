// Runs, which stand between the registers, the DMA and the core: one start, one end.
#include <gtest/gtest.h>

#include <cstdint>
#include <functional>

#include "Vbus_run.h"
#include "hwffd/tb/sim.hpp"

namespace hwffd::test {
namespace {

constexpr unsigned kDmaReset = 20;  // clocks in which the stand-in clears
constexpr unsigned kHalt = 40;      // and until it has halted after a bus error

/// ffd_bus_run with a few lines in the place of DMA and core: a ring that works off a descriptor in
/// `work` clocks, results that stay on the bus for `drain` clocks after.
class RunBench {
 public:
  explicit RunBench(std::uint64_t seed = 1) : sim_(seed, 1'000'000) {
    auto& dut = sim_.dut();
    dut.rst = 1;
    dut.start_i = dut.soft_reset_i = dut.dma_fault_i = dut.write_error_i = 0;
    dut.ring_running_i = dut.dma_clearing_i = dut.dma_halted_i = 0;
    dut.dma_idle_i = dut.core_idle_i = 1;
    dut.ring_base_i = 0x4000;
    dut.ring_log2_size_i = 4;
    dut.ring_head_i = 0;
    for (unsigned i = 0; i < 3; ++i) sim_.tick();
    EXPECT_EQ(dut.core_rst_o, 1);
    dut.rst = 0;
    step();
  }

  void step() {
    auto& dut = sim_.dut();
    const bool ring_start = dut.ring_start_o != 0;
    const bool result_start = dut.result_start_o != 0;
    const bool soft_reset = dut.soft_reset_i != 0;
    ring_starts += ring_start ? 1 : 0;
    result_starts += result_start ? 1 : 0;
    sim_.tick();
    done += dut.done_o;
    dut.start_i = dut.soft_reset_i = dut.dma_fault_i = dut.write_error_i = 0;
    if (soft_reset) {
      left_ = drain_left_ = halts_ = 0;
      dut.dma_halted_i = 0;
      tail = 0;
      dut.ring_running_i = 0;
      clearing_ = kDmaReset;
    } else if (clearing_ > 0) {
      --clearing_;
    } else {
      if (result_start && refuse) fail_at_ = 3;
      if (fail_at_ > 0 && --fail_at_ == 0) refuse_area();
      if (halts_ > 0 && --halts_ == 0) dut.dma_halted_i = 1;
      if (ring_start) dut.ring_running_i = 1;
      work_off();
    }
    dut.dma_clearing_i = clearing_ > 0 ? 1 : 0;
    dut.dma_idle_i = clearing_ == 0 && left_ == 0 && drain_left_ == 0 && !ring_has_work() ? 1 : 0;
    dut.core_idle_i = core_stuck ? 0 : 1;
    dut.eval();
  }
  void steps(unsigned clocks) {
    for (unsigned i = 0; i < clocks; ++i) step();
  }
  void start() { pulse(dut().start_i); }
  void start(unsigned head) {
    dut().ring_head_i = static_cast<SData>(head);
    start();
  }
  void soft_reset() { pulse(dut().soft_reset_i); }
  /// Until that many runs have ended.
  bool until_done(unsigned runs, unsigned limit = 10'000) {
    return until([&] { return done == runs; }, limit);
  }
  bool until_idle(unsigned limit = 10'000) {
    return until([&] { return dut().busy_o == 0; }, limit);
  }

  bool until(const std::function<bool()>& end, unsigned limit = 10'000) {
    for (unsigned i = 0; i < limit; ++i) {
      if (end()) return true;
      step();
    }
    return false;
  }
  void refuse_area() {
    sim_.dut().write_error_i = 1;
    sim_.dut().eval();
  }
  void fault() {
    sim_.dut().dma_fault_i = 1;
    halts_ = kHalt;
    sim_.dut().eval();
  }
  Vbus_run& dut() { return sim_.dut(); }

  unsigned work = 10, drain = 15;
  bool refuse = false;  ///< the result area
  bool core_stuck = false;
  unsigned done = 0, ring_starts = 0, result_starts = 0;
  unsigned tail = 0;

 private:
  void pulse(CData& input) {
    input = 1;
    dut().eval();
    step();
  }
  bool ring_has_work() { return dut().ring_running_i != 0 && tail != dut().ring_head_o; }
  void work_off() {
    if (left_ == 0 && ring_has_work()) {
      left_ = work;
    } else if (left_ > 0 && --left_ == 0) {
      tail = (tail + 1) & 15;
      drain_left_ = drain;
    } else if (drain_left_ > 0) {
      --drain_left_;
    }
  }

  tb::Sim<Vbus_run> sim_;
  unsigned left_ = 0, drain_left_ = 0, clearing_ = 0, fail_at_ = 0, halts_ = 0;
};

TEST(Run, EndsWhenAllIsDone) {
  for (unsigned descriptors : {0u, 1u, 5u}) {
    RunBench bench;
    EXPECT_EQ(bench.dut().busy_o, 0);
    EXPECT_EQ(bench.dut().core_rst_o, 0);
    bench.start(descriptors);
    EXPECT_EQ(bench.dut().busy_o, 1);  // in the clock after the pulse
    ASSERT_TRUE(bench.until_idle());
    EXPECT_EQ(bench.done, 1u);
    EXPECT_EQ(bench.tail, descriptors);
    EXPECT_EQ(bench.ring_starts, 1u);
    EXPECT_EQ(bench.result_starts, 1u);
    EXPECT_EQ(bench.dut().idle_o, 1);
    bench.steps(50);
    EXPECT_EQ(bench.done, 1u);
  }
}

TEST(Run, WaitsForTheCore) {
  RunBench bench;
  bench.core_stuck = true;
  bench.start(2);
  bench.steps(500);
  EXPECT_EQ(bench.dut().busy_o, 1);
  EXPECT_EQ(bench.dut().idle_o, 0);
  bench.core_stuck = false;
  EXPECT_TRUE(bench.until_done(1, 12));
}

TEST(Run, TheRingSeesNoHeadBetweenRuns) {
  RunBench bench;
  bench.start();
  ASSERT_TRUE(bench.until_done(1));
  bench.dut().ring_head_i = 3;
  bench.steps(100);
  EXPECT_EQ(bench.tail, 0u);
  EXPECT_EQ(bench.dut().ring_head_o, 0);
  bench.start();
  ASSERT_TRUE(bench.until_done(2));
  EXPECT_EQ(bench.tail, 3u);
}

TEST(Run, AHeadThatComesAtAnyClockIsTakenOrWaits) {
  unsigned taken = 0;
  constexpr unsigned kClocks = 90;
  for (unsigned at = 0; at < kClocks; ++at) {
    RunBench bench;
    bench.start(1);
    bench.steps(at);
    bench.dut().ring_head_i = 2;
    ASSERT_TRUE(bench.until([&] { return bench.done == 1 && bench.dut().busy_o == 0; }));
    const unsigned tail = bench.tail;
    bench.steps(100);
    EXPECT_EQ(bench.done, 1u);
    EXPECT_EQ(bench.tail, tail);  // nothing goes on outside a run
    EXPECT_EQ(bench.dut().ring_head_o, tail);
    taken += bench.tail == 2 ? 1 : 0;
    bench.start();
    ASSERT_TRUE(bench.until_done(2));
    EXPECT_EQ(bench.tail, 2u);
  }
  EXPECT_GT(taken, 10u);
  EXPECT_LT(taken, kClocks - 10);
}

TEST(Run, ARingInUseKeepsItsPlace) {
  RunBench bench;
  bench.start();
  ASSERT_TRUE(bench.until_done(1));
  bench.dut().ring_base_i = 0x9000;
  bench.dut().ring_log2_size_i = 2;
  bench.start();
  ASSERT_TRUE(bench.until_done(2));
  EXPECT_EQ(bench.dut().ring_base_o, 0x4000u);
  EXPECT_EQ(bench.dut().ring_entries_log2_o, 4);
  bench.soft_reset();
  ASSERT_TRUE(bench.until_idle());
  bench.start();
  EXPECT_EQ(bench.dut().ring_base_o, 0x9000u);
  EXPECT_EQ(bench.dut().ring_entries_log2_o, 2);
}

TEST(Run, ARefusedAreaStartsNoRing) {
  RunBench bench;
  bench.refuse = true;
  bench.start(2);
  ASSERT_TRUE(bench.until_idle());
  EXPECT_EQ(bench.done, 1u);
  EXPECT_EQ(bench.ring_starts, 0u);
  EXPECT_EQ(bench.dut().stopped_o, 0);  // a refusal is not a bus error
  bench.refuse = false;
  bench.start();
  ASSERT_TRUE(bench.until_done(2));
  EXPECT_EQ(bench.tail, 2u);
}

TEST(Run, AFaultOfTheBusEndsItAndASoftResetTheStop) {
  RunBench bench;
  bench.core_stuck = true;  // results are held back: never idle
  bench.start(1);
  bench.steps(22);
  bench.fault();
  ASSERT_TRUE(bench.until_idle());
  EXPECT_EQ(bench.dut().dma_halted_i, 1);  // it was waited for
  EXPECT_EQ(bench.done, 1u);
  EXPECT_EQ(bench.dut().stopped_o, 1);
  bench.core_stuck = false;
  bench.soft_reset();
  EXPECT_EQ(bench.dut().stopped_o, 0);
  ASSERT_TRUE(bench.until_idle());
  EXPECT_EQ(bench.done, 1u);
}

TEST(Run, ARefusalInItIsNoStop) {
  RunBench bench;
  bench.start(3);
  bench.steps(30);
  bench.refuse_area();
  ASSERT_TRUE(bench.until_done(1));
  EXPECT_EQ(bench.dut().stopped_o, 0);
}

/// The DMA takes the area in the clock of the start; the core is reset at every edge of rst.
TEST(Run, StartAndResetReachTheOthersInTheSameClock) {
  RunBench bench;
  auto& dut = bench.dut();
  dut.start_i = 1;
  dut.eval();
  EXPECT_EQ(dut.result_start_o, 1);
  bench.step();
  EXPECT_EQ(dut.result_start_o, 0);
  EXPECT_EQ(dut.core_rst_o, 0);
  dut.rst = 1;
  dut.eval();
  EXPECT_EQ(dut.core_rst_o, 1);
  bench.step();
  dut.rst = 0;
  dut.eval();
  EXPECT_EQ(dut.core_rst_o, 0);
  EXPECT_EQ(dut.busy_o, 0);
}

TEST(Run, ASoftResetAtAnyClockEndsIt) {
  for (unsigned at = 0; at < 100; ++at) {
    RunBench bench(at + 1);
    bench.dut().ring_head_i = 2;
    if (at > 0) bench.start();
    bench.steps(at);
    const unsigned before = bench.done;
    if (at % 2 == 0) bench.dut().start_i = 1;  // it wins over a start of the same clock
    bench.dut().soft_reset_i = 1;
    bench.dut().eval();
    EXPECT_EQ(bench.dut().busy_o, 1);
    EXPECT_EQ(bench.dut().idle_o, 0);
    bench.step();
    EXPECT_EQ(bench.dut().core_rst_o, 1);
    const unsigned starts = bench.ring_starts;
    ASSERT_TRUE(bench.until_idle(kDmaReset + 2));
    bench.steps(50);
    EXPECT_EQ(bench.done, before);
    EXPECT_EQ(bench.ring_starts, starts);
    EXPECT_EQ(bench.dut().core_rst_o, 0);
    bench.start();
    ASSERT_TRUE(bench.until_done(before + 1));
    EXPECT_EQ(bench.tail, 2u);
  }
}

}  // namespace
}  // namespace hwffd::test
