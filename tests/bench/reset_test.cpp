// Reset in mid-stream, and the first cycle after it.
#include <gtest/gtest.h>

#include "hwffd/tb/stream_bench.hpp"
#include "loopback_core.hpp"

namespace hwffd::tb {
namespace {

StreamBenchOptions options(bool offer_at_once = true) {
  StreamBenchOptions result = throttled("bursts", "bernoulli", 3);
  result.stall_limit = 2000;
  result.offer_at_once = offer_at_once;
  return result;
}

/// Cuts a stream after `cut` cycles, then streams again; returns the beats checked in all, or -1
/// when the bench failed.
std::int64_t restart(Flaw flaw, std::uint64_t cut) {
  LoopbackCore core(9, flaw);
  StreamBench bench(core, options());
  loop_back(bench, 2, random_beats(200, 1));
  bench.run_for(cut);
  EXPECT_EQ(bench.cycle(), cut + 2);
  const auto before = bench.scoreboard().checked();
  EXPECT_EQ(before, bench.results().size());
  EXPECT_LT(before, 200u);

  bench.reset(3);
  EXPECT_EQ(bench.scoreboard().outstanding(), 0u);
  EXPECT_EQ(bench.scoreboard().expected(), before);
  EXPECT_EQ(bench.driver().waiting(), 0u);
  EXPECT_TRUE(bench.results().empty());
  EXPECT_TRUE(bench.accept_clocks().empty());
  EXPECT_FALSE(bench.finish()) << "nothing was checked after the reset";

  const auto beats = random_beats(100, 2);
  loop_back(bench, beats);
  bench.run();
  if (!bench.finish()) return -1;
  EXPECT_EQ(bench.results(), beats);
  EXPECT_EQ(bench.scoreboard().expected(), before + 100);
  return static_cast<std::int64_t>(bench.scoreboard().checked() - before);
}

TEST(Reset, RestartsClean) {
  for (std::uint64_t cut = 0; cut < 150; ++cut) EXPECT_EQ(restart(Flaw::kNone, cut), 100);
}

TEST(Reset, BeatsThatSurviveAreCaught) {
  EXPECT_EQ(restart(Flaw::kKeepsBeatsOverReset, 0), 100);  // nothing was in flight
  unsigned caught = 0;
  for (std::uint64_t cut = 20; cut < 120; ++cut) {
    caught += restart(Flaw::kKeepsBeatsOverReset, cut) == -1 ? 1 : 0;
  }
  EXPECT_GT(caught, 90u);
}

TEST(Reset, EndsAHangingRun) {
  LoopbackCore core(9, Flaw::kStopsOutput);
  StreamBench bench(core, options());
  loop_back(bench, 2, random_beats(20, 1));
  EXPECT_FALSE(bench.run());
  loop_back(bench, 2, random_beats(5, 1));
  EXPECT_FALSE(bench.run());  // it runs, but the failure is not forgotten
  EXPECT_EQ(bench.results().size(), 5u);
  EXPECT_FALSE(bench.finish());
}

/// A core that only notes when it is first offered a beat, and what it sees in reset.
class OfferRecorder : public LoopbackCore {
 public:
  OfferRecorder() : LoopbackCore(1) {}
  void drive_reset(bool asserted) override {
    in_reset_ = asserted;
    LoopbackCore::drive_reset(asserted);
  }
  void drive_input(bool valid, const Beat& beat) override {
    if (in_reset_ && valid) ++valid_in_reset;
    if (!in_reset_ && first_offer < 0) {
      if (valid) {
        first_offer = cycles_;
      } else {
        ++cycles_;
      }
    }
    LoopbackCore::drive_input(valid, beat);
  }
  int first_offer = -1;
  unsigned valid_in_reset = 0;

 private:
  bool in_reset_ = false;
  int cycles_ = 0;
};

TEST(Reset, FirstBeatIsOfferedInTheFirstCycle) {
  for (const bool at_once : {true, false}) {
    OfferRecorder core;
    StreamBench bench(core, options(at_once));
    bench.throttle_source(Throttle::sparse(5));
    // The throttle's first two cycles: the willing one is spent.
    loop_back(bench, 2, random_beats(5, 1));
    EXPECT_TRUE(bench.run());
    EXPECT_TRUE(bench.finish()) << bench.report();
    EXPECT_EQ(core.first_offer, at_once ? 0 : 3);
    EXPECT_EQ(core.valid_in_reset, 0u);
  }
}

}  // namespace
}  // namespace hwffd::tb
