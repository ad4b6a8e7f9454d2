// Operands by TestFloat's scheme, and that a wrong reference shows.
#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "Vfp_mul_e8f23_l4.h"
#include "host.hpp"
#include "operands.hpp"
#include "unit.hpp"

namespace {

using namespace hwffd::testfloat;

TEST(Operands, EveryPairOfClassesComes) {
  Operands operands(2, 1);
  std::set<std::uint32_t> pairs;
  while (operands.combinations() < operands.all_combinations()) {
    const auto words = operands.next();
    pairs.insert((words[0] >> 23) << 9 | words[1] >> 23);
  }
  EXPECT_GE(pairs.size(), operands.all_combinations());
  EXPECT_EQ(operands.all_combinations(), std::uint64_t{operands.classes()} * operands.classes());
}

TEST(Operands, OfThreeAreAllUsed) {
  Operands operands(3, 2);
  std::set<std::uint32_t> last;
  for (int i = 0; i < 1000; ++i) last.insert(operands.next()[2]);
  EXPECT_GT(last.size(), 500u);
}

TEST(Operands, ASeedGivesThemAgain) {
  Operands operands(2, 3), same(2, 3), other(2, 4);
  bool differs = false;
  for (int i = 0; i < 1000; ++i) {
    const auto words = operands.next();
    EXPECT_EQ(words, same.next());
    differs |= words != other.next();
  }
  EXPECT_TRUE(differs);
}

TEST(Host, RoundsTowardsZeroWhileItIsAskedTo) {
  const std::array<std::uint32_t, 3> third{0x3eaaaaab, 0x3eaaaaab, 0};
  const std::uint32_t nearest = host(Operation::kMul, third);
  {
    const TowardsZero wrong;
    EXPECT_EQ(host(Operation::kMul, third) + 1, nearest);
  }
  EXPECT_EQ(host(Operation::kMul, third), nearest);
}

TEST(Unit, TheMultiplierIsRightAndAWrongReferenceIsFound) {
  const Row row = run<Vfp_mul_e8f23_l4, false>("mul", 4, 100'000, 1);
  EXPECT_EQ(row.cases, 100'000u);
  EXPECT_EQ(row.mismatches, 0u) << row.first;
  EXPECT_GT(row.control_mismatches, row.control_cases / 100);
  EXPECT_EQ(row.combinations, row.all_combinations);
}

TEST(Unit, AnotherOperationIsFound) {
  const Row row = run<Vfp_mul_e8f23_l4, false>("add", 4, 1000, 1);
  EXPECT_GT(row.mismatches, 500u);
  EXPECT_FALSE(row.first.empty());
}

TEST(Unit, ALatencyThatIsNotItsIsFound) {
  EXPECT_GT((run<Vfp_mul_e8f23_l4, false>("mul", 3, 1000, 1).mismatches), 500u);
}

}  // namespace
