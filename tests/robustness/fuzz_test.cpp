#include "fuzz.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "hwffd/tb/random.hpp"
#include "named.hpp"
#include "targets.hpp"

namespace hwffd {
namespace {

class Fuzz : public ::testing::TestWithParam<Target> {};

TEST_P(Fuzz, SeedsAreValid) {
  EXPECT_FALSE(GetParam().corpus.empty());
  for (const std::string& seed : GetParam().corpus) EXPECT_NO_THROW(GetParam().read(seed));
}

/// HWFFD_FUZZ_SEED chooses other inputs, HWFFD_FUZZ_INPUT one of them, HWFFD_FUZZ_TIMES more.
TEST_P(Fuzz, EveryInputIsReadOrRefused) {
  Target target = GetParam();
  target.inputs *= tb::seed_from_environment(1, "HWFFD_FUZZ_TIMES");
  const std::uint64_t seed = tb::seed_from_environment(1, "HWFFD_FUZZ_SEED");
  const std::uint64_t one = tb::seed_from_environment(target.inputs, "HWFFD_FUZZ_INPUT");
  const bool is_whole = one == target.inputs;
  const Tally tally = fuzz(target, seed, is_whole ? 0 : one, is_whole ? target.inputs : 1);
  for (const std::string& failure : tally.failures) ADD_FAILURE() << failure;
  fmt::print("{}: {} inputs, {} valid, {} refused\n", target.name, tally.valid + tally.refused,
             tally.valid, tally.refused);
  if (!is_whole || !tally.failures.empty()) return;
  EXPECT_EQ(tally.valid + tally.refused, target.inputs);
  constexpr std::uint64_t kFew = 1000;  // of which none may be valid: one in 64 is a seed
  if (target.inputs >= kFew) {
    EXPECT_GT(tally.valid, target.inputs / 100);
  }
  EXPECT_GT(tally.refused, target.inputs / 100);
}

INSTANTIATE_TEST_SUITE_P(, Fuzz, ::testing::ValuesIn(targets()), test::by_name);

}  // namespace
}  // namespace hwffd
