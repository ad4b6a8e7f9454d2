// Vertices of a lattice that is kept on chip: the bits of the interleaved stream at the rate of the
// organization, lattices changed between vertices and loaded while the old one is read.
#include <gtest/gtest.h>

#include <algorithm>

#include "hwffd/lattice/box.hpp"
#include "hwffd/lattice/deformation.hpp"
#include "hwffd/mesh/mesh.hpp"
#include "hwffd/model/schedule.hpp"
#include "hwffd/stream/interleave.hpp"
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
  run.send(vertices_packet(random_vertices(run.codec(), random, lattice.dims, 41 + 120)));
  ASSERT_TRUE(run.run());
  EXPECT_EQ(run.bench().clocks_per_result(40, 160), expected_interval(GetParam()));
}

TEST_P(Resident, LatticeChangesBetweenVertices) {
  for (std::uint64_t seed = 1; seed <= share_of(4); ++seed) {
    SystemRun run(GetParam(), seed, "bernoulli", "bursts");
    tb::Random random(seed);
    run.send_bspline();
    for (int load = 0; load < 6; ++load) {
      const LatticeWords lattice = random_lattice(run.codec(), random, 6);
      run.send(lattice_packet(lattice));
      run.send(vertices_packet(
          random_vertices(run.codec(), random, lattice.dims, random.between(1, 5))));
      if (random.chance(0.3))
        run.send(coefficients_packet(random_coefficients(run.codec(), random)));
    }
    ASSERT_TRUE(run.run());
  }
}

// Every place of both buffers: a lattice of 16 points an axis whose points all differ, read at its
// corners and along its diagonal.
TEST_P(Resident, TheLargestLattice) {
  SystemRun run(GetParam(), 1);
  tb::Random random(3);
  run.send_bspline();
  for (int buffer = 0; buffer < 2; ++buffer) {
    LatticeWords lattice;
    lattice.dims = {16, 16, 16};
    for (int p = 0; p < 4096; ++p) {
      lattice.points.push_back({run.codec().point(2 * random.unit() - 1),
                                run.codec().point(2 * random.unit() - 1),
                                run.codec().point(2 * random.unit() - 1)});
    }
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

HWFFD_FOR_EACH_CONFIGURATION(Resident);

}  // namespace
}  // namespace hwffd::test
