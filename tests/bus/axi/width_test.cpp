// hwffd_axi with memory ports of 64 and 256 bits, and hardened at all three widths: results are the
// model's, and faults of the bus end as they do at 128.
#include <gtest/gtest.h>

#include "Vaxi_hardened128.h"
#include "Vaxi_hardened256.h"
#include "Vaxi_hardened64.h"
#include "Vaxi_narrow.h"
#include "Vaxi_wide.h"
#include "axi_run.hpp"
#include "hwffd/cores/verilated_axi_core.hpp"

namespace hwffd::test {
namespace {

constexpr std::uint64_t kTimeout = 400;
constexpr std::uint64_t kNever = std::uint64_t{1} << 60;

using CorePtr = std::unique_ptr<cores::AxiCore>;

/// @param edges  two where tests/bus/axi/CMakeLists.txt says RESET_REGISTER
template <class VDut, unsigned edges = 1>
CorePtr make_core(std::uint64_t seed) {
  return std::make_unique<cores::VerilatedAxiCore<VDut>>(seed, edges);
}

struct Port {
  const char* name;
  CorePtr (*make)(std::uint64_t seed);
};
void PrintTo(const Port& port, std::ostream* out) { *out << port.name; }

/// Counts the clocks in which a read is open and no data is there.
class ReadCounter final : public cores::AxiCore {
 public:
  ReadCounter(CorePtr core, std::uint64_t& waits) : core_(std::move(core)), waits_(waits) {}
  void exchange(bool in_reset, cores::AxiLitePins& registers, cores::AxiPins& bus) override {
    core_->exchange(in_reset, registers, bus);
    if (in_reset) return;
    waits_ += reads_ > 0 && !bus.r.valid ? 1 : 0;
    reads_ += bus.ar.valid && bus.ar.ready ? 1 : 0;
    reads_ -= bus.r.valid && bus.r.ready && bus.r.last ? 1 : 0;
  }
  void clock() override { core_->clock(); }
  bool interrupt() const override { return core_->interrupt(); }
  unsigned data_width() const override { return core_->data_width(); }
  unsigned reset_edges() const override { return core_->reset_edges(); }

 private:
  CorePtr core_;
  std::uint64_t& waits_;
  int reads_ = 0;
};

class AxiWidth : public testing::TestWithParam<Port> {
 protected:
  static AxiRun make(std::uint64_t seed, const std::string& throttles = "always") {
    return {row(), GetParam().make(seed), seed, throttles};
  }
  static const Configuration& row() { return find_configuration("basic-fx18-overlapped"); }
  /// The memory is as new; so is the core.
  static void expect_next(AxiRun& run) {
    run.system().memory.set_throttles({});
    run.system().memory.fail_nothing();
    run.system().forget_bus();
    EXPECT_TRUE(run.ends_well());
  }
};
INSTANTIATE_TEST_SUITE_P(, AxiWidth,
                         testing::Values(Port{"64", make_core<Vaxi_narrow>},
                                         Port{"256", make_core<Vaxi_wide, 2>},
                                         Port{"hardened64", make_core<Vaxi_hardened64>},
                                         Port{"hardened128", make_core<Vaxi_hardened128>},
                                         Port{"hardened256", make_core<Vaxi_hardened256, 2>}),
                         by_name);

TEST_P(AxiWidth, AnyPacketsGiveTheModelsBits) {
  for (const std::string throttles : {"always", "gaps", "bernoulli", "bursts", "sparse"}) {
    AxiRun run = make(throttles.size(), throttles);
    run.send_bspline();
    for (int repeat = 0; repeat < 3; ++repeat) {
      run.send(random_packets(run.codec(), run.random(), 20));
      ASSERT_TRUE(run.go()) << throttles << ", run " << repeat;
    }
    EXPECT_EQ(run.driver().take_errors().status, run.model().error_status());
    EXPECT_TRUE(run.clean()) << throttles;
  }
}

TEST_P(AxiWidth, ASoftResetAtAnyMomentIsWhole) {
  AxiRun run = make(1, "bernoulli");
  for (std::uint64_t clock = 0; clock < 3000; clock += 1 + clock / 12) {
    run.send_scene(20);
    run.start();
    run.system().run(clock);
    ASSERT_TRUE(run.soft_reset()) << clock;
    EXPECT_TRUE(run.system().memory.quiet()) << clock;
    ASSERT_TRUE(run.good_run()) << clock;
  }
  EXPECT_TRUE(run.clean());
}

TEST_P(AxiWidth, AnErrorResponseEndsTheRun) {
  for (std::uint64_t beat = 0; beat < 9; ++beat) {
    for (const bool read : {true, false}) {
      AxiRun run = make(beat, "bernoulli");
      if (read) run.system().memory.fail_read_at(kBuffers.base, beat, cores::kAxiSlverr);
      if (!read) run.system().memory.fail_write(beat % 2, cores::kAxiDecerr);
      run.send_scene(20);
      run.start();
      ASSERT_TRUE(run.wait());
      const std::uint32_t status = run.driver().take_errors().status;
      EXPECT_NE(status & 1U << (read ? kDmaReadResponse : kDmaWriteResponse), 0U) << beat;
      EXPECT_GE(run.results_in_memory(), run.driver().result_count());
      ASSERT_TRUE(run.soft_reset());
      run.system().memory.fail_nothing();
      run.driver().take_errors();
      EXPECT_TRUE(run.ends_well());
    }
  }
}

/// A slave that breaks the rule of RLAST, or that answers no more on a channel.
TEST_P(AxiWidth, ABrokenSlaveIsOverWithASoftReset) {
  for (const std::uint64_t beat : {std::uint64_t{0}, std::uint64_t{2}, std::uint64_t{3}, kNever}) {
    for (std::uint64_t burst = 0; burst < 6; ++burst) {
      SCOPED_TRACE(testing::Message() << "burst " << burst << ", beat " << beat);
      AxiRun run = make(7 + burst);
      run.system().memory.misplace_last(burst, beat);
      run.send_scene(30);
      run.start();
      run.driver().wait_done(3000);
      run.system().memory.fail_nothing();
      ASSERT_TRUE(run.soft_reset());
      run.driver().take_errors();
      run.system().run(3 * kTimeout);
      expect_next(run);
      ASSERT_FALSE(HasFailure());
    }
  }
}

/// Clocks without read data are counted as the bus has them, and data that waits for rready is none
/// of them.
TEST_P(AxiWidth, WaitsForReadsAreCounted) {
  std::uint64_t waits = 0;
  AxiRun run(row(), std::make_unique<ReadCounter>(GetParam().make(3), waits), 3, "bernoulli");
  run.send_scene(40, 6);
  ASSERT_TRUE(run.go());
  const std::uint32_t counted = run.driver().waits().read;
  EXPECT_GT(counted, 0U);
  EXPECT_EQ(counted, waits);
  EXPECT_TRUE(run.clean());
}

}  // namespace
}  // namespace hwffd::test
