// The bus: random traffic of reads and writes at once, reset in its midst, order, rate and latency.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include "named.hpp"
#include "register_bench.hpp"
#include "register_traffic.hpp"

namespace hwffd::test {
namespace {

constexpr unsigned kTransactions = 20'000;  // of a run

/// Unwilling from the first clock on.
tb::Throttle shut(std::uint64_t clocks) {
  tb::Throttle throttle = tb::Throttle::shut_after(1, clocks);
  throttle.willing();
  return throttle;
}

class EveryThrottle : public testing::TestWithParam<std::string> {};
INSTANTIATE_TEST_SUITE_P(Traffic, EveryThrottle,
                         testing::Values("always", "gaps", "sparse", "bernoulli", "bursts",
                                         "mixed"),
                         by_name);

/// What the traffic must have met: each sticky bit set, cleared, and both in one clock; a start
/// that was taken, and refused for each reason alone.
void expect_met(const RegisterModel& model) {
  std::vector<std::string> wanted = {"CONTROL.start taken", "CONTROL.start refused by STATUS.busy",
                                     "CONTROL.start refused by STATUS.stopped",
                                     "CONTROL.start refused by WINDOW_LOCK.windows"};
  for (const RegisterField& field : register_table()) {
    if (!field.sticky()) continue;
    for (const char* what : {" set", " cleared"}) wanted.push_back(field.path + what);
    // What a write sets no other write clears in the same clock.
    if (field.name.find("refused") != std::string::npos) continue;
    wanted.push_back(field.path + " set and cleared");
  }
  EXPECT_EQ(wanted.size(), 4u + 3 * 43 - 2);
  for (const std::string& what : wanted) EXPECT_GT(model.seen(what), 0u) << what;
}

TEST_P(EveryThrottle, EqualsTheModelInEveryClock) {
  const std::uint64_t seed = tb::seed_from_environment(1);
  tb::Random random(tb::derive_seed(seed, 77));
  RegisterBench bench(seed, GetParam());
  double pulses = 0.1;
  bench.each_clock([&] { disturb(bench.inputs(), bench.input_ports(), random, pulses); });
  std::uint64_t answered = 0;
  std::uint64_t errors = 0;
  while (answered < kTransactions && bench.failures().empty()) {
    pulses = random.pick({0.02, 0.1, 0.6});
    if (GetParam() == "mixed") {
      bench.driver().throttle(tb::AxiThrottles::make("mixed", random.bits()));
    }
    if (random.chance(0.5)) bench.set("WINDOW_LOCK", 1);
    for (unsigned i = 0; i < 250; ++i) {
      bench.driver().write(random.chance(0.2) && i > 0 ? bench.driver().writes().back()
                                                       : random_write(random));
      bench.driver().read(random_address(random));
    }
    bench.run();
    answered += 500;
    for (const auto& answer : bench.driver().write_responses()) errors += answer.code != 0 ? 1 : 0;
    while (random.chance(0.7)) {  // reset in mid-traffic, what is under way is lost
      for (unsigned i = 0; i < 50; ++i) {
        bench.driver().write(random_write(random));
        bench.driver().read(random_address(random));
      }
      bench.steps(static_cast<unsigned>(random.below(60)));
      bench.reset(static_cast<unsigned>(random.between(1, 3)));
    }
    bench.reset(static_cast<unsigned>(random.between(1, 3)));
  }
  EXPECT_GE(bench.compared(), kTransactions);
  EXPECT_GT(errors, answered / 20);
  EXPECT_LT(errors, answered * 9 / 20);
  expect_met(bench.model());
  EXPECT_GT(bench.idle_addresses().size(), 10u) << "random";
  const bool apart = GetParam() != "always" && GetParam() != "gaps" && GetParam() != "sparse";
  EXPECT_EQ(bench.resets_of("address without data") > 0, apart);
  EXPECT_EQ(bench.resets_of("write") > 0, GetParam() != "always");
  EXPECT_EQ(bench.resets_of("read") > 0, GetParam() != "always");
  EXPECT_EQ(bench.address_first(), apart);
  EXPECT_EQ(bench.data_first(), apart);
  fmt::print("{} responses compared in {} clocks\n", bench.compared(), bench.clock());
}

TEST(Rate, IsARequestInThreeClocksInBothDirections) {
  RegisterBench bench(4);
  bench.steps(20);  // reset is over, and ready high
  constexpr unsigned kRequests = 1000;
  for (unsigned i = 0; i < kRequests; ++i) {
    bench.driver().write({0x060, i, 0xF});
    bench.driver().read(0x060);
  }
  const std::uint64_t first = bench.clock();
  bench.run();
  const auto& writes = bench.driver().write_responses();
  const auto& reads = bench.driver().read_responses();
  EXPECT_EQ(writes.front().cycle - first, 3u);  // latency
  EXPECT_EQ(reads.front().cycle - first, 3u);
  EXPECT_EQ(writes.back().cycle - writes.front().cycle, 3 * (kRequests - 1));
  EXPECT_EQ(reads.back().cycle - reads.front().cycle, 3 * (kRequests - 1));
  // Read and write of one clock: the read sees what was before.
  for (unsigned i = 1; i < kRequests; ++i) EXPECT_EQ(reads[i].data, i - 1);
}

TEST(Order, AStalledDirectionDoesNotHoldTheOther) {
  for (const bool writes_stall : {true, false}) {
    RegisterBench bench(6);
    tb::AxiThrottles throttles;
    (writes_stall ? throttles.b : throttles.r) = shut(100'000);
    bench.driver().throttle(throttles);
    for (std::uint32_t i = 0; i < 50; ++i) {
      bench.driver().write({0x060, i, 0xF});
      bench.driver().read(0x060);
    }
    bench.steps(180);
    EXPECT_EQ(bench.driver().write_responses().size(), writes_stall ? 0u : 50u);
    EXPECT_EQ(bench.driver().read_responses().size(), writes_stall ? 50u : 0u);
    bench.driver().throttle({});
    bench.run();
  }
}

}  // namespace
}  // namespace hwffd::test
