// Cores that count the results of a packet and tell when the last is there (FEATURES bit 6).
#include <gtest/gtest.h>

#include "named.hpp"
#include "page_builds.hpp"
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
    for (const bool every : {false, true}) {
      for (const bool fourth : {false, true}) {
        for (const std::size_t vertices : {1, 2, 9}) {
          PageVertices how;
          how.every = every;
          how.fourth = fourth;
          how.count = true;
          run.send(page_vertices_packet(
              1, random_vertices(run.codec(), random, lattice.dims, vertices), how));
          counts.push_back(static_cast<std::uint32_t>(vertices * (fourth ? 2 : 1)));
        }
      }
    }
    ASSERT_TRUE(run.run());
    std::size_t at = 0;
    for (const std::uint32_t count : counts) {
      const auto& results = run.bench().results();
      for (std::uint32_t i = 0; i < count; ++i) EXPECT_FALSE(results.at(at++).last);
      const Beat& unit = results.at(at++);
      EXPECT_TRUE(unit.last);
      EXPECT_EQ(unit.words, (std::array<std::uint32_t, 4>{count, 0, 0, ~0U}));
    }
    EXPECT_EQ(at, run.bench().results().size());
  }
}

INSTANTIATE_TEST_SUITE_P(, Marks, ::testing::ValuesIn(page_builds([](const PageBuild& build) {
                           return (build.core.features & model::kMarksFeature) != 0;
                         })),
                         by_name);

}  // namespace
}  // namespace hwffd::test
