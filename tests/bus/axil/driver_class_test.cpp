// The driver class on the register block alone: what it writes and what it refuses. Runs on the
// whole core are in tests/bus/axi.
#include <gtest/gtest.h>

#include <set>
#include <stdexcept>
#include <string>

#include "hwffd/driver.hpp"
#include "hwffd/registers.h"
#include "register_bench.hpp"

namespace hwffd::test {
namespace {

/// What is thrown as a DriverError; empty: nothing.
template <class Body>
std::string complaint(const Body& body) {
  try {
    body();
  } catch (const DriverError& error) {
    return error.what();
  }
  return "";
}

class DriverClass : public testing::Test {
 protected:
  RegisterBench bench_{1, "bernoulli"};
  BenchPort port_{bench_};
  Driver driver_{port_};
};

TEST_F(DriverClass, KnowsTheCore) {
  const std::pair<const char*, std::uint64_t> parameters[] = {
      {"config_org_i", 4},           {"config_n_i", 8},          {"config_format_i", 18},
      {"config_schedule_i", 1},      {"config_evaluator_i", 2},  {"limits_in_flight_i", 16},
      {"limits_points_axis_i", 9},   {"limits2_pages_i", 300},   {"limits2_spans_i", 128},
      {"limits2_count_width_i", 17}, {"limits_grid_limit_i", 45}};
  for (const auto& [port, value] : parameters) bench_.inputs()[port] = value;
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
  EXPECT_EQ(core.features, 0u);
  EXPECT_EQ(core.pages, 300u);
  EXPECT_EQ(core.spans, 128u);
  EXPECT_EQ(core.count_width, 17u);
  EXPECT_EQ(core.grid_limit, 45u);
}

TEST_F(DriverClass, KnowsEachFeature) {
  const std::pair<const char*, std::uint32_t> features[] = {
      {"pages", HWFFD_FEATURES_PAGES_MASK},
      {"large", HWFFD_FEATURES_LARGE_MASK},
      {"fourth", HWFFD_FEATURES_FOURTH_MASK},
      {"spans", HWFFD_FEATURES_SPANS_MASK},
      {"grids", HWFFD_FEATURES_GRIDS_MASK},
      {"packed", HWFFD_FEATURES_PACKED_MASK},
      {"marks", HWFFD_FEATURES_MARKS_MASK},
      {"resident", HWFFD_FEATURES_RESIDENT_MASK},
      {"interleaved", HWFFD_FEATURES_INTERLEAVED_MASK},
      {"derivatives", HWFFD_FEATURES_DERIVATIVES_MASK},
      {"determinant", HWFFD_FEATURES_DETERMINANT_MASK},
      {"halves", HWFFD_FEATURES_HALVES_MASK}};
  EXPECT_THROW(driver_.check({1, 0, 0, 0}), DriverError) << "probe comes first";
  for (const auto& [name, mask] : features) {
    const std::string port = std::string("features_") + name + "_i";
    bench_.inputs()[port] = 1;
    EXPECT_EQ(driver_.probe().features, mask) << name;
    bench_.inputs()[port] = 0;
  }
  EXPECT_NO_THROW(driver_.check({1, 0, 0, 0}));
  EXPECT_THROW(driver_.check({4, 1, 0, 0}), DriverError);
}

/// Answers every read alike.
class ConstantPort final : public RegisterPort {
 public:
  std::uint32_t value = 0;
  std::uint32_t version = HWFFD_VERSION_MAJOR_RESET << HWFFD_VERSION_MAJOR_SHIFT;
  bool first = false;  ///< a core without the registers that came later
  std::uint32_t read32(std::uint32_t offset) override {
    if (first && (offset == HWFFD_FEATURES_OFFSET || offset == HWFFD_LIMITS2_OFFSET)) {
      throw RegisterError("there is none");
    }
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
  port.first = true;
  const CoreIdentity core = driver.probe();
  EXPECT_EQ(core.features, 0xF00u);
  EXPECT_EQ(core.pages, 2u);
  EXPECT_EQ(core.spans, 1u);
  port.version += 1u << HWFFD_VERSION_MAJOR_SHIFT;
  EXPECT_THROW(driver.probe(), DriverError);
}

/// Throws at one access, counted from 0. Behind it is a core that is done and has had an error.
class FailingPort final : public RegisterPort {
 public:
  explicit FailingPort(int place) : place_(place) {}
  std::uint32_t read32(std::uint32_t offset) override {
    access();
    switch (offset) {
      case HWFFD_ID_OFFSET:
        return HWFFD_ID_RESET;
      case HWFFD_STATUS_OFFSET:
        return HWFFD_STATUS_DONE_MASK | HWFFD_STATUS_IDLE_MASK;
      case HWFFD_ERROR_STATUS_OFFSET:
      case HWFFD_IRQ_STATE_OFFSET:
        return 1;
      case HWFFD_ERROR_FIRST_OFFSET:
        return HWFFD_ERROR_FIRST_VALID_MASK;
      default:
        return 0;
    }
  }
  void write32(std::uint32_t, std::uint32_t) override { access(); }
  int accesses() const { return accesses_; }

 private:
  void access() {
    if (accesses_++ == place_) throw std::out_of_range("no such access");
  }
  int place_;
  int accesses_ = 0;
};

// The sequence is C: nothing is thrown through it, and nothing is lost in it.
TEST(DriverPort, WhatItThrowsComesThroughAtOnce) {
  int places = 0;
  for (int place = 0;; ++place) {
    FailingPort port(place);
    Driver driver(port);
    try {
      driver.probe();
      driver.set_windows({0, 15}, {0, 15});
      driver.lock_windows();
      driver.set_ring({0, 1});
      driver.set_results({0, 16});
      driver.next_entry();
      driver.push(1);
      driver.start();
      driver.wait_done(1);
      driver.result_count();
      driver.take_errors();
      driver.take_interrupts();
      driver.stopped();
      driver.soft_reset(1);
      driver.stop_grid();
      break;
    } catch (const std::out_of_range& error) {
      EXPECT_EQ(error.what(), std::string("no such access"));
      EXPECT_EQ(port.accesses(), place + 1) << "it went on";
      ++places;
    }
  }
  EXPECT_GT(places, 50);
}

TEST(DriverPort, EachStatusHasALineOfItsOwn) {
  std::set<std::string> lines;
  for (int status = HWFFD_CORE_OK; status <= HWFFD_CORE_LATE; ++status) {
    const std::string line = hwffd_core_text(static_cast<hwffd_core_status>(status));
    EXPECT_EQ(line.find('\n'), std::string::npos);
    EXPECT_TRUE(lines.insert(line).second) << line;
  }
  const auto other = static_cast<hwffd_core_status>(HWFFD_CORE_LATE + 1);
  EXPECT_EQ(lines.count(hwffd_core_text(other)), 0u);
}

TEST_F(DriverClass, SaysWhyThereIsNoStore) {
  EXPECT_EQ(complaint([&] { driver_.store(); }), "the core is not known yet: probe it first");
  driver_.probe();
  EXPECT_EQ(complaint([&] { driver_.store(); }),
            "this core keeps no lattice: send interleaved vertices, or build it with RESIDENT = 1");
  for (const unsigned pages : {0u, 4u}) {
    bench_.inputs()["limits_points_axis_i"] = 16;
    bench_.inputs()["limits2_pages_i"] = 4;
    bench_.inputs()["features_pages_i"] = pages != 0 ? 1 : 0;
    bench_.inputs()["features_spans_i"] = 1;
    driver_.probe();
    EXPECT_EQ(driver_.store().axis_points, 16);
    EXPECT_EQ(driver_.store().pages, static_cast<int>(pages));
    EXPECT_EQ(driver_.store().spans, pages != 0);
  }
}

TEST_F(DriverClass, SaysWhichCellsCanBeSaid) {
  for (const char* feature : {"resident", "pages", "large"}) {
    bench_.inputs()[std::string("features_") + feature + "_i"] = 1;
  }
  const auto said = [&](unsigned axis, int cell, bool large) {
    bench_.inputs()["limits_points_axis_i"] = axis;
    bench_.inputs()["limits2_pages_i"] = 4;
    driver_.probe();
    PageVertices how;
    how.large = large;
    VertexBeat vertex{};
    vertex.cell[1] = cell;
    return complaint([&] { driver_.page_vertices(0, {vertex}, how); });
  };
  const std::string text = " along axis t: 0 to ";
  EXPECT_EQ(said(16, 15, false), "");
  EXPECT_EQ(said(64, 63, true), "");
  EXPECT_EQ(said(16, 16, false), "vertex 0: cell 16" + text +
                                     "15 can be said to this core; "
                                     "cut the lattice into pages, or build with AXIS");
  EXPECT_EQ(said(64, 32, false),
            "vertex 0: cell 32" + text + "31 can be said to this core; set large");
  EXPECT_EQ(said(64, 64, true), "vertex 0: cell 64" + text +
                                    "63 can be said to this core; "
                                    "cut the lattice into pages, or build with AXIS");
  EXPECT_NE(said(16, -1, false), "");
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
  driver_.set_ring({0x1'2345'6700, 2});         // indices wrap
  EXPECT_EQ(bench_.output("ring_base_o"), 0x1'2345'6700u);
  EXPECT_EQ(bench_.output("ring_log2_size_o"), 2u);
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
  EXPECT_EQ(driver_.next_entry(), 2u);
  EXPECT_FALSE(driver_.soft_reset(10));  // bounded
  bench_.inputs()["status_idle_i"] = 1;
  EXPECT_TRUE(driver_.soft_reset(10));
  EXPECT_EQ(bench_.output("ring_head_o"), 0u);
  bench_.inputs()["ring_tail_i"] = 0;
  EXPECT_THROW(driver_.push(1), DriverError);  // the ring has to be set again
}

TEST_F(DriverClass, RefusesResultAreasThatTheCoreWould) {
  driver_.set_results({0x2'0000'0010, 0x20});
  EXPECT_THROW(driver_.set_results({0x18, 0x100}), DriverError);
  EXPECT_THROW(driver_.set_results({0x10, 0x101}), DriverError);
  EXPECT_THROW(driver_.set_results({0x10, 0}), DriverError);
  EXPECT_EQ(bench_.output("result_base_o"), 0x2'0000'0010u);
  EXPECT_EQ(bench_.output("result_size_o"), 0x20u);
}

TEST_F(DriverClass, AStartThatIsRefusedThrows) {
  EXPECT_THROW(driver_.start(), DriverError);  // not locked
  driver_.lock_windows();
  driver_.start();
  EXPECT_FALSE(driver_.wait_done(20));  // bounded
  for (const char* reason : {"status_busy_i", "status_stopped_i"}) {
    bench_.inputs()[reason] = 1;
    EXPECT_EQ(driver_.stopped(), reason == std::string("status_stopped_i"));
    EXPECT_THROW(driver_.start(), DriverError);
    bench_.inputs()[reason] = 0;
  }
  EXPECT_EQ(bench_.high_clocks("control_start_o"), 1u);
  bench_.pulse("status_done_set_i");
  EXPECT_TRUE(driver_.wait_done(1));
}

TEST_F(DriverClass, TakesErrorsOnceAndCounts) {
  bench_.inputs()["error_packet_i"] = 3;
  bench_.inputs()["error_beat_i"] = 4;
  bench_.inputs()["error_address_i"] = 0x1'0000'0005;
  bench_.inputs()["error_address_valid_i"] = 1;
  bench_.pulse("error_event_i", 0x2100);
  for (const bool again : {false, true}) {
    const CoreErrors errors = driver_.take_errors();
    EXPECT_EQ(errors.status, again ? 0 : 0x2100u);
    EXPECT_EQ(errors.count, 2u);
    ASSERT_NE(errors.first.has_value(), again);
    if (again) continue;
    EXPECT_EQ(errors.first->code, 8u);
    EXPECT_EQ(errors.first->packet, 3u);
    EXPECT_EQ(errors.first->beat, 4u);
    EXPECT_EQ(errors.first->address, 0x1'0000'0005u);
  }
  bench_.inputs()["counter_busy_event_i"] = 1;
  bench_.steps(100);
  bench_.inputs()["counter_busy_event_i"] = 0;
  bench_.inputs()["result_count_i"] = 7;
  EXPECT_EQ(driver_.counters().busy, 100u);
  EXPECT_EQ(driver_.counters().vertices + driver_.counters().stalls, 0u);
  EXPECT_EQ(driver_.result_count(), 7u);
}

TEST_F(DriverClass, AStopOfAGridIsAPulseAndNothingElse) {
  driver_.stop_grid();
  driver_.stop_grid();
  for (const char* pulse : {"start", "soft_reset", "clear_counters"})
    EXPECT_EQ(bench_.high_clocks(std::string("control_") + pulse + "_o"), 0u) << pulse;
  EXPECT_EQ(bench_.high_clocks("control_stop_grid_o"), 2u);
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
