// The clock of the core is stopped, at random, wherever it may be: nothing is lost, and results,
// bus and registers are those of a clock that runs.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include "Vaxi_guarded.h"
#include "Vaxi_waits.h"
#include "axi_run.hpp"
#include "hwffd/cores/verilated_axi_core.hpp"

namespace hwffd::test {
namespace {

/// How the clock is stopped: by the rule, or without looking at the requests that come.
enum class Rule { kDocumented, kDeaf };

/// A core whose clock stands still in that share of the clocks in which it may.
template <class VDut>
class SleepyCore final : public cores::AxiCore {
 public:
  SleepyCore(std::uint64_t seed, double share, std::uint64_t& stopped, Rule rule)
      : core_(seed), random_(seed + 1), share_(share), stopped_(stopped), rule_(rule) {}

  void exchange(bool in_reset, cores::AxiLitePins& registers, cores::AxiPins& bus) override {
    core_.exchange(in_reset, registers, bus);
    const cores::AxiLiteMasterPins& asks = registers.master;
    const bool asked = asks.awvalid || asks.wvalid || asks.arvalid;
    may_stop_ = core_.dut().sleep_o != 0 && !in_reset && (rule_ == Rule::kDeaf || !asked);
    if (may_stop_) {
      EXPECT_FALSE(bus.ar.valid || bus.aw.valid || bus.w.valid) << "it sleeps with a request open";
    }
  }
  void clock() override {
    const bool stop = may_stop_ && random_.chance(share_);
    stopped_ += stop ? 1 : 0;
    if (!stop) core_.clock();
  }
  bool interrupt() const override { return core_.interrupt(); }

 private:
  cores::VerilatedAxiCore<VDut> core_;
  tb::Random random_;
  double share_;
  std::uint64_t& stopped_;
  Rule rule_;
  bool may_stop_ = false;
};

template <class VDut>
std::unique_ptr<cores::AxiCore> sleepy(std::uint64_t seed, double share, std::uint64_t& stopped,
                                       Rule rule = Rule::kDocumented) {
  return std::make_unique<SleepyCore<VDut>>(seed, share, stopped, rule);
}

const Configuration& sleepy_row() { return find_configuration("basic-fx18-overlapped"); }

class AxiSleep : public ::testing::TestWithParam<std::string> {};
INSTANTIATE_TEST_SUITE_P(, AxiSleep, ::testing::Values("always", "mixed", "sparse"), by_name);

TEST_P(AxiSleep, LosesNothing) {
  std::uint64_t stopped = 0;
  for (const double share : {1.0, 0.9, 0.3}) {
    AxiRun run(sleepy_row(), sleepy<Vaxi_waits>(1, share, stopped), 1, GetParam());
    run.send_bspline();
    for (int repeat = 0; repeat < 3; ++repeat) {
      run.send(random_packets(run.codec(), run.random(), 12));
      ASSERT_TRUE(run.go()) << share << ", run " << repeat;
      EXPECT_TRUE(run.system().interrupt());
      run.system().run(run.random().below(200));
      EXPECT_EQ(run.driver().counters().vertices, run.model().vertices());
      run.driver().take_interrupts();
      run.system().run(run.random().below(200));
      EXPECT_FALSE(run.system().interrupt());
    }
    run.driver().take_errors();
    ASSERT_TRUE(run.soft_reset());
    EXPECT_TRUE(run.ends_well()) << share;
  }
  EXPECT_GT(stopped, 500U);
  fmt::print("{} clocks stopped\n", stopped);
}

/// Counts are those of the clocks that ran; none is left half counted.
TEST(AxiSleeps, CountsAreThoseOfAClockThatRuns) {
  CoreCounters counters[2];
  CoreWaits waits[2];
  for (const bool sleeps : {false, true}) {
    std::uint64_t stopped = 0;
    AxiRun run(sleepy_row(), sleepy<Vaxi_waits>(3, sleeps ? 1 : 0, stopped), 3);
    run.send_scene(40, 6);
    ASSERT_TRUE(run.go());
    run.system().run(500);
    EXPECT_EQ(stopped > 400, sleeps);
    counters[sleeps] = run.driver().counters();
    waits[sleeps] = run.driver().waits();
  }
  EXPECT_EQ(counters[0].busy, counters[1].busy);
  EXPECT_EQ(counters[0].vertices, counters[1].vertices);
  EXPECT_EQ(waits[0].input, waits[1].input);
  EXPECT_EQ(waits[0].read, waits[1].read);
  EXPECT_EQ(waits[0].write, waits[1].write);
}

/// A clock that does not run for a request loses it: these tests would see it.
TEST(AxiSleeps, TheRequestMustWakeIt) {
  std::uint64_t stopped = 0;
  EXPECT_ANY_THROW({
    AxiRun run(find_configuration("basic-fx18-overlapped"),
               sleepy<Vaxi_guarded>(1, 1, stopped, Rule::kDeaf), 1);
    run.system().protect(0);
    run.system().run(100);
    run.driver().probe();
  });
  EXPECT_GT(stopped, 50U);
}

}  // namespace
}  // namespace hwffd::test
