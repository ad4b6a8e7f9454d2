// The clock of hwffd_stream is stopped, at random, wherever idle_o allows it: no beat is lost, and
// results and events are those of a clock that runs.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "bad_packets.hpp"
#include "hwffd/stream/grid.hpp"
#include "hwffd/stream/packed.hpp"
#include "page_run.hpp"
#include "stimulus.hpp"

namespace hwffd::test {
namespace {

/// A core whose clock stands still in half of the clocks in which it may: idle, and no beat
/// offered.
class SleepyCore final : public cores::StreamCore {
 public:
  /// @param deaf  it does not look whether a beat is offered
  SleepyCore(const PageBuild& build, std::uint64_t seed, bool deaf, std::uint64_t& stopped)
      : core_(build.make(seed)), random_(seed + 1), deaf_(deaf), stopped_(stopped) {}

  void drive_reset(bool asserted) override {
    in_reset_ = asserted;
    core_->drive_reset(asserted);
  }
  void drive_input(bool valid, const Beat& beat) override {
    offered_ = valid;
    core_->drive_input(valid, beat);
  }
  void drive_output_ready(bool ready) override { core_->drive_output_ready(ready); }
  void settle() override { core_->settle(); }
  void clock() override {
    const bool may = core_->idle() && !in_reset_ && (deaf_ || !offered_);
    const bool stop = may && random_.chance(0.5);
    stopped_ += stop ? 1 : 0;
    if (!stop) core_->clock();
  }
  bool input_ready() const override { return core_->input_ready(); }
  bool output_valid() const override { return core_->output_valid(); }
  Beat output() const override { return core_->output(); }
  std::uint32_t events() const override { return core_->events(); }
  bool idle() const override { return core_->idle(); }

 private:
  std::unique_ptr<cores::StreamCore> core_;
  tb::Random random_;
  bool deaf_;
  std::uint64_t& stopped_;
  bool in_reset_ = true, offered_ = false;
};

/// Packets of every kind with pauses between them: whether all was right.
::testing::AssertionResult run_stopping(const std::string& name, bool deaf,
                                        std::uint64_t& stopped) {
  const std::vector<PageBuild> builds = page_builds();
  const PageBuild& build = *std::find_if(builds.begin(), builds.end(),
                                         [&](const PageBuild& b) { return b.name == name; });
  const Configuration& row = find_configuration(build.row);
  const WordCodec codec(row.format);
  for (std::uint64_t seed = 1; seed <= 3; ++seed) {
    SleepyCore core(build, seed, deaf, stopped);
    tb::StreamBenchOptions options;
    options.test = {name, seed, "SEED=" + std::to_string(seed)};
    options.source_throttle = "bernoulli";
    options.sink_throttle = seed == 1 ? "always" : "bursts";
    tb::StreamBench bench(core, options);
    model::StreamModel model(row, build.core.features);
    tb::Random random(seed);
    bench.reset(3);
    for (int round = 0; round < 30; ++round) {
      const auto send = [&](const std::vector<Beat>& beats) {
        bench.send(beats);
        bench.expect(model.run(beats));
      };
      send(coefficients_packet(watertight_bspline(codec), codec));
      send(random_packets(codec, random, 2));
      send(vertices_packet(random_vertices(codec, random, {6, 6, 6}, 2, true)));
      send(interleaved_packet(make_stimulus("extreme", codec, 1, seed)));
      send(grid_packet(grid_between({0, 0, 0}, {0.5, 1, 1}, {2, 1, 1 + round % 3})));
      send(packed_packet(std::vector<PackedVertex>(1 + round % 3)));
      bench.run_for(random.below(2000));
    }
    bench.run();
    if (!bench.finish()) return ::testing::AssertionFailure() << bench.report();
    if (bench.events() != model.events()) return ::testing::AssertionFailure() << "events";
  }
  return ::testing::AssertionSuccess();
}

TEST(Sleep, AStoppedClockLosesNothing) {
  std::uint64_t stopped = 0;
  EXPECT_TRUE(run_stopping("cg1_derivatives", false, stopped));
  EXPECT_GT(stopped, 1000U);
  std::uint64_t more = 0;
  EXPECT_TRUE(run_stopping("tree8_interleaved", false, more));
  EXPECT_GT(more, 1000U);
  std::uint64_t most = 0;
  EXPECT_TRUE(run_stopping("cg1_expanded", false, most));
  EXPECT_GT(most, 500U);
  fmt::print("{} clocks stopped\n", stopped + more + most);
}

TEST(Sleep, ABeatMustWakeIt) {
  std::uint64_t stopped = 0;
  EXPECT_FALSE(run_stopping("tree8_interleaved", true, stopped));
}

}  // namespace
}  // namespace hwffd::test
