// Good and bad traffic mixed, round after round on one system, under waiting that changes with
// every round: every result of what went well is exact, every error is survived. The environment
// variable HWFFD_SOAK is the number of seeds, from SEED on.
#include <fmt/format.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <map>
#include <numeric>
#include <string>

#include "axi_run.hpp"

namespace hwffd::test {
namespace {

/// One system under one seed's traffic.
class Traffic {
 public:
  static constexpr int kRounds = 40;

  Traffic(const Configuration& row, std::uint64_t seed) : run_(row, seed, "mixed") {}

  using Kind = void (Traffic::*)();
  void round() {
    static const std::map<std::string, Kind> kinds = {
        {"any packets", &Traffic::any_packets},   {"bus error", &Traffic::bus_error},
        {"descriptor", &Traffic::bad_descriptor}, {"small area", &Traffic::small_area},
        {"soft reset", &Traffic::soft_reset},     {"registers", &Traffic::bad_accesses}};
    const auto& [name, kind] = run_.random().pick(kinds);
    SCOPED_TRACE(name);
    round(kind);
  }
  void round(Kind kind) {
    tb::AxiSystem& system = run_.system();
    system.set_throttles(run_.random().chance(0.5) ? "mixed" : "always");
    system.memory.set_latency({1, 1 + run_.random().below(60)});
    (this->*kind)();
    system.memory.fail_nothing();
  }
  void finish() {
    EXPECT_TRUE(run_.soft_reset());
    run_.driver().take_errors();
    EXPECT_TRUE(run_.ends_well());
  }
  /// Rounds that bus errors of these kinds stopped: of a read, of a write.
  unsigned stops(std::pair<bool, bool> kinds) { return stops_[kinds]; }
  std::uint64_t checked() const { return run_.checked(); }
  std::uint64_t cycles() { return run_.system().cycle(); }

  /// Error responses somewhere in a run: what is open is completed, the error names its burst, and
  /// until a soft reset no address goes out and a start is refused.
  void bus_error() {
    tb::AxiMemory& memory = run_.system().memory;
    Driver& driver = run_.driver();
    const auto answer = [&] { return run_.random().pick({cores::kAxiSlverr, cores::kAxiDecerr}); };
    driver.take_errors();
    send_any();
    const std::uint64_t read = run_.random().below(20), write = run_.random().below(6);
    const std::size_t failing_read = memory.reads().size() + read;
    const std::size_t failing_write = memory.writes().size() + write;
    const bool reads = run_.random().chance(0.7), writes = run_.random().chance(0.5);
    if (reads) memory.fail_read(read, run_.random().below(4), answer());
    if (writes) memory.fail_write(write, answer());
    run_.start();
    if (run_.random().chance(0.3)) run_.system().run(run_.random().below(500));
    ASSERT_TRUE(run_.wait());
    if (!driver.stopped()) {
      EXPECT_TRUE(run_.finish());
      return;
    }
    // What is there is right, but for the vertex in which a packet was cut.
    EXPECT_GE(run_.results_in_memory() + 1, driver.result_count());
    EXPECT_TRUE(memory.quiet());
    const CoreErrors errors = driver.take_errors();
    const bool by_read = (errors.status & 1U << kDmaReadResponse) != 0;
    const bool by_write = (errors.status & 1U << kDmaWriteResponse) != 0;
    ASSERT_TRUE((!by_read || reads) && (!by_write || writes)) << errors.status;
    ASSERT_TRUE((by_read || by_write) && errors.first.has_value()) << errors.status;
    const std::uint64_t at = errors.first->address;
    const bool at_read = by_read && at == memory.reads()[failing_read].address;
    const bool at_write = by_write && at == memory.writes()[failing_write].address;
    EXPECT_TRUE(at_read || at_write) << std::hex << at;
    if (by_write) {  // the count stays at the beats before
      const std::uint64_t failed = memory.writes()[failing_write].address;
      EXPECT_EQ(driver.result_count(), (failed - run_.area()) / cores::kAxiBeatBytes);
    }
    EXPECT_THROW(driver.start(), DriverError) << "stopped";
    const std::size_t addresses = memory.reads().size();
    run_.system().run(100);
    EXPECT_EQ(memory.reads().size(), addresses);
    ++stops_[{by_read, by_write}];
    recover();
    EXPECT_FALSE(driver.stopped());
  }

 private:
  void send_any() {
    const auto packets = static_cast<int>(run_.random().between(1, 24));
    run_.send(random_packets(run_.codec(), run_.random(), packets));
  }
  void recover() {
    run_.system().memory.fail_nothing();
    ASSERT_TRUE(run_.soft_reset());
    run_.driver().take_errors();
    EXPECT_TRUE(run_.good_run());
  }

  void any_packets() {
    run_.driver().take_errors();
    run_.driver().clear_counters();
    const auto before = run_.model().events();
    send_any();
    ASSERT_TRUE(run_.go());
    const auto after = run_.model().events();
    const auto total = [](const auto& counts) {
      return std::accumulate(counts.begin(), counts.end(), std::uint64_t{0});
    };
    EXPECT_EQ(run_.driver().take_errors().count, total(after) - total(before));
  }
  void bad_descriptor() {
    struct Bad {
      std::uint64_t address;
      std::uint32_t bytes, flags;
    };
    send_any();
    const Bad bad = run_.random().pick({Bad{kBuffers.base, 0, 0}, Bad{kBuffers.base + 4, 32, 0},
                                        Bad{kBuffers.base, 40, 0}, Bad{~std::uint64_t{15}, 32, 0},
                                        Bad{kReadWindow.limit - 15, 32, 0},
                                        Bad{kWriteWindow.base, 32, 0}, Bad{kBuffers.base, 32, 8}});
    run_.ring().put_descriptor(bad.address, bad.bytes, bad.flags);
    EXPECT_TRUE(run_.go()) << "the packets before it";
    EXPECT_EQ(run_.driver().pending(), 1U);
    EXPECT_NE(run_.driver().take_errors().status >> kDmaZero, 0U);
    recover();
  }
  void small_area() {
    send_any();
    const std::uint64_t results = run_.expected().size();
    if (results < 2) {
      EXPECT_TRUE(run_.go());
      return;
    }
    const std::uint64_t room = 1 + run_.random().below(results - 1);
    run_.start(room);
    ASSERT_TRUE(run_.wait());
    EXPECT_EQ(run_.driver().result_count(), room);
    EXPECT_EQ(run_.results_in_memory(), room);
    EXPECT_NE(run_.driver().take_errors().status & 1U << kResultOverflow, 0U);
    run_.forget_expected();
  }
  void soft_reset() {
    send_any();
    run_.start();
    run_.system().run(run_.random().below(run_.random().pick({50, 500, 5000})));
    recover();
  }
  void bad_accesses() {
    tb::AxiSystem& system = run_.system();
    send_any();
    run_.start();
    for (int access = 0; access < 10; ++access) {
      EXPECT_EQ(system.try_write(0x200 + 4 * run_.random().below(64), run_.random().word()),
                cores::kSlvErr);
      EXPECT_THROW(system.read32(0x800), RegisterError);
      EXPECT_EQ(system.try_write(HWFFD_WRITE_WINDOW_BASE_LO_OFFSET, 0), cores::kSlvErr);
    }
    EXPECT_TRUE(run_.finish());
  }

  AxiRun run_;
  std::map<std::pair<bool, bool>, unsigned> stops_;
};

class AxiSoak : public PerAxiConfiguration {};

TEST_P(AxiSoak, GoodAndBadTraffic) {
  const std::uint64_t first = tb::seed_from_environment(1);
  const std::uint64_t count = tb::seed_from_environment(2, "HWFFD_SOAK");
  ASSERT_GT(count, 0U) << "HWFFD_SOAK: a number of seeds from 1 up is wanted";
  std::uint64_t checked = 0, cycles = 0;
  for (std::uint64_t seed = first; seed < first + count; ++seed) {
    SCOPED_TRACE("SEED=" + std::to_string(seed) + " HWFFD_SOAK=1");
    Traffic traffic(GetParam(), seed);
    for (int round = 0; round < Traffic::kRounds && !HasFailure(); ++round) traffic.round();
    if (!HasFailure()) traffic.finish();
    checked += traffic.checked();
    cycles += traffic.cycles();
    if (HasFailure()) break;
    if (isatty(fileno(stderr)) != 0) {
      fmt::print(stderr, "\r{}: seed {} of {}", GetParam().name, seed - first + 1, count);
    }
  }
  if (isatty(fileno(stderr)) != 0) std::fprintf(stderr, "\r%60s\r", "");
  fmt::print("{}: {} seeds, {} results, {} clocks\n", GetParam().name, count, checked, cycles);
}

TEST_P(AxiSoak, BusErrors) {
  Traffic traffic(GetParam(), tb::seed_from_environment(3));
  for (int round = 0; round < 120 && !HasFailure(); ++round) traffic.round(&Traffic::bus_error);
  if (!HasFailure()) traffic.finish();
  const unsigned by_read = traffic.stops({true, false}), by_write = traffic.stops({false, true});
  EXPECT_GE(by_read, 10U);
  EXPECT_GE(by_write, 10U);
  fmt::print("{} runs stopped by a read, {} by a write, {} by both\n", by_read, by_write,
             traffic.stops({true, true}));
}

HWFFD_FOR_EACH_AXI_CONFIGURATION(AxiSoak);

}  // namespace
}  // namespace hwffd::test
