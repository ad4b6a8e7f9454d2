// Vertices of a lattice that is kept on chip: the bits of the interleaved stream at the rate of the
// organization, lattices changed between vertices and loaded while the old one is read.
#include <gtest/gtest.h>

#include "hwffd/lattice/box.hpp"
#include "hwffd/lattice/deformation.hpp"
#include "hwffd/lattice/interleave.hpp"
#include "hwffd/mesh/mesh.hpp"
#include "hwffd/model/schedule.hpp"
#include "system_run.hpp"

namespace hwffd::test {
namespace {

class Resident : public PerConfiguration {};

TEST_P(Resident, SameBitsAsInterleaved) {
  SystemRun run(GetParam(), 1, "gaps", "bernoulli");
  const Mesh mesh = Mesh::procedural();
  run.send_bspline();
  std::size_t vertices = 0;
  for (const Index3& dims : {Index3{4, 4, 4}, Index3{5, 7, 6}, Index3{16, 9, 12}}) {
    const Box box = Box::around(mesh.positions());
    const Lattice twisted = Deformation::parse("twist:90").apply(box.lattice(dims));
    const Normalization normalization = Normalization::of(twisted, run.codec());
    const auto embedded = box.embed(dims, Points(mesh.positions().topRows(share_of(60))));
    run.send(lattice_packet(lattice_words(twisted, run.codec(), normalization)));
    run.send(vertices_packet(vertex_beats(embedded, run.codec())));
    run.send(interleaved_packet(interleave(twisted, embedded, run.codec(), normalization)));
    vertices += embedded.size();
  }
  ASSERT_TRUE(run.run());
  const std::vector<Beat>& results = run.bench().results();
  ASSERT_EQ(results.size(), 2 * vertices);
  const std::size_t each = vertices / 3;
  for (std::size_t lattice = 0; lattice < 3; ++lattice) {
    for (std::size_t v = 0; v < each; ++v) {
      const std::size_t at = 2 * lattice * each + v;
      EXPECT_EQ(results[at].words, results[at + each].words) << "vertex " << v;
    }
  }
}

TEST_P(Resident, ClocksPerVertexEqualTheFormula) {
  SystemRun run(GetParam(), 1);
  tb::Random random(1);
  const LatticeWords lattice = random_lattice(run.codec(), random, 16);
  run.send_bspline();
  run.send(lattice_packet(lattice));
  const auto vertices = random_vertices(run.codec(), random, lattice.dims, 41 + 120);
  run.send(vertices_packet(vertices));
  ASSERT_TRUE(run.run());
  EXPECT_EQ(run.bench().clocks_per_result(40, 160), expected_interval(GetParam()));
}

// Every place of both buffers: a lattice of 16 points an axis whose points all differ, read at its
// corners and along its diagonal.
TEST_P(Resident, TheLargestLattice) {
  SystemRun run(GetParam(), 1);
  tb::Random random(3);
  run.send_bspline();
  for (int buffer = 0; buffer < 2; ++buffer) {
    const LatticeWords lattice = random_lattice(run.codec(), random, {16, 16, 16});
    std::vector<VertexBeat> vertices;
    for (int cell = 0; cell < 13; ++cell) {
      for (const Index3& at : {Index3{cell, cell, cell}, Index3{12 - cell, cell, 5}}) {
        vertices.push_back(random_vertices(run.codec(), random, lattice.dims, 1).front());
        vertices.back().cell = at;
      }
    }
    run.send(lattice_packet(lattice));
    run.send(vertices_packet(vertices));
  }
  ASSERT_TRUE(run.run());
}

// While the first lattice is in use, the next one comes in: its header does not wait for the last
// result of the first, and at more than 8 clocks a vertex its last point comes before that, too.
TEST_P(Resident, LoadsALatticeWhileTheOldOneIsRead) {
  SystemRun run(GetParam(), 1);
  tb::Random random(1);
  LatticeWords lattice = random_lattice(run.codec(), random, 4);
  const std::vector<Beat> second = lattice_packet(random_lattice(run.codec(), random, 4));
  run.send_bspline();
  run.send(lattice_packet(lattice));
  run.send(vertices_packet(random_vertices(run.codec(), random, lattice.dims, 20)));
  run.send(second);
  ASSERT_TRUE(run.run());
  const std::vector<std::uint64_t>& accepted = run.bench().accept_clocks();
  const std::uint64_t last_result = run.bench().result_clocks().back();
  EXPECT_LT(accepted[accepted.size() - second.size()], last_result);
  if (expected_interval(GetParam()) > 8) {
    EXPECT_LT(accepted.back(), last_result);
  }
}

// Vertices of one cell, again and again under other points and other functions: what those before
// had must not be used. Two lattices one after the other come into the same buffer, and
// packets cut short change nothing.
TEST_P(Resident, ReloadsBetweenVerticesOfOneCell) {
  for (std::uint64_t seed = 1; seed <= share_of(4); ++seed) {
    SystemRun run(GetParam(), seed, seed == 1 ? "always" : "gaps", seed == 2 ? "always" : "bursts");
    tb::Random random(seed);
    const std::array<int, 3> dims = {4, 4, 4};
    const auto lattice = [&] { return lattice_packet(random_lattice(run.codec(), random, dims)); };
    run.send_bspline();
    run.send(lattice());
    for (int reload = 0; reload < 12; ++reload) {
      run.send(vertices_packet(random_vertices(run.codec(), random, dims, random.between(1, 40))));
      const auto which = random.below(5);
      if (which <= 1) run.send(lattice());
      if (which == 1) run.send(lattice());
      if (which == 2) run.send(coefficients_packet(random_coefficients(run.codec(), random)));
      if (which == 3) {
        std::vector<Beat> cut = lattice();
        cut.resize(20);
        cut.back().last = true;
        run.send(cut);
      }
      if (which == 4) {
        run.send(interleaved_packet(make_stimulus("random", run.codec(), 1, seed + reload)));
      }
    }
    ASSERT_TRUE(run.run());
  }
}

HWFFD_FOR_EACH_CONFIGURATION(Resident);

/// Those of at most 3 clocks a vertex.
std::vector<Configuration> fast_configurations() {
  return rows_where([](const Configuration& row) {
    return cores::has_stream_core(row) && expected_interval(row) <= 3;
  });
}

/// A lattice of 16 points an axis and vertices in random cells of it.
class Sustained : public PerConfiguration {
 protected:
  /// Coefficients, lattice and packet; returns the beats before the first vertex.
  std::size_t send(SystemRun& run, std::size_t vertices) {
    tb::Random random(tb::seed_from_environment(1));
    const LatticeWords lattice = random_lattice(run.codec(), random, {16, 16, 16});
    const std::vector<Beat> load = lattice_packet(lattice);
    const std::vector<Beat> bspline =
        coefficients_packet(watertight_bspline(run.codec()), run.codec());
    run.send(bspline);
    run.send(load);
    run.send(vertices_packet(random_vertices(run.codec(), random, lattice.dims, vertices)));
    return bspline.size() + load.size() + 1;
  }
};
GTEST_ALLOW_UNINSTANTIATED_PARAMETERIZED_TEST(Sustained);  // no row of the netlists is so fast

// Over 100,000 vertices the rate is the organization's within 1 %, whatever cells they are in.
TEST_P(Sustained, RateOverRandomCells) {
  constexpr std::size_t kVertices = 100000;
  SystemRun run(GetParam(), 1);
  const std::size_t first = send(run, kVertices);
  ASSERT_TRUE(run.run());
  const std::vector<std::uint64_t>& results = run.bench().result_clocks();
  ASSERT_EQ(results.size(), kVertices);
  const std::uint64_t start = run.bench().accept_clocks().at(first);
  const auto clocks = static_cast<double>(results.back() - start);
  const auto latency = static_cast<double>(results.front() - start);
  std::printf("%zu vertices, %.0f clocks, latency %.0f\n", kVertices, clocks, latency);
  EXPECT_LE(latency, 200 + expected_interval(GetParam()));
  EXPECT_LE(clocks, 1.01 * expected_interval(GetParam()) * kVertices + latency);
}

// The scoreboard compares every bit and every tag in order; nothing may be missing or left over.
TEST_P(Sustained, NothingIsLostUnderBackpressure) {
  constexpr std::size_t kVertices = 10000;
  std::uint64_t checked = 0;
  for (const char* sink : {"bernoulli", "bursts", "long_stall"}) {
    for (const char* source : {"always", "gaps", "bursts"}) {
      SystemRun run(GetParam(), 1, source, sink);
      send(run, kVertices);
      ASSERT_TRUE(run.run()) << source << ", " << sink;
      checked += run.bench().scoreboard().checked();
    }
  }
  EXPECT_EQ(checked, 9 * kVertices);
}

INSTANTIATE_TEST_SUITE_P(, Sustained, ::testing::ValuesIn(fast_configurations()), by_name);

}  // namespace
}  // namespace hwffd::test
