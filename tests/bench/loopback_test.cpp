// A faultless core passes under every pair of throttles, with the counts and clocks that it must
// have.
#include <gtest/gtest.h>

#include <string>
#include <tuple>
#include <vector>

#include "hwffd/tb/random.hpp"
#include "hwffd/tb/stream_bench.hpp"
#include "loopback_core.hpp"
#include "named.hpp"

namespace hwffd::tb {
namespace {

constexpr std::size_t kLoopbackBeats = 1500;

class LoopbackMatrix : public testing::TestWithParam<std::tuple<std::string, std::string>> {};

TEST_P(LoopbackMatrix, PassesWithAllCounts) {
  const auto& [source, sink] = GetParam();
  const std::uint64_t seed = seed_from_environment(1);
  for (const unsigned latency : {1u, 7u, 40u}) {
    LoopbackCore core(latency);
    StreamBenchOptions options = throttled(source, sink, seed);
    options.probe_edges = true;
    StreamBench bench(core, options);
    const auto beats = random_beats(kLoopbackBeats, seed);
    loop_back(bench, 3, beats);
    EXPECT_TRUE(bench.run());
    ASSERT_TRUE(bench.finish()) << bench.report();

    EXPECT_EQ(bench.scoreboard().checked(), kLoopbackBeats);
    EXPECT_EQ(bench.scoreboard().expected(), kLoopbackBeats);
    EXPECT_EQ(bench.checker().violations(), 0u);
    EXPECT_EQ(bench.results(), beats);
    const auto& in = bench.accept_clocks();
    const auto& out = bench.result_clocks();
    ASSERT_EQ(in.size(), kLoopbackBeats);
    ASSERT_EQ(out.size(), kLoopbackBeats);
    for (std::size_t i = 0; i < kLoopbackBeats; ++i) {
      ASSERT_GE(out[i], in[i] + latency) << "beat " << i;
      if (i == 0) continue;
      ASSERT_GT(in[i], in[i - 1]);
      ASSERT_GT(out[i], out[i - 1]);
    }
    EXPECT_LT(out.back(), bench.cycle());
    EXPECT_EQ(core.withdrawn(), 0u);
    EXPECT_EQ(core.idle_again(), 0u) << "idle data is random";
    if (core.idle_with(false) + core.idle_with(true) >= 100) {
      EXPECT_GT(core.idle_with(false), 20u);
      EXPECT_GT(core.idle_with(true), 20u);
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Throttles, LoopbackMatrix,
                         testing::Combine(testing::ValuesIn(throttle_names()),
                                          testing::ValuesIn(throttle_names())),
                         test::by_name);

double measure(Flaw flaw, const std::string& source, const std::string& sink) {
  LoopbackCore core(5, flaw);
  StreamBench bench(core, throttled(source, sink));
  loop_back(bench, 1, random_beats(401, 1));
  bench.run();
  EXPECT_TRUE(bench.finish()) << bench.report();
  return bench.clocks_per_result(10, 400);  // steady: without the offer at once after reset
}

TEST(Throughput, IsThatOfTheSlowestPart) {
  EXPECT_EQ(measure(Flaw::kNone, "always", "always"), 1.0);
  EXPECT_EQ(measure(Flaw::kNone, "sparse", "always"), 4.0);
  EXPECT_EQ(measure(Flaw::kNone, "always", "sparse"), 4.0);
  EXPECT_NEAR(measure(Flaw::kNone, "gaps", "always"), 4.0 / 3.0, 0.01);
  // A core at half rate computes every bit right; only its clocks betray it.
  EXPECT_EQ(measure(Flaw::kHalfRate, "always", "always"), 2.0);
}

TEST(Throughput, LatencyIsExact) {
  for (const unsigned latency : {1u, 2u, 33u}) {
    LoopbackCore core(latency);
    StreamBench bench(core, throttled("always", "always"));
    const auto beats = random_beats(20, 1);
    loop_back(bench, 2, beats);
    EXPECT_TRUE(bench.run());
    for (std::size_t i = 0; i < beats.size(); ++i) {
      EXPECT_EQ(bench.result_clocks().at(i) - bench.accept_clocks().at(i), latency);
    }
    EXPECT_EQ(bench.clocks_per_result(), 1.0);
  }
}

TEST(Throughput, NeedsTwoResults) {
  LoopbackCore core(1);
  StreamBench bench(core, throttled("always", "always"));
  EXPECT_THROW(bench.clocks_per_result(), std::out_of_range);
  loop_back(bench, 1, random_beats(1, 1));
  EXPECT_TRUE(bench.run());
  EXPECT_THROW(bench.clocks_per_result(), std::out_of_range);
  EXPECT_THROW(bench.clocks_per_result(0, 1), std::out_of_range);
}

TEST(Progress, RisesToOne) {
  LoopbackCore core(3);
  StreamBench bench(core, throttled("bursts", "bernoulli"));
  const auto beats = random_beats(1000, 1);
  std::vector<double> seen;
  bench.on_progress([&seen](double done) { seen.push_back(done); });
  loop_back(bench, 1, beats);
  EXPECT_TRUE(bench.run());
  ASSERT_GT(seen.size(), 50u);
  ASSERT_LE(seen.size(), 101u);
  for (std::size_t i = 1; i < seen.size(); ++i) EXPECT_GT(seen[i], seen[i - 1]);
  EXPECT_EQ(seen.back(), 1.0);
}

TEST(Bench, RunsSeveralTimes) {
  LoopbackCore core(3);
  StreamBench bench(core, throttled("bursts", "bursts"));
  bench.reset(1);
  for (std::uint64_t part = 0; part < 5; ++part) {
    loop_back(bench, random_beats(50, part));
    EXPECT_TRUE(bench.run());
    EXPECT_EQ(bench.result_clocks().size(), 50 * (part + 1));
  }
  EXPECT_TRUE(bench.finish()) << bench.report();
  EXPECT_EQ(bench.scoreboard().checked(), 250u);
}

TEST(Bench, KeepsNoRecordWhenAsked) {
  LoopbackCore core(3);
  auto options = throttled("always", "always");
  options.record = false;
  StreamBench bench(core, options);
  loop_back(bench, 1, random_beats(50, 1));
  bench.run();
  EXPECT_TRUE(bench.finish()) << bench.report();
  EXPECT_EQ(bench.scoreboard().checked(), 50u);
  EXPECT_EQ(bench.monitor().count(), 50u);
  EXPECT_TRUE(bench.results().empty());
  EXPECT_TRUE(bench.result_clocks().empty());
  EXPECT_TRUE(bench.accept_clocks().empty());
}

TEST(Bench, TheSameSeedGivesTheSameClocks) {
  std::vector<std::vector<std::uint64_t>> clocks;
  for (const std::uint64_t seed : {7u, 7u, 8u}) {
    LoopbackCore core(3);
    StreamBench bench(core, throttled("bursts", "bernoulli", seed));
    loop_back(bench, 1, random_beats(200, 1));
    EXPECT_TRUE(bench.run());
    clocks.push_back(bench.result_clocks());
  }
  EXPECT_EQ(clocks[0], clocks[1]);
  EXPECT_NE(clocks[0], clocks[2]);
}

/// Notes when it is offered a beat and when its results are wanted.
class PatternRecorder : public LoopbackCore {
 public:
  PatternRecorder() : LoopbackCore(1) {}
  void drive_input(bool valid, const Beat& beat) override {
    offered += valid ? '1' : '0';
    LoopbackCore::drive_input(valid, beat);
  }
  void drive_output_ready(bool ready) override {
    wanted += ready ? '1' : '0';
    LoopbackCore::drive_output_ready(ready);
  }
  std::string offered;
  std::string wanted;
};

TEST(Bench, SourceAndSinkAreUnrelated) {
  PatternRecorder core;
  StreamBench bench(core, throttled("bernoulli", "bernoulli"));
  loop_back(bench, 1, random_beats(200, 1));
  bench.run_for(100);
  unsigned equal = 0;
  for (std::size_t i = 10; i < 100; ++i) equal += core.offered[i] == core.wanted[i] ? 1 : 0;
  EXPECT_GT(equal, 20u);
  EXPECT_LT(equal, 70u);
}

TEST(Bench, WantsAResetFirst) {
  LoopbackCore core(1);
  StreamBench bench(core, throttled("always", "always"));
  EXPECT_THROW(bench.run(), std::logic_error);
  EXPECT_THROW(bench.run_for(1), std::logic_error);
  EXPECT_THROW(bench.raises_valid_without_ready(1), std::logic_error);
  EXPECT_THROW(bench.reset(0), std::invalid_argument);
  EXPECT_THROW(StreamBench(core, throttled("never", "always")), std::invalid_argument);
}

}  // namespace
}  // namespace hwffd::tb
