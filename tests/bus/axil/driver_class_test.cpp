// The driver class of api/: the programming sequence of docs/registers.md on the register block,
// with a stand-in for the hardware behind it.
#include <gtest/gtest.h>

#include "hwffd/driver.hpp"
#include "hwffd/registers.h"
#include "register_bench.hpp"

namespace hwffd::test {
namespace {

constexpr std::uint64_t kPolls = 1000;

/// A core in a few lines: a start takes `kRun` clocks, works off the ring, gives a result each.
class StandIn {
 public:
  static constexpr unsigned kRun = 100;

  explicit StandIn(RegisterBench& bench) : bench_(bench) {
    auto& in = bench.inputs();
    in["config_org_i"] = 4;
    in["config_n_i"] = 8;
    in["config_format_i"] = 18;
    in["config_schedule_i"] = 1;
    in["config_evaluator_i"] = 2;
    in["limits_in_flight_i"] = 16;
    in["limits_points_axis_i"] = 9;
    in["status_idle_i"] = 1;
    bench.each_clock([this] { clock(); });
  }
  std::uint64_t error = 0;  ///< raised at the end of the next start
  bool hangs = false;

 private:
  void clock() {
    auto& in = bench_.inputs();
    in["error_event_i"] = in["error_address_valid_i"] = 0;
    in["status_done_set_i"] = 0;
    if (bench_.output("control_soft_reset_o") != 0) reset();
    if (left_ > 0 && !hangs && --left_ == 0) finish();
    if (start_) left_ = kRun;
    if (start_) in["status_ring_running_i"] = 1;
    start_ = bench_.output("control_start_o") != 0;
    in["status_busy_i"] = left_ > 0 || start_ ? 1 : 0;
    in["status_idle_i"] = in["status_busy_i"] ^ 1;
    in["counter_busy_event_i"] = in["status_busy_i"];
  }
  void reset() {
    auto& in = bench_.inputs();
    left_ = 0;
    in["ring_tail_i"] = in["result_count_i"] = 0;
    in["status_ring_running_i"] = in["status_stopped_i"] = 0;
  }
  void finish() {
    auto& in = bench_.inputs();
    const std::uint64_t head = bench_.output("ring_head_o");
    in["result_count_i"] = (head - in["ring_tail_i"]) & 0xF;
    in["ring_tail_i"] = head;
    in["status_done_set_i"] = 1;
    in["error_event_i"] = error;
    if ((error & HWFFD_ERROR_STATUS_DMA_READ_RESPONSE_MASK) != 0) in["status_stopped_i"] = 1;
    in["error_address_valid_i"] = error != 0 ? 1 : 0;
    in["error_packet_i"] = 3;
    in["error_beat_i"] = 4;
    in["error_address_i"] = 0x1'0000'0005;
    error = 0;
  }

  RegisterBench& bench_;
  unsigned left_ = 0;
  bool start_ = false;
};

class DriverClass : public testing::Test {
 protected:
  RegisterBench bench_{1, "bernoulli"};
  StandIn core_{bench_};
  BenchPort port_{bench_};
  Driver driver_{port_};

  void set_up_ring(unsigned log2_size = 4) {
    driver_.set_ring({0x1'2345'6700, log2_size});
    driver_.set_results({0x2'0000'0010, 4096});
  }
};

TEST_F(DriverClass, KnowsTheCore) {
  const CoreIdentity core = driver_.probe();
  EXPECT_EQ(core.version_major, unsigned{PROJECT_VERSION_MAJOR});
  EXPECT_EQ(core.version_minor, unsigned{PROJECT_VERSION_MINOR});
  EXPECT_EQ(core.version_patch, unsigned{PROJECT_VERSION_PATCH});
  EXPECT_EQ(core.org, 4u);
  EXPECT_EQ(core.n, 8u);
  EXPECT_EQ(core.format, 18u);
  EXPECT_EQ(core.schedule, 1u);
  EXPECT_EQ(core.evaluator, 2u);
  EXPECT_EQ(core.in_flight, 16u);
  EXPECT_EQ(core.points_axis, 9u);
}

/// Answers every read alike.
class ConstantPort final : public RegisterPort {
 public:
  std::uint32_t value = 0;
  std::uint32_t version = HWFFD_VERSION_MAJOR_RESET << HWFFD_VERSION_MAJOR_SHIFT;
  std::uint32_t read32(std::uint32_t offset) override {
    return offset == HWFFD_VERSION_OFFSET ? version : value;
  }
  void write32(std::uint32_t, std::uint32_t) override {}
};

TEST(DriverProbe, RefusesWhatItDoesNotKnow) {
  ConstantPort port;
  Driver driver(port);
  EXPECT_THROW(driver.probe(), DriverError);
  port.value = HWFFD_ID_RESET;
  EXPECT_NO_THROW(driver.probe());
  port.version += 1u << HWFFD_VERSION_MAJOR_SHIFT;
  EXPECT_THROW(driver.probe(), DriverError);
}

TEST_F(DriverClass, SetsAndLocksTheWindows) {
  EXPECT_THROW(driver_.set_windows({2, 1}, {}), DriverError);
  driver_.set_windows({0x1'0000'1000, 0x1'0000'2000}, {0x3000, 0xFFFF'0000'0000'4000});
  EXPECT_EQ(bench_.output("read_window_base_o"), 0x1'0000'1000u);
  EXPECT_EQ(bench_.output("read_window_limit_o"), 0x1'0000'2000u);
  EXPECT_EQ(bench_.output("write_window_base_o"), 0x3000u);
  EXPECT_EQ(bench_.output("write_window_limit_o"), 0xFFFF'0000'0000'4000u);
  EXPECT_FALSE(driver_.windows_locked());
  driver_.lock_windows();
  EXPECT_TRUE(driver_.windows_locked());
  EXPECT_THROW(driver_.set_windows({}, {}), DriverError);
  EXPECT_THROW(port_.write32(HWFFD_READ_WINDOW_BASE_LO_OFFSET, 0), RegisterError);
  EXPECT_EQ(bench_.output("read_window_base_o"), 0x1'0000'1000u);
  EXPECT_THROW(port_.read32(0xFFC), RegisterError);
}

TEST_F(DriverClass, RunsTheWholeSequence) {
  driver_.probe();
  driver_.set_windows({0, 0xFFFF}, {0x10000, 0x1FFFF});
  driver_.lock_windows();
  set_up_ring();
  EXPECT_EQ(bench_.output("ring_base_o"), 0x1'2345'6700u);
  EXPECT_EQ(bench_.output("ring_log2_size_o"), 4u);
  EXPECT_EQ(bench_.output("result_base_o"), 0x2'0000'0010u);
  EXPECT_EQ(bench_.output("result_size_o"), 4096u);
  driver_.enable_interrupts(HWFFD_IRQ_ENABLE_DONE_MASK | HWFFD_IRQ_ENABLE_ERROR_MASK);
  driver_.clear_counters();
  for (unsigned round = 1; round <= 3; ++round) {
    driver_.set_results({0x2'0000'0000 + std::uint64_t{256} * round, 256});
    driver_.push(5 + round);
    EXPECT_EQ(driver_.pending(), 5 + round);
    EXPECT_EQ(driver_.next_entry(), (round == 1 ? 6 : round == 2 ? 13 : 21) % 16u);
    core_.error = round == 2 ? 0x2100 : 0;
    driver_.start();
    EXPECT_TRUE(driver_.wait_done(kPolls));
    bench_.steps(2);
    EXPECT_EQ(bench_.output("irq_o"), 1u);
    EXPECT_EQ(driver_.pending(), 0u);
    EXPECT_EQ(driver_.result_count(), 5 + round);
    const CoreErrors errors = driver_.take_errors();
    EXPECT_EQ(errors.status, round == 2 ? 0x2100u : 0u);
    EXPECT_EQ(errors.count, round == 1 ? 0u : 2u);
    ASSERT_EQ(errors.first.has_value(), round == 2);
    if (errors.first) {
      EXPECT_EQ(errors.first->code, 8u);
      EXPECT_EQ(errors.first->packet, 3u);
      EXPECT_EQ(errors.first->beat, 4u);
      EXPECT_EQ(errors.first->address, 0x1'0000'0005u);
    }
    EXPECT_EQ(driver_.take_interrupts(),
              HWFFD_IRQ_STATE_DONE_MASK | (round == 2 ? HWFFD_IRQ_STATE_ERROR_MASK : 0));
    bench_.steps(2);
    EXPECT_EQ(bench_.output("irq_o"), 0u);
  }
  const CoreCounters counters = driver_.counters();
  EXPECT_EQ(counters.busy, 3 * (StandIn::kRun + 1));
  EXPECT_EQ(counters.vertices, 0u);
  EXPECT_EQ(counters.stalls, 0u);
}

TEST_F(DriverClass, KeepsTheRingFromOverflowing) {
  EXPECT_THROW(driver_.set_ring({0, 0}), DriverError);  // one entry, which stays unused
  EXPECT_THROW(driver_.set_ring({0, 16}), DriverError);
  EXPECT_THROW(driver_.set_ring({0x120, 2}), DriverError);  // not a multiple of 64
  EXPECT_THROW(driver_.push(1), DriverError);               // no ring yet
  bench_.inputs()["ring_tail_i"] = 4;
  EXPECT_THROW(driver_.set_ring({0x140, 2}), DriverError);
  bench_.inputs()["ring_tail_i"] = 3;
  bench_.inputs()["status_ring_running_i"] = 1;
  EXPECT_THROW(driver_.set_ring({0x140, 2}), DriverError);
  bench_.inputs()["status_ring_running_i"] = 0;
  EXPECT_EQ(bench_.output("ring_base_o"), 0u);  // nothing was written
  set_up_ring(2);                               // indices wrap
  EXPECT_EQ(bench_.output("ring_head_o"), 3u);
  EXPECT_EQ(driver_.pending(), 0u);
  driver_.push(2);
  EXPECT_EQ(bench_.output("ring_head_o"), 1u);
  EXPECT_EQ(driver_.pending(), 2u);
  EXPECT_THROW(driver_.push(2), DriverError);
  EXPECT_THROW(driver_.push(~0u), DriverError);
  EXPECT_EQ(driver_.pending(), 2u);
  driver_.push(1);
  EXPECT_THROW(driver_.push(1), DriverError);
}

TEST_F(DriverClass, RefusesResultAreasThatTheCoreWould) {
  driver_.set_results({0x10, 0x20});
  EXPECT_THROW(driver_.set_results({0x18, 0x100}), DriverError);
  EXPECT_THROW(driver_.set_results({0x10, 0x101}), DriverError);
  EXPECT_THROW(driver_.set_results({0x10, 0}), DriverError);
  EXPECT_EQ(bench_.output("result_base_o"), 0x10u);
  EXPECT_EQ(bench_.output("result_size_o"), 0x20u);
}

TEST_F(DriverClass, ABusErrorIsOverAfterASoftReset) {
  driver_.lock_windows();
  set_up_ring();
  driver_.push(3);
  core_.error = HWFFD_ERROR_STATUS_DMA_READ_RESPONSE_MASK;
  driver_.start();
  EXPECT_TRUE(driver_.wait_done(kPolls));
  EXPECT_TRUE(driver_.stopped());
  EXPECT_EQ(driver_.take_errors().first->code, HWFFD_ERROR_STATUS_DMA_READ_RESPONSE_SHIFT);
  EXPECT_THROW(driver_.start(), DriverError);
  EXPECT_TRUE(driver_.soft_reset(kPolls));
  EXPECT_FALSE(driver_.stopped());
  EXPECT_THROW(driver_.push(1), DriverError);  // the ring has to be set again
  EXPECT_EQ(bench_.output("ring_head_o"), 0u);
  set_up_ring();
  driver_.push(4);
  driver_.start();
  EXPECT_TRUE(driver_.wait_done(kPolls));
  EXPECT_EQ(driver_.result_count(), 4u);
  EXPECT_EQ(driver_.take_errors().status, 0u);
}

TEST_F(DriverClass, AStartThatIsRefusedThrows) {
  EXPECT_THROW(driver_.start(), DriverError);  // not locked
  driver_.lock_windows();
  core_.hangs = true;
  driver_.start();
  EXPECT_FALSE(driver_.wait_done(20));  // bounded
  EXPECT_THROW(driver_.start(), DriverError);
  EXPECT_EQ(bench_.high_clocks("control_start_o"), 1u);
  EXPECT_TRUE(driver_.soft_reset(kPolls));
  core_.hangs = false;
  driver_.start();
  EXPECT_TRUE(driver_.wait_done(kPolls));
}

TEST_F(DriverClass, ASoftResetThatDoesNotEndIsBounded) {
  bench_.each_clock([this] { bench_.inputs()["status_idle_i"] = 0; });
  EXPECT_FALSE(driver_.soft_reset(10));
}

TEST_F(DriverClass, TestsInterrupts) {
  driver_.enable_interrupts(HWFFD_IRQ_ENABLE_REFUSED_MASK);
  driver_.test_interrupts(HWFFD_IRQ_TEST_REFUSED_MASK);
  bench_.steps(2);
  EXPECT_EQ(bench_.output("irq_o"), 1u);
  EXPECT_EQ(driver_.take_interrupts(), HWFFD_IRQ_STATE_REFUSED_MASK);
  EXPECT_EQ(driver_.take_interrupts(), 0u);
}

}  // namespace
}  // namespace hwffd::test
