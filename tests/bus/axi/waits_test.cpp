// Counts of waits: each is, to the clock, what the bench counts of the same strobes and pins.
#include <gtest/gtest.h>
#include <verilated_syms.h>

#include "Vaxi_waits.h"
#include "axi_run.hpp"
#include "hwffd/cores/verilated_axi_core.hpp"
#include "hwffd/stream/blending.hpp"

namespace hwffd::test {
namespace {

constexpr unsigned kWidth = 11;  // COUNT_WIDTH in tests/bus/axi/CMakeLists.txt

const Configuration& waits_row() { return find_configuration("basic-fx18-overlapped"); }

/// A core that counts what its bus does, and what is inside it (waits.vlt).
class CountingCore final : public cores::AxiCore {
 public:
  CountingCore(std::uint64_t seed, CoreWaits& waits) : core_(seed), waits_(waits) {
    const VerilatedScope* scope = core_.dut().contextp()->scopeFind("TOP.hwffd_axi.u_core");
    core_wait_ = static_cast<const CData*>(scope->varFind("core_wait")->datap());
    starved_ = static_cast<const CData*>(scope->varFind("starved")->datap());
  }
  void exchange(bool in_reset, cores::AxiLitePins& registers, cores::AxiPins& bus) override {
    core_.exchange(in_reset, registers, bus);
    if (in_reset) {
      waits_ = {};
      reads_ = writes_ = 0;
      return;
    }
    waits_.input += *starved_ & 1;
    waits_.memory += *core_wait_ & 1;
    waits_.evaluator += *core_wait_ >> 1 & 1;
    waits_.read += reads_ > 0 && !bus.r.valid ? 1 : 0;
    waits_.write += writes_ > 0 && !bus.b.valid ? 1 : 0;
    reads_ += bus.ar.valid && bus.ar.ready ? 1 : 0;
    reads_ -= bus.r.valid && bus.r.last ? 1 : 0;
    writes_ += bus.w.valid && bus.w.ready && bus.w.last ? 1 : 0;
    writes_ -= bus.b.valid ? 1 : 0;
  }
  void clock() override { core_.clock(); }
  bool interrupt() const override { return core_.interrupt(); }

 private:
  cores::VerilatedAxiCore<Vaxi_waits> core_;
  CoreWaits& waits_;
  const CData* core_wait_;
  const CData* starved_;
  int reads_ = 0, writes_ = 0;
};

class AxiWaits : public ::testing::TestWithParam<std::string> {
 protected:
  void expect_counted() {
    const CoreWaits got = run_.driver().waits();
    const auto same = [](std::uint32_t a, std::uint32_t b) {
      return ((a ^ b) << (32 - kWidth)) == 0;
    };
    EXPECT_TRUE(same(got.input, counted_.input)) << got.input << " " << counted_.input;
    EXPECT_TRUE(same(got.memory, counted_.memory)) << got.memory << " " << counted_.memory;
    EXPECT_TRUE(same(got.evaluator, counted_.evaluator))
        << got.evaluator << " " << counted_.evaluator;
    EXPECT_TRUE(same(got.read, counted_.read)) << got.read << " " << counted_.read;
    EXPECT_TRUE(same(got.write, counted_.write)) << got.write << " " << counted_.write;
    EXPECT_EQ(run_.system().read32(HWFFD_WAIT_FORMING_OFFSET), 0U);
  }

  CoreWaits counted_;
  AxiRun run_{waits_row(), std::make_unique<CountingCore>(1, counted_), 1, GetParam()};
};

TEST_P(AxiWaits, AreCountedToTheClock) {
  EXPECT_EQ(run_.driver().probe().count_width, kWidth);
  CoreWaits most;
  for (int repeat = 0; repeat < 4; ++repeat) {
    run_.send_bspline();
    run_.send_lattice(8);
    run_.send_vertices(40);
    for (int packet = 0; packet < 3; ++packet) {  // each waits for the vertices before it
      run_.send_vertices(3);
      run_.send_bspline();
      run_.send_lattice(5);
    }
    run_.send(interleaved_packet(make_stimulus("random", run_.codec(), 6, run_.random().bits())));
    ASSERT_TRUE(run_.go());
    expect_counted();
    if (repeat == 1) {
      run_.driver().clear_counters();
      const CoreWaits none = run_.driver().waits();
      EXPECT_EQ(none.input + none.memory + none.evaluator + none.read + none.write, 0U);
      most = counted_;
      counted_ = {};
    }
  }
  for (const std::uint32_t count :
       {most.input, most.memory, most.evaluator, most.read, most.write}) {
    EXPECT_GT(count, 0U);
  }
  EXPECT_GT(most.evaluator, 1U << kWidth) << "some count wraps";
  EXPECT_TRUE(run_.clean());
}
INSTANTIATE_TEST_SUITE_P(, AxiWaits, ::testing::Values("always", "mixed", "bursts"), by_name);

TEST(AxiWaitsNot, ACoreWithoutThemSaysSo) {
  AxiRun run(find_configuration("basic-fx18-overlapped"), 1);
  EXPECT_EQ(run.driver().probe().count_width, 0U);
  EXPECT_THROW(run.driver().waits(), DriverError);
  EXPECT_THROW(run.system().read32(HWFFD_WAIT_INPUT_OFFSET), RegisterError);
  EXPECT_TRUE(run.ends_well());
}

}  // namespace
}  // namespace hwffd::test
