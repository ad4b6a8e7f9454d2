// Every planted flaw of a core is caught, by the part of the bench that should catch it and with
// exactly the counts that it causes.
#include <gtest/gtest.h>

#include <string>

#include "hwffd/tb/stream_bench.hpp"
#include "loopback_core.hpp"
#include "named.hpp"

namespace hwffd::tb {
namespace {

constexpr std::size_t kBeats = 25;
constexpr std::uint64_t kAfterFlaw = kBeats - LoopbackCore::kFlawedBeat;  // flawed beat included

struct Case {
  const char* name;
  Flaw flaw;
  const char* source;
  const char* sink;
  std::uint64_t checked;
  std::uint64_t mismatches;
  std::uint64_t extra;
  std::uint64_t violations;
  const char* report;
};

std::ostream& operator<<(std::ostream& out, const Case& c) { return out << c.name; }

StreamBenchOptions options_of(const Case& c) {
  StreamBenchOptions options = throttled(c.source, c.sink);
  options.stall_limit = 2000;
  return options;
}

void run(StreamBench& bench) {
  loop_back(bench, 4, random_beats(kBeats, 1));
  bench.run();
}

class PlantedFlaw : public testing::TestWithParam<Case> {};

TEST_P(PlantedFlaw, IsCaught) {
  const Case& c = GetParam();
  LoopbackCore core(5, c.flaw);
  StreamBench bench(core, options_of(c));
  run(bench);
  EXPECT_FALSE(bench.finish());
  EXPECT_EQ(bench.scoreboard().checked(), c.checked);
  EXPECT_EQ(bench.scoreboard().mismatches(), c.mismatches);
  EXPECT_EQ(bench.scoreboard().extra(), c.extra);
  EXPECT_EQ(bench.checker().violations(), c.violations);
  EXPECT_NE(bench.report().find(c.report), std::string::npos) << bench.report();
}

TEST_P(PlantedFlaw, IsTheOnlyReason) {
  const Case& c = GetParam();
  LoopbackCore core(5);
  StreamBench bench(core, options_of(c));
  run(bench);
  EXPECT_TRUE(bench.finish()) << bench.report();
  EXPECT_EQ(bench.scoreboard().checked(), kBeats);
}

// The scoreboard stops at 20 reports: a stream out of step from its first beat is 20 wrong beats.
const Case kCases[] = {
    {"payload_changes", Flaw::kPayloadChanges, "always", "bursts", kBeats, 1, 0, 1,
     "output changed while it waited"},
    {"valid_drops", Flaw::kValidDrops, "always", "bursts", kBeats, 0, 0, 1,
     "output valid fell before the beat was accepted"},
    {"idle_too_soon", Flaw::kIdleTooSoon, "sparse", "always", kBeats, 0, 0, 1,
     "the core was idle, no beat was offered, and something is inside"},
    {"valid_in_reset", Flaw::kValidInReset, "always", "always", kBeats, 0, 0, 3,
     "cycle 1: output valid is high in reset"},
    {"ready_in_reset", Flaw::kReadyInReset, "always", "always", kBeats, 0, 0, 3,
     "cycle 1: input ready is high in reset"},
    {"valid_after_reset", Flaw::kValidAfterReset, "always", "always", 20, 20, 0, 1,
     "output valid is high in the first cycle after reset"},
    {"loses_beat", Flaw::kLosesBeat, "gaps", "bernoulli", kBeats - 1, kAfterFlaw - 1, 0, 0,
     "1 of 25 beats are missing"},
    {"duplicates_beat", Flaw::kDuplicatesBeat, "gaps", "bernoulli", kBeats, kAfterFlaw - 1, 1, 0,
     "1 beats too many"},
    {"swaps_beats", Flaw::kSwapsBeats, "bursts", "bursts", kBeats, 2, 0, 0, "beat 10, cycle"},
    {"flips_bit", Flaw::kFlipsBit, "bursts", "bursts", kBeats, 1, 0, 0,
     "differs in word 2 by 80000000"},
    {"flips_last", Flaw::kFlipsLast, "bursts", "bursts", kBeats, 1, 0, 0, "differs in last"},
    {"samples_late", Flaw::kSamplesLate, "sparse", "always", 20, 20, 0, 1, "beat 0, cycle"},
    {"stops_output", Flaw::kStopsOutput, "always", "always", 10, 0, 0, 0,
     "watchdog: no beat moved for 2000 cycles; input beats accepted 25, waiting 0; results "
     "received 10, outstanding 15"},
    {"stops_input", Flaw::kStopsInput, "always", "always", 10, 0, 0, 0,
     "15 input beats were never accepted"},
    {"extra_beat", Flaw::kExtraBeat, "always", "always", kBeats, 0, 1, 1, "unexpected"},
    {"loses_first_after_reset", Flaw::kLosesFirstAfterReset, "always", "always", 20, 20, 0, 0,
     "beat 0, cycle"},
};

INSTANTIATE_TEST_SUITE_P(Flaws, PlantedFlaw, testing::ValuesIn(kCases), test::by_name);

TEST(Watchdog, LimitsTheWholeRun) {
  LoopbackCore core(5);
  StreamBenchOptions options;
  options.cycle_limit = 50;
  StreamBench bench(core, options);
  loop_back(bench, 1, random_beats(100, 1));
  EXPECT_FALSE(bench.run());
  EXPECT_EQ(bench.cycle(), 51u);
  EXPECT_NE(bench.report().find("no end after 50 cycles"), std::string::npos) << bench.report();
  EXPECT_FALSE(bench.run());  // no second wait for a core that hangs
  EXPECT_EQ(bench.cycle(), 51u);
}

TEST(Watchdog, AllowsARunThatEndsAtTheLimit) {
  LoopbackCore core(5);
  StreamBenchOptions options;
  options.cycle_limit = 106;  // one idle cycle after reset, 100 beats, latency 5
  StreamBench bench(core, options);
  loop_back(bench, 1, random_beats(100, 1));
  EXPECT_TRUE(bench.run()) << bench.report();
}

/// Offers one and the same beat for ever, and takes any.
class ChatteringCore : public cores::StreamCore {
 public:
  void drive_reset(bool asserted) override { reset_ = asserted; }
  void drive_input(bool, const Beat&) override {}
  void drive_output_ready(bool) override {}
  void settle() override {}
  void clock() override { valid_q_ = !reset_; }
  bool input_ready() const override { return valid_q_; }
  bool output_valid() const override { return valid_q_; }
  Beat output() const override { return {}; }
  bool idle() const override { return false; }

 private:
  bool reset_ = false;
  bool valid_q_ = false;
};

TEST(Watchdog, ACoreThatNeverEndsIsStoppedAtTwentyReports) {
  ChatteringCore core;
  StreamBench bench(core, {});
  bench.reset(2);
  bench.send({Beat{}});
  bench.expect({Beat{}});
  EXPECT_FALSE(bench.run());
  EXPECT_EQ(bench.scoreboard().checked(), 1u);
  EXPECT_EQ(bench.scoreboard().extra(), 20u);
  EXPECT_EQ(bench.cycle(), 2u + 1 + 21);
  bench.run_for(100);
  EXPECT_EQ(bench.cycle(), 2u + 1 + 21);
}

TEST(Watchdog, TwentyViolationsStopTheRun) {
  LoopbackCore core(5, Flaw::kReadyFollowsValid);
  StreamBenchOptions options;
  options.probe_edges = true;
  StreamBench bench(core, options);
  loop_back(bench, 2, random_beats(500, 1));
  EXPECT_FALSE(bench.run());
  EXPECT_EQ(bench.checker().violations(), 20u);
  EXPECT_EQ(bench.checker().reports().size(), 20u);
}

TEST(Verdict, InputThatWasNeverAcceptedIsAFailure) {
  LoopbackCore core(5, Flaw::kStopsInput);
  StreamBench bench(core, {});
  const auto beats = random_beats(25, 1);
  bench.reset(2);
  bench.send(beats);
  bench.expect({beats.begin(), beats.begin() + 10});
  bench.run_for(200);
  EXPECT_TRUE(bench.ok());
  EXPECT_EQ(bench.scoreboard().checked(), 10u);
  EXPECT_FALSE(bench.finish());
  EXPECT_TRUE(bench.scoreboard().ok());
  EXPECT_NE(bench.report().find("15 input beats were never accepted"), std::string::npos);
}

bool raises_valid(Flaw flaw) {
  LoopbackCore core(5, flaw);
  StreamBench bench(core, {});
  loop_back(bench, 1, random_beats(kBeats, 1));
  const bool raised = bench.raises_valid_without_ready(500, 100);
  // One cycle of reset; refused once, accepted, latency 5, seen, held for 100.
  EXPECT_EQ(bench.cycle(), raised ? 1u + 7 + 100 : 1u + 500);
  EXPECT_TRUE(bench.results().empty());  // ready was low throughout
  bench.run();
  EXPECT_EQ(bench.finish(), raised) << bench.report();
  EXPECT_EQ(bench.scoreboard().checked(), kBeats);
  EXPECT_EQ(bench.report().find("output valid did not rise in 500 cycles with ready held low") ==
                std::string::npos,
            raised);
  return raised;
}

TEST(ValidWithoutReady, IsRequired) {
  EXPECT_TRUE(raises_valid(Flaw::kNone));
  EXPECT_FALSE(raises_valid(Flaw::kValidWaitsForReady));
  EXPECT_FALSE(raises_valid(Flaw::kValidFollowsReady));
}

std::string probe_edges(Flaw flaw) {
  LoopbackCore core(5, flaw);
  StreamBenchOptions options;
  options.probe_edges = true;
  StreamBench bench(core, options);
  run(bench);
  EXPECT_EQ(bench.finish(), flaw == Flaw::kNone);
  EXPECT_EQ(bench.checker().violations() == 0, flaw == Flaw::kNone);
  return bench.report();
}

TEST(Edges, AreRegistered) {
  probe_edges(Flaw::kNone);
  EXPECT_NE(probe_edges(Flaw::kReadyFollowsValid).find("input ready depends on an input"),
            std::string::npos);
  EXPECT_NE(probe_edges(Flaw::kDataFollowsReady).find("output data depends on an input"),
            std::string::npos);
  EXPECT_NE(probe_edges(Flaw::kValidFollowsReady).find("output valid depends on an input"),
            std::string::npos);
}

// The faults that the bench plants itself, for a test of a core that has none.
struct FaultCase {
  Fault fault;
  std::uint64_t mismatches;
  std::uint64_t extra;
  std::uint64_t checked;
};

TEST(DeliberateFault, IsCaught) {
  const FaultCase cases[] = {
      {{Fault::Kind::kFlip, 7, 0}, 1, 0, kBeats},
      {{Fault::Kind::kFlip, 24, 127}, 1, 0, kBeats},
      {{Fault::Kind::kFlip, 0, 128}, 1, 0, kBeats},
      {{Fault::Kind::kDrop, 20, 0}, 4, 0, kBeats - 1},
      {{Fault::Kind::kDrop, 24, 0}, 0, 0, kBeats - 1},
      {{Fault::Kind::kDuplicate, 20, 0}, 4, 1, kBeats},
      {{Fault::Kind::kDuplicate, 24, 0}, 0, 1, kBeats},
  };
  for (const FaultCase& c : cases) {
    LoopbackCore core(5);
    StreamBenchOptions options;
    options.stall_limit = 500;
    StreamBench bench(core, options);
    bench.plant(c.fault);
    EXPECT_FALSE(bench.fault_struck());
    run(bench);
    EXPECT_TRUE(bench.fault_struck());
    EXPECT_FALSE(bench.finish());
    EXPECT_EQ(bench.scoreboard().mismatches(), c.mismatches);
    EXPECT_EQ(bench.scoreboard().extra(), c.extra);
    EXPECT_EQ(bench.scoreboard().checked(), c.checked);
    EXPECT_EQ(bench.checker().violations(), 0u);
  }
}

TEST(DeliberateFault, FlipsTheBitItNames) {
  for (unsigned bit = 0; bit <= 128; ++bit) {
    FaultInjector injector({Fault::Kind::kFlip, 1, bit});
    Beat beat;
    EXPECT_EQ(injector.pass(beat), 1u);
    EXPECT_EQ(beat, Beat{});
    EXPECT_EQ(injector.pass(beat), 1u);
    Beat wanted;
    if (bit == 128) {
      wanted.last = true;
    } else {
      wanted.words.at(bit / 32) = 1u << (bit % 32);
    }
    EXPECT_EQ(beat, wanted) << bit;
  }
}

TEST(DeliberateFault, BeyondTheEndDoesNotStrike) {
  LoopbackCore core(5);
  StreamBench bench(core, {});
  bench.plant({Fault::Kind::kDrop, kBeats, 0});
  run(bench);
  EXPECT_FALSE(bench.fault_struck());
  EXPECT_TRUE(bench.finish()) << bench.report();
  EXPECT_THROW(bench.plant({Fault::Kind::kFlip, 0, 129}), std::invalid_argument);
}

}  // namespace
}  // namespace hwffd::tb
