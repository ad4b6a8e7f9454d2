// Cores of random parameters, each built and run on random packets: tests/random/__main__.py.
#include "hwffd/tb/random.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cstdlib>
#include <string>

namespace hwffd::test {
namespace {

/// So many from the seed that is given, or from one that the sources of the core are the reason
/// for.
void expect_good(const std::string& count) {
  const std::uint64_t seed = tb::seed_from_environment(0);
  const std::string command =
      fmt::format("PYTHONPATH='{}' '{}' -B -m tests.random --words '{}' --folder '{}' --count {}{}",
                  HWFFD_SOURCE_DIR, HWFFD_PYTHON, HWFFD_RANDOM_WORDS, HWFFD_RANDOM_FOLDER, count,
                  seed == 0 ? "" : fmt::format(" --seed {}", seed));
  ASSERT_EQ(std::system(command.c_str()), 0) << command;
}

// As many as begin in ten seconds of a processor; in a soak, all up to its next seed.
TEST(Random, Configurations) {
  expect_good(std::getenv("HWFFD_SOAK") != nullptr ? "16" : "2 --seconds 10");
}

// Those of tests/random/regressions.csv, too.
TEST(RandomAndKnown, Configurations) { expect_good("14 --regressions"); }

}  // namespace
}  // namespace hwffd::test
