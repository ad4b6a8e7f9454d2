// The patterns of the throttles.
#include "hwffd/tb/throttle.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <string>

namespace hwffd::tb {
namespace {

std::string pattern(Throttle throttle, unsigned cycles) {
  std::string text;
  for (unsigned i = 0; i < cycles; ++i) text += throttle.willing() ? '1' : '0';
  return text;
}

struct Runs {
  std::size_t longest_on = 0;
  std::size_t longest_off = 0;
  double rate = 0;
};

Runs measure(const std::string& name, std::uint64_t seed) {
  const std::string text = pattern(make_throttle(name, seed), 200'000);
  Runs runs;
  std::size_t length = 0;
  for (std::size_t i = 0; i < text.size(); ++i) {
    length = i != 0 && text[i] == text[i - 1] ? length + 1 : 1;
    auto& longest = text[i] == '1' ? runs.longest_on : runs.longest_off;
    longest = std::max(longest, length);
  }
  const auto on = std::count(text.begin(), text.end(), '1');
  runs.rate = static_cast<double>(on) / static_cast<double>(text.size());
  return runs;
}

TEST(Throttle, FixedPatterns) {
  EXPECT_EQ(pattern(Throttle::always(), 8), "11111111");
  EXPECT_EQ(pattern(Throttle::gaps(4), 12), "111011101110");
  EXPECT_EQ(pattern(Throttle::gaps(2), 6), "101010");
  EXPECT_EQ(pattern(Throttle::sparse(3), 9), "100100100");
  EXPECT_EQ(pattern(Throttle::bernoulli(1.0, 1), 4), "1111");
}

TEST(Throttle, RandomPatterns) {
  const Runs bernoulli = measure("bernoulli", 3);
  EXPECT_NEAR(bernoulli.rate, 0.5, 0.01);
  EXPECT_GT(bernoulli.longest_off, 10u);
  const Runs bursts = measure("bursts", 3);
  EXPECT_NEAR(bursts.rate, 0.5, 0.02);
  EXPECT_EQ(bursts.longest_on, 16u);
  EXPECT_EQ(bursts.longest_off, 16u);
  const Runs stall = measure("long_stall", 3);
  EXPECT_NEAR(stall.rate, 200.0 / 550.0, 0.04);
  EXPECT_GT(stall.longest_on, 280u);
  EXPECT_LE(stall.longest_on, 300u);
  EXPECT_GT(stall.longest_off, 470u);
  EXPECT_LE(stall.longest_off, 500u);
}

TEST(Throttle, EveryNameIsItsOwnPattern) {
  std::set<std::string> patterns;
  for (const std::string& name : throttle_names()) {
    const std::string once = pattern(make_throttle(name, 5), 1000);
    EXPECT_EQ(once, pattern(make_throttle(name, 5), 1000)) << name;
    EXPECT_NE(once.find('1'), std::string::npos) << name;
    patterns.insert(once);
  }
  EXPECT_EQ(patterns.size(), 6u);
  EXPECT_NE(pattern(make_throttle("bursts", 5), 1000), pattern(make_throttle("bursts", 6), 1000));
}

TEST(Throttle, RefusesNonsense) {
  EXPECT_THROW(make_throttle("never", 1), std::invalid_argument);
  EXPECT_THROW(Throttle::gaps(1), std::invalid_argument);
  EXPECT_THROW(Throttle::sparse(0), std::invalid_argument);
  EXPECT_THROW(Throttle::bernoulli(0.0, 1), std::invalid_argument);
  EXPECT_THROW(Throttle::bernoulli(1.5, 1), std::invalid_argument);
  EXPECT_THROW(Throttle::runs({0, 3}, {1, 1}, 1), std::invalid_argument);
  EXPECT_THROW(Throttle::runs({1, 3}, {4, 3}, 1), std::invalid_argument);
}

}  // namespace
}  // namespace hwffd::tb
