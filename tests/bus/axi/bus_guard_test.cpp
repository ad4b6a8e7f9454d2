// The parameters of hwffd_axi that concern its buses: what the master says of its transfers, who
// may reach the registers, how long a slave may take, when results leave; at their defaults and at
// others (`axi_guarded`).
#include <gtest/gtest.h>

#include "Vaxi_guarded.h"
#include "axi_run.hpp"
#include "hwffd/cores/verilated_axi_core.hpp"

namespace hwffd::test {
namespace {

constexpr std::uint64_t kTimeout = 400;
constexpr std::uint8_t kSecure = 0, kNotSecure = 2;
constexpr std::uint64_t kNever = std::uint64_t{1} << 60;

const Configuration& guarded_row() { return find_configuration("basic-fx18-overlapped"); }

/// A run with a core of other parameters (tests/bus/axi/CMakeLists.txt).
class Guarded {
 public:
  explicit Guarded(std::uint64_t seed)
      : run_(guarded_row(), std::make_unique<cores::VerilatedAxiCore<Vaxi_guarded>>(seed), seed) {}
  AxiRun* operator->() { return &run_; }
  AxiRun& operator*() { return run_; }

 private:
  AxiRun run_;
};

/// Every burst has these, each way.
void expect_attributes(AxiRun& run, unsigned cache, unsigned prot, unsigned id) {
  for (const auto* bursts : {&run.system().memory.reads(), &run.system().memory.writes()}) {
    EXPECT_FALSE(bursts->empty());
    for (const tb::AxiMemory::Burst& burst : *bursts) {
      EXPECT_EQ(unsigned{burst.cache}, cache);
      EXPECT_EQ(unsigned{burst.prot}, prot);
      EXPECT_EQ(unsigned{burst.id}, id);
    }
  }
}

TEST(AxiGuard, TheMasterSaysWhatItsParametersSay) {
  AxiRun plain(guarded_row(), 1);
  ASSERT_TRUE(plain.good_run());
  expect_attributes(plain, 2, 2, 0);  // not cacheable, not bufferable; not secure
  Guarded run(1);
  ASSERT_TRUE(run->good_run());
  expect_attributes(*run, 15, 1, 9);
  EXPECT_TRUE(run->clean());
}

/// Bits above ADDRESS_WIDTH are 0 in every setting, and an address that has one is in no window,
/// not even in the largest.
TEST(AxiGuard, AddressesEndAtTheirWidth) {
  constexpr std::uint32_t kHigh[] = {
      HWFFD_RING_BASE_HI_OFFSET,         HWFFD_RESULT_BASE_HI_OFFSET,
      HWFFD_READ_WINDOW_BASE_HI_OFFSET,  HWFFD_READ_WINDOW_LIMIT_HI_OFFSET,
      HWFFD_WRITE_WINDOW_BASE_HI_OFFSET, HWFFD_WRITE_WINDOW_LIMIT_HI_OFFSET};
  constexpr std::uint64_t kBeyond = std::uint64_t{1} << 40;
  cores::VerilatedAxiCore<Vaxi_guarded> core(5);
  tb::AxiSystem system(core, 5);
  for (const std::uint32_t offset : kHigh) {
    system.write32(offset, 0xFFFF'FFFF);
    EXPECT_EQ(system.read32(offset), 0xFFU) << offset;
    system.write32(offset, 0);
  }
  Driver driver(system);
  driver.probe();
  driver.set_windows({0, ~std::uint64_t{0}}, {0, ~std::uint64_t{0}});
  driver.lock_windows();
  system.allow({0, kBeyond - 1}, {0, kBeyond - 1});
  tb::PacketRing ring(system.memory, driver, kRing, kBuffers);
  ring.open();
  ring.put_descriptor(kBuffers.limit + 1 + kBeyond, 16, 0);
  driver.set_results({kWriteWindow.base - kWriteWindow.base % 16, 16});
  driver.start();
  ASSERT_TRUE(driver.wait_done(kPolls));
  EXPECT_EQ(system.read32(HWFFD_ERROR_STATUS_OFFSET), HWFFD_ERROR_STATUS_DMA_WINDOW_MASK);
}

TEST(AxiGuard, AnyoneMayReachTheRegisters) {
  AxiRun run(guarded_row(), 2);
  for (std::uint8_t prot = 0; prot < 8; ++prot) {
    run.system().protect(prot);
    EXPECT_TRUE(run.good_run()) << unsigned{prot};
  }
  EXPECT_TRUE(run.clean());
}

/// Unless only a secure access may: others are answered SLVERR, read 0 and change nothing.
TEST(AxiGuard, OrOnlyASecureAccess) {
  Guarded run(3);
  tb::AxiSystem& port = run->system();
  ASSERT_TRUE(run->good_run());
  const std::uint32_t head = port.read32(HWFFD_RING_HEAD_OFFSET);
  for (const std::uint8_t prot : {2, 3, 6, 7}) {
    port.protect(prot);
    EXPECT_THROW(port.read32(HWFFD_ID_OFFSET), RegisterError) << unsigned{prot};
    EXPECT_EQ(port.try_write(HWFFD_RING_HEAD_OFFSET, head + 1), cores::kSlvErr);
    EXPECT_EQ(port.try_write(HWFFD_CONTROL_OFFSET, HWFFD_CONTROL_START_MASK), cores::kSlvErr);
    EXPECT_EQ(port.try_write(HWFFD_STATUS_OFFSET, HWFFD_STATUS_DONE_MASK), cores::kSlvErr);
  }
  port.protect(kSecure);
  const std::uint32_t status = port.read32(HWFFD_STATUS_OFFSET);
  EXPECT_EQ(status & HWFFD_STATUS_BUSY_MASK, 0U) << "nothing has started";
  EXPECT_NE(status & HWFFD_STATUS_DONE_MASK, 0U) << "that of the good run is still there";
  EXPECT_EQ(port.read32(HWFFD_RING_HEAD_OFFSET), head);
  // Both kinds on the bus at once: each has its own answer.
  for (int i = 0; i < 20; ++i) {
    port.protect(i % 3 == 0 ? kNotSecure : kSecure);
    EXPECT_EQ(port.try_write(HWFFD_RESULT_SIZE_OFFSET, 16U * (i + 1)),
              i % 3 == 0 ? cores::kSlvErr : cores::kOkay);
  }
  for (const std::uint8_t prot : {0, 1, 4, 5}) {
    port.protect(prot);
    EXPECT_TRUE(run->good_run()) << unsigned{prot};
  }
  EXPECT_TRUE(run->clean());
}

/// A vertex every 64 clocks: results wait for each other where FLUSH_CLOCKS is above that.
TEST(AxiGuard, ResultsOfASlowEvaluatorShareABurst) {
  AxiRun plain(guarded_row(), 4);
  plain.send_scene(64);
  ASSERT_TRUE(plain.go());
  EXPECT_EQ(plain.system().memory.writes().size(), 64U) << "one each";
  Guarded run(4);
  run->send_scene(64);
  ASSERT_TRUE(run->go());
  EXPECT_EQ(run->system().memory.write_beats(), 64U);
  EXPECT_LE(run->system().memory.writes().size(), 2U);
  EXPECT_TRUE(run->clean());
}

struct Hang {
  const char* name;
  unsigned code;
  tb::Throttle tb::AxiThrottles::*channel;
};
void PrintTo(const Hang& hang, std::ostream* out) { *out << hang.name; }

/// The memory is as new; so is the core.
void expect_next(AxiRun& run) {
  run.system().memory.set_throttles({});
  run.system().forget_bus();
  EXPECT_TRUE(run.ends_well());
}

class AxiHang : public testing::TestWithParam<Hang> {
 protected:
  /// A run whose memory answers no more on that channel, some clocks after the start.
  static void start(AxiRun& run, std::uint64_t after) {
    run.send_scene(30);
    run.start();
    tb::AxiThrottles throttles;
    throttles.*GetParam().channel = tb::Throttle::shut_after(after, kNever);
    run.system().memory.set_throttles(throttles);
  }
};
INSTANTIATE_TEST_SUITE_P(, AxiHang,
                         testing::Values(Hang{"AR", kTimeoutAr, &tb::AxiThrottles::ar},
                                         Hang{"R", kTimeoutR, &tb::AxiThrottles::r},
                                         Hang{"AW", kTimeoutAw, &tb::AxiThrottles::aw},
                                         Hang{"W", kTimeoutW, &tb::AxiThrottles::w},
                                         Hang{"B", kTimeoutB, &tb::AxiThrottles::b}),
                         by_name);

/// The run ends, and says which channel it was; a soft reset, too.
TEST_P(AxiHang, EndsTheRunAndTheSoftReset) {
  Guarded run(5);
  for (const std::uint64_t after : {1, 17, 40}) {
    start(*run, after);
    ASSERT_TRUE(run->wait());
    EXPECT_TRUE(run->driver().stopped());
    EXPECT_TRUE(run->system().interrupt());
    EXPECT_TRUE(run->only_error({GetParam().code, 0, 0, 0}));
    EXPECT_THROW(run->driver().start(), DriverError);
    ASSERT_TRUE(run->soft_reset());
    EXPECT_FALSE(run->driver().stopped());
    expect_next(*run);
    ASSERT_FALSE(HasFailure());
  }
}

/// The same where the soft reset is what waits; it gives no `done`.
TEST_P(AxiHang, InASoftResetEndsIt) {
  Guarded run(6);
  for (const std::uint64_t after : {1, 17, 40}) {
    start(*run, after);
    run->system().run(kTimeout / 2);
    EXPECT_EQ(run->driver().take_errors().status, 0U);
    ASSERT_TRUE(run->soft_reset());
    EXPECT_EQ(run->system().read32(HWFFD_STATUS_OFFSET) & HWFFD_STATUS_DONE_MASK, 0U);
    EXPECT_EQ(run->driver().take_errors().status & ~(1U << GetParam().code), 0U);
    expect_next(*run);
    ASSERT_FALSE(HasFailure());
  }
}

/// A slave that breaks the rule of RLAST: no address goes astray, and a soft reset makes all good.
TEST(AxiBrokenSlave, ALastThatIsLostOrEarlyIsOverWithASoftReset) {
  for (const std::uint64_t beat : {std::uint64_t{0}, std::uint64_t{3}, kNever}) {
    for (std::uint64_t burst = 0; burst < 6; ++burst) {
      SCOPED_TRACE(testing::Message() << "burst " << burst << ", beat " << beat);
      Guarded run(7 + burst);
      run->system().memory.misplace_last(burst, beat);
      run->send_scene(30);
      run->start();
      run->driver().wait_done(3000);
      run->system().memory.fail_nothing();
      ASSERT_TRUE(run->soft_reset());
      run->driver().take_errors();
      run->system().run(3 * kTimeout);
      expect_next(*run);
      ASSERT_FALSE(HasFailure());
    }
  }
}

/// With RLAST lost the data is there and the end is not: that is a time-out of R.
TEST(AxiBrokenSlave, ALostLastIsATimeoutOfR) {
  Guarded run(8);
  run->system().memory.misplace_last(1, kNever);
  run->send_scene(30);
  run->start();
  ASSERT_TRUE(run->wait());
  // What comes then is taken for that burst's data, so that other errors are there, too.
  EXPECT_NE(run->driver().take_errors().status & 1U << kTimeoutR, 0U);
  EXPECT_TRUE(run->driver().stopped());
  run->system().memory.fail_nothing();
  ASSERT_TRUE(run->soft_reset());
  expect_next(*run);
}

}  // namespace
}  // namespace hwffd::test
