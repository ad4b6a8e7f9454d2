// hwffd_wishbone, whole: the driver class works it as it works hwffd_axi, and results in memory are
// those of the model bit for bit.
#include <gtest/gtest.h>

#include "Vwishbone.h"
#include "axi_run.hpp"
#include "grid_stop.hpp"
#include "hwffd/cores/verilated_axi_core.hpp"
#include "wishbone_master.hpp"

namespace hwffd::test {
namespace {

/// Registers as the bench knows them, AXI4-Lite, in front of a Wishbone master: one access at a
/// time, a write where both are asked for.
class Bridge {
 public:
  explicit Bridge(std::uint64_t seed) : master_(seed, 0.5) {}

  const cores::WishboneMasterPins& drive(bool in_reset) {
    if (in_reset) {
      master_.clear();
      slave_ = {};
      aw_ = w_ = ar_ = busy_ = false;
    }
    return master_.drive();
  }
  /// A clock of the bus.
  void step(const cores::AxiLiteMasterPins& axi, const cores::WishboneSlavePins& wishbone) {
    take(axi);
    if (slave_.bvalid && axi.bready) slave_.bvalid = false;
    if (slave_.rvalid && axi.rready) slave_.rvalid = false;
    const bool write = master_.now() && master_.now()->write;
    if (master_.accept(wishbone)) answer(write, wishbone);
    if (!busy_ && ((aw_ && w_) || ar_)) ask(aw_ && w_);
    slave_.awready = !aw_;
    slave_.wready = !w_;
    slave_.arready = !ar_;
  }
  const cores::AxiLiteSlavePins& slave() const { return slave_; }

 private:
  void take(const cores::AxiLiteMasterPins& axi) {
    if (axi.awvalid && slave_.awready) {
      aw_ = true;
      write_.address = axi.awaddr;
    }
    if (axi.wvalid && slave_.wready) {
      w_ = true;
      write_.data = axi.wdata;
      write_.select = axi.wstrb;
    }
    if (axi.arvalid && slave_.arready) {
      ar_ = true;
      read_.address = axi.araddr;
    }
  }
  void ask(bool write) {
    write_.write = true;
    master_.ask(write ? write_ : read_);
    busy_ = true;
  }
  void answer(bool write, const cores::WishboneSlavePins& wishbone) {
    const std::uint8_t code = wishbone.err ? cores::kSlvErr : cores::kOkay;
    busy_ = false;
    if (write) {
      slave_.bvalid = true;
      slave_.bresp = code;
      aw_ = w_ = false;
    } else {
      slave_.rvalid = true;
      slave_.rresp = code;
      slave_.rdata = wishbone.dat;
      ar_ = false;
    }
  }

  WishboneMaster master_;
  WishboneAccess write_, read_;
  cores::AxiLiteSlavePins slave_;
  bool aw_ = false, w_ = false, ar_ = false, busy_ = false;
};

class WishboneCore final : public cores::AxiCore {
 public:
  explicit WishboneCore(std::uint64_t seed) : sim_(seed), bridge_(seed) {}

  void exchange(bool in_reset, cores::AxiLitePins& registers, cores::AxiPins& bus) override {
    auto& dut = *sim_.dut;
    dut.aresetn = in_reset ? 0 : 1;
    const cores::WishboneMasterPins& pins = bridge_.drive(in_reset);
    cores::drive_pins(dut, pins);
    cores::drive_pins(dut, bus);
    dut.aclk = 0;
    dut.eval();
    cores::WishboneSlavePins answer;
    cores::sample_pins(dut, answer);
    cores::sample_pins(dut, bus);
    registers.slave = bridge_.slave();
    if (!in_reset) bridge_.step(registers.master, answer);
  }
  void clock() override {
    sim_.dut->aclk = 1;
    sim_.dut->eval();
  }
  bool interrupt() const override { return sim_.dut->irq_o != 0; }

 private:
  struct Sim {
    explicit Sim(std::uint64_t seed) : context(std::make_unique<VerilatedContext>()) {
      context->randReset(2);
      context->randSeed(static_cast<int>(seed) + 1);
      dut = std::make_unique<Vwishbone>(context.get());
      dut->aclk = 0;
      dut->aresetn = 0;
      dut->eval();
    }
    ~Sim() {
      Verilated::threadContextp(context.get());  // final() uses the last one made
      dut->final();
    }
    std::unique_ptr<VerilatedContext> context;
    std::unique_ptr<Vwishbone> dut;
  };

  Sim sim_;
  Bridge bridge_;
};

/// CMakeLists.txt.
AxiRun wishbone_run(std::uint64_t seed, const std::string& throttles) {
  PageCore core;
  core.features = model::kAllFeatures | model::kGridsFeature;
  core.grid_limit = 9;
  return {find_configuration("basic-fx18-overlapped"), std::make_unique<WishboneCore>(seed), seed,
          throttles, core};
}

TEST(WishboneWhole, GivesTheModelsBits) {
  for (std::uint64_t seed = 1; seed <= 4; ++seed) {
    AxiRun run = wishbone_run(seed, seed % 2 == 0 ? "always" : "mixed");
    EXPECT_EQ(run.driver().probe().format, 18U);
    run.send_bspline();
    for (int repeat = 0; repeat < 2; ++repeat) {
      run.send(random_packets(run.codec(), run.random(), 20));
      ASSERT_TRUE(run.go()) << "seed " << seed << ", run " << repeat;
    }
    run.driver().take_errors();
    ASSERT_TRUE(run.soft_reset());
    EXPECT_TRUE(run.ends_well()) << "seed " << seed;
  }
}

TEST(WishboneWhole, AnywhereInMemory) {
  AxiRun run = wishbone_run(8, "always");
  for (int place = 0; place < 20; ++place) {
    run.move_to(Places::anywhere(run.random()));
    ASSERT_TRUE(run.good_run()) << place;
  }
  EXPECT_TRUE(run.clean());
}

TEST(WishboneWhole, RegistersAreWordsOfBytes) {
  AxiRun run = wishbone_run(9, "always");
  expect_words_and_bytes(run.system());
  EXPECT_TRUE(run.ends_well());
}

/// A memory that takes no data for a while then gets bursts as long as they may be.
TEST(WishboneWhole, BurstsOfAllLengths) {
  AxiRun run = wishbone_run(10, "always");
  run.send_scene(600);
  run.start_with_memory_shut(40'000);
  run.system().memory.set_throttles({});
  ASSERT_TRUE(run.finish());
  std::uint64_t longest = 0;
  for (const tb::AxiMemory::Burst& burst : run.system().memory.writes()) {
    longest = std::max(longest, burst.beats);
  }
  EXPECT_GT(longest, 128U);
  EXPECT_TRUE(run.ends_well());
}

TEST(WishboneWhole, StopsAGridByARegister) {
  AxiRun run = wishbone_run(11, "mixed");
  EXPECT_EQ(run.driver().probe().grid_limit, 9U);
  GridStop stop;
  const Grid grid = grid_between({0, 0, 0}, {1, 1, 1}, {8, 8, 8});
  ASSERT_TRUE(stop_grid_at(run, GridStore::kResident, grid, 6000, stop));
  EXPECT_TRUE(stop.stopped);
  run.send(grid_packet(grid_between({0, 0, 0}, {1, 1, 0}, {27, 19, 1})));
  ASSERT_TRUE(run.go());
  EXPECT_EQ(run.driver().take_errors().status, 1U << kGridCount) << "513 vertices";
  EXPECT_TRUE(run.ends_well());
}

TEST(WishboneWhole, InterruptsAndErrorsReachTheDriver) {
  AxiRun run = wishbone_run(7, "bernoulli");
  EXPECT_FALSE(run.system().interrupt());
  run.send_bspline();
  ASSERT_TRUE(run.go());
  EXPECT_TRUE(run.system().interrupt());
  EXPECT_NE(run.driver().take_interrupts(), 0U);
  EXPECT_FALSE(run.system().interrupt());
  EXPECT_THROW(run.system().read32(0xFFC), RegisterError);
  EXPECT_THROW(run.driver().set_windows({}, {}), DriverError) << "locked";
  EXPECT_TRUE(run.ends_well());
}

}  // namespace
}  // namespace hwffd::test
