// The generator: the same numbers everywhere, and evenly spread.
#include "hwffd/tb/random.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cstdlib>
#include <set>
#include <string>
#include <vector>

namespace hwffd::tb {
namespace {

TEST(Random, IsTheStandardGenerator) {
  // The C++ standard gives the 10000th number of the default seed.
  Random random(5489);
  for (int i = 0; i < 9999; ++i) random.bits();
  EXPECT_EQ(random.bits(), 9981545732273789042u);
}

TEST(Random, ConversionsAreFixed) {
  // The first numbers of seed 5489 are 14514284786278117030 and 4620546740167642908.
  Random a(5489);
  Random b(5489);
  Random c(5489);
  EXPECT_EQ(a.below(1000), 30u);
  EXPECT_EQ(a.below(1000), 908u);
  EXPECT_EQ(b.word(), 14514284786278117030u >> 32);
  EXPECT_EQ(c.unit(), static_cast<double>(14514284786278117030u >> 11) / 9007199254740992.0);
}

TEST(Random, BelowIsEven) {
  Random random(1);
  std::array<unsigned, 7> counts{};
  for (int i = 0; i < 70000; ++i) ++counts.at(random.below(7));
  for (const unsigned count : counts) EXPECT_NEAR(count, 10000, 500);
  EXPECT_THROW(random.below(0), std::invalid_argument);
  // Three quarters of 2^64: a remainder alone would fall into the lowest third every second time.
  const std::uint64_t third = std::uint64_t{1} << 62;
  unsigned lowest = 0;
  for (int i = 0; i < 9000; ++i) lowest += random.below(3 * third) < third ? 1 : 0;
  EXPECT_NEAR(lowest, 3000, 250);
}

TEST(Random, BetweenIncludesBothEnds) {
  Random random(1);
  std::set<std::uint64_t> seen;
  for (int i = 0; i < 200; ++i) seen.insert(random.between(3, 6));
  EXPECT_EQ(seen, (std::set<std::uint64_t>{3, 4, 5, 6}));
  EXPECT_EQ(random.between(9, 9), 9u);
  EXPECT_THROW(random.between(2, 1), std::invalid_argument);
  random.between(0, ~std::uint64_t{0});  // the whole range does not overflow
}

TEST(Random, UnitAndChance) {
  Random random(1);
  double sum = 0;
  unsigned hits = 0;
  for (int i = 0; i < 20000; ++i) {
    const double u = random.unit();
    ASSERT_GE(u, 0.0);
    ASSERT_LT(u, 1.0);
    sum += u;
    hits += random.chance(0.25) ? 1 : 0;
    ASSERT_FALSE(random.chance(0.0));
    ASSERT_TRUE(random.chance(1.0));
  }
  EXPECT_NEAR(sum / 20000, 0.5, 0.01);
  EXPECT_NEAR(hits, 5000, 250);
}

TEST(Random, PicksEveryElement) {
  Random random(1);
  const std::vector<std::string> list = {"a", "b", "c"};
  std::set<std::string> seen;
  std::set<int> numbers;
  for (int i = 0; i < 100; ++i) {
    seen.insert(random.pick(list));
    numbers.insert(random.pick({4, 5}));
  }
  EXPECT_EQ(seen.size(), 3u);
  EXPECT_EQ(numbers.size(), 2u);
  EXPECT_THROW(random.pick(std::vector<int>{}), std::invalid_argument);
}

TEST(Random, DerivedSeedsDiffer) {
  std::set<std::uint64_t> seeds;
  for (std::uint64_t seed = 0; seed < 100; ++seed) {
    for (std::uint64_t index = 0; index < 10; ++index) seeds.insert(derive_seed(seed, index));
  }
  EXPECT_EQ(seeds.size(), 1000u);
}

std::uint64_t seed_with(const char* value) {
  setenv("HWFFD_TEST_SEED", value, 1);
  return seed_from_environment(5, "HWFFD_TEST_SEED");
}

TEST(SeedFromEnvironment, ReadsNumbers) {
  EXPECT_EQ(seed_with(""), 5u);
  EXPECT_EQ(seed_with("0"), 0u);
  EXPECT_EQ(seed_with("010"), 10u);
  EXPECT_EQ(seed_with("0xff"), 255u);
  EXPECT_EQ(seed_with("18446744073709551615"), ~std::uint64_t{0});
  EXPECT_EQ(seed_from_environment(5, "HWFFD_NO_SUCH_SEED"), 5u);
  if (std::getenv("SEED") == nullptr) {
    setenv("SEED", "7", 1);
    EXPECT_EQ(seed_from_environment(5), 7u);
    unsetenv("SEED");
  }
}

TEST(SeedFromEnvironment, RefusesAnythingElse) {
  for (const char* value : {"x", "-1", " 1", "1 ", "12a", "0x", "18446744073709551616"}) {
    EXPECT_THROW(seed_with(value), std::invalid_argument) << value;
  }
}

}  // namespace
}  // namespace hwffd::tb
