#include "fuzz.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "hwffd/tb/random.hpp"
#include "targets.hpp"

namespace hwffd {
namespace {

class Fuzz : public ::testing::TestWithParam<Target> {};

/// HWFFD_FUZZ_SEED chooses other inputs, HWFFD_FUZZ_INPUT one of them.
TEST_P(Fuzz, EveryInputIsReadOrRefused) {
  const Target& target = GetParam();
  const std::uint64_t seed = tb::seed_from_environment(1, "HWFFD_FUZZ_SEED");
  const std::uint64_t one = tb::seed_from_environment(target.inputs, "HWFFD_FUZZ_INPUT");
  const bool is_whole = one == target.inputs;
  const Tally tally = fuzz(target, seed, is_whole ? 0 : one, is_whole ? target.inputs : 1);
  for (const std::string& failure : tally.failures) ADD_FAILURE() << failure;
  fmt::print("{}: {} inputs, {} valid, {} refused\n", target.name, tally.valid + tally.refused,
             tally.valid, tally.refused);
  if (!is_whole || !tally.failures.empty()) return;
  EXPECT_EQ(tally.valid + tally.refused, target.inputs);
  EXPECT_GT(tally.valid, target.inputs / 100);
  EXPECT_GT(tally.refused, target.inputs / 100);
}

INSTANTIATE_TEST_SUITE_P(, Fuzz, ::testing::ValuesIn(targets()),
                         [](const auto& info) { return std::string(info.param.name); });

}  // namespace
}  // namespace hwffd
