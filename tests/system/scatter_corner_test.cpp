// Scatter cores at the ends of their parameters: any packets, each with its model.
#include <gtest/gtest.h>

#include <array>

#include "hwffd/tb/throttle.hpp"
#include "named.hpp"
#include "scatter_run.hpp"
#include "scatter_stimulus.hpp"
#include "share.hpp"

namespace hwffd::test {
namespace {

class ScatterCorner : public ::testing::TestWithParam<ScatterBuild> {};

TEST_P(ScatterCorner, AnyPacketsInAnyOrder) {
  const std::array<int, 3> dims = {4, 4, 4};
  const std::uint64_t first = tb::seed_from_environment(1);
  for (std::uint64_t seed = first; seed < first + share_of(12); ++seed) {
    const auto& names = tb::throttle_names();
    ScatterRun run(GetParam(), seed, names[seed % names.size()],
                   names[seed / names.size() % names.size()]);
    tb::Random random(seed);
    ScatterPackets packets(run.codec(), random, GetParam().axis, GetParam().pages);
    run.send(packets.functions());
    for (int page = GetParam().pages - 1; page >= 0; --page) {
      run.send(packets.any(20));
      run.send(packets.garbage(10));
      run.send(gradients_packet(page, random_gradients(run.codec(), random, dims, 6),
                                gradients_to(dims, true)));
      run.send(collect_packet(page));
    }
    ASSERT_TRUE(run.run());
    EXPECT_GE(run.bench().results().size(), 64U * GetParam().pages);
  }
}

// The farthest cell of the largest lattice, in the last page.
TEST_P(ScatterCorner, TheLastCell) {
  const int axis = GetParam().axis;
  const std::array<int, 3> dims = {axis, axis, axis};
  ScatterRun run(GetParam(), 2);
  tb::Random random(2);
  auto vertices = random_gradients(run.codec(), random, dims, 3);
  for (GradientBeats& vertex : vertices) vertex.cell = {axis - 4, axis - 4, axis - 4};
  const int page = GetParam().pages - 1;
  run.send_functions();
  run.send(gradients_packet(page, vertices, gradients_to(dims)));
  run.send(collect_packet(page));
  ASSERT_TRUE(run.run());
  EXPECT_EQ(run.bench().results().size(), static_cast<std::size_t>(axis) * axis * axis);
  EXPECT_TRUE(run.idle());
}

INSTANTIATE_TEST_SUITE_P(, ScatterCorner, ::testing::ValuesIn(scatter_builds()), by_name);

}  // namespace
}  // namespace hwffd::test
