// Every configuration x stimulus x source throttle x sink throttle x 8 seeds, every bit compared.
#include <gtest/gtest.h>

#include <cstdio>
#include <tuple>

#include "hwffd/tb/throttle.hpp"
#include "system_run.hpp"

namespace hwffd::test {
namespace {

constexpr std::uint64_t kSeeds = 8;
constexpr std::size_t kMatrixVertices = 5;

class Matrix : public ::testing::TestWithParam<std::tuple<Configuration, std::string>> {};

TEST_P(Matrix, EveryThrottleAndSeed) {
  const auto& [row, stimulus] = GetParam();
  const std::uint64_t first_seed = tb::seed_from_environment(1);
  const std::uint64_t seeds = share_of(kSeeds);
  std::uint64_t checked = 0;
  std::uint64_t runs = 0;
  for (const std::string& source : tb::throttle_names()) {
    for (const std::string& sink : tb::throttle_names()) {
      for (std::uint64_t seed = first_seed; seed < first_seed + seeds; ++seed) {
        SystemRun run(row, seed, source, sink);
        run.send_bspline();
        run.send(interleaved_packet(make_stimulus(stimulus, run.codec(), kMatrixVertices, seed)));
        ASSERT_TRUE(run.run());
        checked += run.bench().scoreboard().checked();
        ++runs;
      }
    }
  }
  EXPECT_EQ(runs, tb::throttle_names().size() * tb::throttle_names().size() * seeds);
  EXPECT_EQ(checked, runs * kMatrixVertices);
  std::printf("%llu runs, %llu vertices compared\n", static_cast<unsigned long long>(runs),
              static_cast<unsigned long long>(checked));
}

INSTANTIATE_TEST_SUITE_P(, Matrix,
                         ::testing::Combine(::testing::ValuesIn(built_configurations()),
                                            ::testing::ValuesIn(stimulus_names())),
                         by_name);

}  // namespace
}  // namespace hwffd::test
