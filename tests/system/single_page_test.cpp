// Cores with a single page behind opcodes 5 to 7: opcodes 2 and 3 are of the same one, so a lattice
// waits until no vertex inside reads the one before.
#include <gtest/gtest.h>

#include "named.hpp"
#include "page_run.hpp"

namespace hwffd::test {
namespace {

class OnePage : public ::testing::TestWithParam<PageBuild> {
 protected:
  LatticeWords lattice() { return random_lattice(codec_, random_, {4, 5, 6}); }
  std::vector<VertexBeat> vertices(std::size_t count) {
    return random_vertices(codec_, random_, {4, 5, 6}, count);
  }

  const WordCodec codec_{find_configuration(GetParam().row).format};
  tb::Random random_{1};
};

TEST_P(OnePage, IsThatOfAllOpcodes) {
  PageRun run(GetParam(), 1, "bernoulli", "bursts");
  const LatticeWords first = lattice(), second = lattice();
  const auto some = vertices(5);
  run.send_bspline();
  run.send(lattice_packet(first));
  run.send(vertices_packet(some));
  run.send(page_vertices_packet(0, some));
  run.send(page_packet(0, second));
  run.send(page_vertices_packet(0, some));
  run.send(vertices_packet(some));
  run.send(points_packet(0, first, 0, first.points.size()));
  run.send(vertices_packet(some));
  run.send(lattice_packet(second));
  run.send(page_vertices_packet(0, some));
  ASSERT_TRUE(run.run());
  EXPECT_EQ(run.words(0, 5), run.words(5, 5));
  EXPECT_NE(run.words(0, 5), run.words(10, 5));
  EXPECT_EQ(run.words(10, 5), run.words(15, 5));
  EXPECT_EQ(run.words(20, 5), run.words(0, 5));
  EXPECT_EQ(run.words(25, 5), run.words(10, 5));
  for (const std::uint64_t count : run.bench().events()) EXPECT_EQ(count, 0U);
}

TEST_P(OnePage, AnotherOneIsBeyondTheLast) {
  PageRun run(GetParam(), 1, "bernoulli", "bursts");
  const LatticeWords first = lattice();
  const auto some = vertices(3);
  run.send_bspline();
  run.send(page_packet(0, first));
  run.send(page_vertices_packet(0, some));
  for (const int page : {1, 2, 255}) {
    run.send(page_packet(page, lattice()));
    run.send(points_packet(page, lattice(), 0, 2));
    run.send(page_vertices_packet(page, some));
  }
  run.send(page_vertices_packet(0, some));
  ASSERT_TRUE(run.run());
  EXPECT_EQ(run.words(0, 3), run.words(12, 3));
  EXPECT_EQ(run.pulses(event::kNoLattice), 3U * (1 + 1 + 3));
  for (std::size_t r = 3; r < 12; ++r) {
    EXPECT_EQ(run.bench().results()[r].words[3] >> 16, kStatusUnloaded >> 16) << r;
  }
}

// Vertices before a change see the old points, those after it the new ones, whichever opcode brings
// them and whatever the results have to wait for.
TEST_P(OnePage, ChangesWaitForTheirReaders) {
  const LatticeWords first = lattice(), second = lattice();
  const auto some = vertices(20);
  for (const char* sink : {"always", "bernoulli", "long_stall", "sparse"}) {
    PageRun run(GetParam(), 1, "always", sink);
    run.send_bspline();
    run.send(lattice_packet(first));
    run.send(vertices_packet(some));
    std::vector<std::size_t> changed;
    for (const auto& packet :
         {lattice_packet(second), page_packet(0, first), points_packet(0, second, 0, 120)}) {
      run.send(packet);
      changed.push_back(run.sent() - packet.size() + 1);  // the first beat behind its header
      run.send(vertices_packet(some));
    }
    ASSERT_TRUE(run.run());
    for (std::size_t turn = 0; turn < 4; ++turn) {
      EXPECT_EQ(run.words(20 * turn, 20), run.words(20 * (turn % 2), 20)) << sink << " " << turn;
    }
    EXPECT_NE(run.words(0, 20), run.words(20, 20));
    for (std::size_t turn = 0; turn < changed.size() && std::string(sink) == "always"; ++turn) {
      EXPECT_GE(run.bench().accept_clocks()[changed[turn]],
                run.bench().result_clocks()[20 * turn + 19])
          << "before the last reader of the old points had left";
    }
  }
}

// There is no second buffer in which the old lattice could stay.
TEST_P(OnePage, ALatticeThatIsCutShortLeavesNone) {
  PageRun run(GetParam(), 1);
  const LatticeWords first = lattice();
  const auto some = vertices(4);
  run.send_bspline();
  run.send(lattice_packet(first));
  run.send(vertices_packet(some));
  auto cut = lattice_packet(lattice());
  cut.resize(50);
  cut.back().last = true;
  run.send(cut);
  run.send(vertices_packet(some));
  run.send(lattice_packet(first));
  run.send(vertices_packet(some));
  ASSERT_TRUE(run.run());
  EXPECT_EQ(run.words(0, 4), run.words(8, 4));
  EXPECT_EQ(run.pulses(event::kPacketShort), 1U);
  EXPECT_EQ(run.pulses(event::kNoLattice), 4U);
  EXPECT_EQ(run.bench().results()[4].words[3] >> 16, kStatusUnloaded >> 16);
}

INSTANTIATE_TEST_SUITE_P(, OnePage, ::testing::ValuesIn(page_builds([](const PageBuild& build) {
                           return build.core.pages == 1;
                         })),
                         by_name);

}  // namespace
}  // namespace hwffd::test
