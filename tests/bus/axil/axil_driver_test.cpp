// The driver of the bus, on a slave in C++: it keeps the rules itself, and its requests come in
// every order.
#include "hwffd/tb/axil_driver.hpp"

#include <gtest/gtest.h>

#include <set>

#include "hwffd/tb/axil_checker.hpp"
#include "named.hpp"

namespace hwffd::tb {
namespace {

/// Takes anything at any time; answers in order, writes with OKAY, reads with their address.
class EasySlave {
 public:
  explicit EasySlave(std::uint64_t seed) : random_(seed) {}

  cores::AxiLiteSlavePins drive() {
    pins_.awready = random_.chance(0.5);
    pins_.wready = random_.chance(0.5);
    pins_.arready = random_.chance(0.5);
    pins_.bvalid = std::min(aw_, w_) > b_;
    pins_.rvalid = reads_.size() > r_;
    pins_.rdata = pins_.rvalid ? reads_[r_] : 0;
    return pins_;
  }
  void accept(const cores::AxiLiteMasterPins& master) {
    b_ += pins_.bvalid && master.bready ? 1 : 0;
    r_ += pins_.rvalid && master.rready ? 1 : 0;
    aw_ += master.awvalid && pins_.awready ? 1 : 0;
    if (master.wvalid && pins_.wready) {
      ++w_;
      data.push_back(master.wdata);
    }
    if (master.arvalid && pins_.arready) reads_.push_back(master.araddr);
    first_aw += aw_ > w_ ? 1 : 0;
    first_w += w_ > aw_ ? 1 : 0;
  }

  std::vector<std::uint32_t> data;
  std::uint64_t first_aw = 0;
  std::uint64_t first_w = 0;

 private:
  Random random_;
  cores::AxiLiteSlavePins pins_;
  std::vector<std::uint32_t> reads_;
  std::uint64_t aw_ = 0, w_ = 0, b_ = 0, r_ = 0;
};

class DriverThrottle : public testing::TestWithParam<std::string> {};
INSTANTIATE_TEST_SUITE_P(Every, DriverThrottle,
                         testing::Values("always", "gaps", "sparse", "bernoulli", "bursts",
                                         "long_stall", "mixed"),
                         test::by_name);

TEST_P(DriverThrottle, SendsAllInOrderAndKeepsTheRules) {
  AxiLiteDriver driver(1, AxiThrottles::make(GetParam(), 2));
  AxiLiteChecker checker;
  EasySlave slave(3);
  checker.observe({true, {}, {}}, 0);
  checker.observe({}, 1);
  for (std::uint32_t i = 0; i < 300; ++i) {
    driver.write({4 * i, i, 0xF});
    driver.read(4 * i);
  }
  std::set<std::uint32_t> idle;
  std::uint64_t cycle = 2;
  for (; !driver.idle() && cycle < 100'000; ++cycle) {
    const cores::AxiLiteMasterPins master = driver.drive();
    const cores::AxiLiteSlavePins pins = slave.drive();
    checker.observe({false, master, pins}, cycle);
    if (!master.awvalid) idle.insert(master.awaddr);
    slave.accept(master);
    driver.accept(pins, cycle);
  }
  checker.finish(cycle);
  EXPECT_TRUE(driver.idle());
  EXPECT_EQ(checker.violations(), 0u) << checker.reports().front();
  EXPECT_EQ(checker.writes(), 300u);
  EXPECT_EQ(checker.reads(), 300u);
  for (std::uint32_t i = 0; i < 300; ++i) {
    EXPECT_EQ(slave.data.at(i), i);
    EXPECT_EQ(driver.read_responses().at(i).data, 4 * i);
  }
  EXPECT_GT(slave.first_aw, 0u);
  EXPECT_GT(slave.first_w, 0u);
  EXPECT_TRUE(idle.empty() || idle.size() > 10);  // what lies on an idle channel is random
}

TEST(AxiLiteDriver, ForgetsAllWhenCleared) {
  AxiLiteDriver driver(1);
  driver.write({0, 0, 0xF});
  driver.read(0);
  EXPECT_TRUE(driver.drive().awvalid);
  driver.clear();
  EXPECT_TRUE(driver.idle());
  const cores::AxiLiteMasterPins pins = driver.drive();
  EXPECT_FALSE(pins.awvalid || pins.wvalid || pins.arvalid);
}

}  // namespace
}  // namespace hwffd::tb
