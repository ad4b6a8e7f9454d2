// Runs, which stand between the registers, the DMA and the core: one start, one end. All outputs
// are compared with a model in every clock, under DMA, core and software that do anything at any
// time.
#include <gtest/gtest.h>

#include <cstdint>
#include <map>
#include <string>

#include "Vbus_run.h"
#include "hwffd/tb/random.hpp"
#include "hwffd/tb/sim.hpp"

namespace hwffd::test {
namespace {

constexpr unsigned kSettled = 7;  // clocks after which a handing over must show, or quiet is quiet

/// ffd_bus_run as its head says; what it drives and reads has the names of its ports.
class RunModel {
 public:
  bool busy = false, idle = false, stopped = false, done = false;
  bool ring_start = false, result_start = false;
  bool core_rst = true;  ///< of the reset before
  std::uint64_t ring_base = 0;
  unsigned entries_log2 = 0, head = 0;
  bool ring_known = false, head_known = false;  ///< what is not reset
  /// How often a run began and ended, and how.
  std::map<std::string, unsigned> seen;

  /// Outputs that follow the inputs within the clock.
  void settle(const Vbus_run& in) {
    const bool clear = in.soft_reset_i || in.dma_clearing_i;
    busy = state_ != kIdle || clear;
    idle = in.dma_idle_i && in.core_idle_i && !clear;
    result_start = state_ == kIdle && in.start_i && !clear;
  }
  void clock(const Vbus_run& in) {
    const bool clear = in.soft_reset_i || in.dma_clearing_i;
    const State before = state_;
    // A run is quiet when all is idle; once a fault stopped it, when the DMA has halted.
    const bool quiet = stopped ? in.dma_halted_i : in.dma_idle_i && in.core_idle_i;
    const bool settled = waited_ >= kSettled;
    const bool moves = head != in.ring_head_i;
    if (result_start && !in.ring_running_i) {
      ring_known = true;
      ring_base = in.ring_base_i;
      entries_log2 = in.ring_log2_size_i;
    }
    done = ring_start = false;
    if (in.rst || clear) {
      end(in.rst ? "reset" : "soft reset");
      if (in.start_i && in.soft_reset_i) ++seen["start and soft reset at once"];
    } else if (result_start) {
      state_ = kCheck;
      ++seen[in.ring_running_i ? "start in a ring in use" : "start with a new ring"];
    } else if (state_ == kCheck && in.write_error_i) {
      done = end("refused");
    } else if (state_ == kCheck && settled) {
      state_ = kRun;
      ring_start = true;
    } else if (state_ == kRun && settled && quiet) {
      done = end(stopped ? "halted" : "all idle");
    }
    // Between runs the ring sees no new head.
    const bool follows = ring_start || (before == kRun && !done);
    if (follows) head = in.ring_head_i;
    head_known = !in.rst && (head_known || follows);
    if (!follows && head != in.ring_head_i) ++seen["head between runs"];
    // One that the ring has just been given shows as late as all else that is handed over.
    waited_ = state_ != before || (state_ == kRun && (!quiet || moves)) ? 0 : waited_ + 1;
    if (before == kIdle && in.write_error_i) ++seen["refusal between runs"];
    if (before == kRun && in.write_error_i) ++seen["refusal in a run"];
    stopped = !in.rst && !clear && (stopped || in.dma_fault_i);
    core_rst = in.rst || clear;
  }

 private:
  enum State { kIdle, kCheck, kRun };
  bool end(const std::string& how) {
    static const char* const kNames[] = {" when idle", " in the check", " in a run"};
    ++seen[how + kNames[state_]];
    state_ = kIdle;
    return true;
  }
  State state_ = kIdle;
  unsigned waited_ = 0;
};

/// Levels that stay a while, so that runs come to their ends, and pulses of a clock.
void disturb(Vbus_run& dut, const RunModel& model, tb::Random& random) {
  for (CData* level : {&dut.dma_idle_i, &dut.core_idle_i}) {
    if (random.chance(*level != 0 ? 0.03 : 0.2)) *level ^= 1;
  }
  for (CData* level : {&dut.ring_running_i, &dut.dma_halted_i}) {
    if (random.chance(0.1)) *level ^= 1;
  }
  dut.dma_clearing_i = random.chance(dut.dma_clearing_i != 0 ? 0.8 : 0.005) ? 1 : 0;
  dut.soft_reset_i = random.chance(0.02) ? 1 : 0;
  dut.write_error_i = random.chance(0.03) ? 1 : 0;
  dut.dma_fault_i = random.chance(0.01) ? 1 : 0;
  dut.rst = random.chance(0.002) ? 1 : 0;
  if (random.chance(0.1)) dut.ring_head_i = random.word() & 0xFFFF;
  if (random.chance(0.1)) dut.ring_base_i = random.bits();
  if (random.chance(0.1)) dut.ring_log2_size_i = random.word() & 15;
  // The registers refuse a start while busy or stopped; one may come with the soft reset.
  dut.start_i = !model.busy && !model.stopped && random.chance(0.3) ? 1 : 0;
}

void expect_outputs(const Vbus_run& dut, const RunModel& model) {
  ASSERT_EQ(dut.busy_o != 0, model.busy);
  ASSERT_EQ(dut.idle_o != 0, model.idle);
  ASSERT_EQ(dut.stopped_o != 0, model.stopped);
  ASSERT_EQ(dut.done_o != 0, model.done);
  ASSERT_EQ(dut.ring_start_o != 0, model.ring_start);
  ASSERT_EQ(dut.result_start_o != 0, model.result_start);
  ASSERT_EQ(dut.core_rst_o != 0, model.core_rst);
  if (model.ring_known) {
    ASSERT_EQ(dut.ring_base_o, model.ring_base);
    ASSERT_EQ(dut.ring_entries_log2_o, model.entries_log2);
  }
  if (model.head_known) {
    ASSERT_EQ(dut.ring_head_o, model.head);
  }
}

TEST(Run, EqualsTheModelInEveryClock) {
  constexpr unsigned kClocks = 400'000;
  const std::uint64_t seed = tb::seed_from_environment(1);
  tb::Random random(tb::derive_seed(seed, 5));
  tb::Sim<Vbus_run> sim(seed);
  Vbus_run& dut = sim.dut();
  RunModel model;
  dut.rst = 1;
  dut.ring_running_i = dut.dma_halted_i = 0;
  dut.dma_idle_i = dut.core_idle_i = 1;
  sim.tick();
  unsigned starts = 0, ends = 0;
  for (unsigned clock = 0; clock < kClocks; ++clock) {
    disturb(dut, model, random);
    model.settle(dut);
    dut.eval();
    expect_outputs(dut, model);
    if (HasFatalFailure()) FAIL() << "clock " << clock;
    starts += model.result_start && dut.rst == 0 ? 1 : 0;
    model.clock(dut);
    sim.tick();
    ends += dut.done_o;
  }
  const auto& seen = model.seen;
  for (const char* what :
       {"start with a new ring", "start in a ring in use", "refused in the check",
        "all idle in a run", "halted in a run", "soft reset when idle", "soft reset in the check",
        "soft reset in a run", "reset in a run", "reset in the check", "refusal between runs",
        "refusal in a run", "head between runs", "start and soft reset at once"}) {
    EXPECT_GT(seen.count(what) != 0 ? seen.at(what) : 0, 20U) << what;
  }
  // One start, one end, but for those that a reset of either kind ended.
  unsigned cut = 0;
  for (const char* what :
       {"soft reset in the check", "soft reset in a run", "reset in the check", "reset in a run"}) {
    cut += seen.at(what);
  }
  EXPECT_LE(starts - (ends + cut), 1U);
}

}  // namespace
}  // namespace hwffd::test
