// Cores that count the results of a packet and tell when the last is there (FEATURES bit 6).
#include <gtest/gtest.h>

#include "named.hpp"
#include "page_run.hpp"

namespace hwffd::test {
namespace {

class Marks : public ::testing::TestWithParam<PageBuild> {};

// What is expected does not come from the model: one unit more behind the results, which says how
// many they are, with `tlast`, which the last result has not.
TEST_P(Marks, ResultsAreCountedBehindThem) {
  for (const char* sink : {"always", "bernoulli", "sparse"}) {
    PageRun run(GetParam(), 7, "bernoulli", sink);
    tb::Random random(7);
    LatticeWords lattice = random_lattice(run.codec(), random, {5, 4, 6});
    if ((GetParam().core.features & model::kFourthFeature) != 0)
      lattice = with_fourth(lattice, run.codec(), random);
    run.send_bspline();
    run.send(page_packet(1, lattice));
    std::vector<std::uint32_t> counts;
    std::vector<bool> interrupts;
    for (const bool every : {false, true}) {
      for (const bool fourth : {false, true}) {
        for (const std::size_t vertices : {1, 2, 9}) {
          PageVertices how;
          how.every = every;
          how.fourth = fourth;
          how.count = true;
          how.interrupt = every != (vertices == 2);
          run.send(page_vertices_packet(
              1, random_vertices(run.codec(), random, lattice.dims, vertices), how));
          interrupts.push_back(how.interrupt);
          counts.push_back(static_cast<std::uint32_t>(vertices * (fourth ? 2 : 1)));
        }
      }
    }
    ASSERT_TRUE(run.run());
    std::size_t at = 0;
    const auto& results = run.bench().results();
    for (std::size_t packet = 0; packet < counts.size(); ++packet) {
      for (std::uint32_t i = 0; i < counts[packet]; ++i, ++at) {
        EXPECT_FALSE(results.at(at).last);
        EXPECT_FALSE(results.at(at).user);
      }
      const Beat& unit = results.at(at++);
      EXPECT_TRUE(unit.last);
      EXPECT_EQ(unit.user, interrupts[packet]);
      EXPECT_EQ(unit.words, (std::array<std::uint32_t, 4>{counts[packet], 0, 0, ~0U}));
    }
    EXPECT_EQ(at, results.size());
  }
}

// As many packets as the core holds are inside, each of one vertex, since nothing is taken: what
// each of them asked for is still known when its result leaves.
TEST_P(Marks, EachPacketInsideKeepsItsFlags) {
  constexpr int kPackets = 400;
  PageRun run(GetParam(), 9);
  tb::Random random(9);
  const LatticeWords lattice = random_lattice(run.codec(), random, {4, 4, 4});
  run.send_bspline();
  run.send(page_packet(1, lattice));
  int last_result = 0;
  for (int packet = 0; packet < kPackets; ++packet) {
    PageVertices how;
    how.count = random.chance(0.5);
    how.interrupt = random.chance(0.5);
    last_result += how.count ? 0 : 1;
    run.send(page_vertices_packet(1, random_vertices(run.codec(), random, lattice.dims, 1), how));
  }
  ASSERT_TRUE(run.bench().raises_valid_without_ready(20'000, 20'000));
  ASSERT_TRUE(run.run());
  EXPECT_EQ(run.bench().results().size(), 2U * kPackets - last_result);
}

INSTANTIATE_TEST_SUITE_P(, Marks, ::testing::ValuesIn(page_builds([](const PageBuild& build) {
                           return (build.core.features & model::kMarksFeature) != 0;
                         })),
                         by_name);

}  // namespace
}  // namespace hwffd::test
