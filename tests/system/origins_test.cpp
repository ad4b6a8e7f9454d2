// Cores with pages and with functions for each span: the origin of a page chooses the spans of its
// cells.
#include <gtest/gtest.h>

#include <algorithm>

#include "hwffd/stream/spans.hpp"
#include "named.hpp"
#include "page_run.hpp"

namespace hwffd::test {
namespace {

class Origins : public ::testing::TestWithParam<PageBuild> {
 protected:
  const PageCore& core() const { return GetParam().core; }
  int last_span() const { return core().spans - 1; }

  /// Functions of their own for a run of spans of one axis, at most `most` long.
  std::vector<Beat> random_set(const WordCodec& codec, tb::Random& random, int most) const {
    const auto first = static_cast<int>(random.below(core().spans));
    return run_of_spans(codec, random, static_cast<int>(random.below(3)), first,
                        std::min(most, core().spans - first));
  }
  static std::vector<Beat> run_of_spans(const WordCodec& codec, tb::Random& random, int axis,
                                        int first, int count) {
    std::vector<AxisWords> spans;
    while (static_cast<int>(spans.size()) < count) {
      spans.push_back(random_coefficients(codec, random)[axis]);
    }
    return spans_packets(axis, first, spans, Functions::kDerivativesToo);
  }
  /// Functions for all axes, other ones in each span.
  void send_functions(PageRun& run, tb::Random& random) const {
    run.send(
        coefficients_packet(random_coefficients(run.codec(), random), Functions::kDerivativesToo));
    for (int axis = 0; axis < 3; ++axis) {
      run.send(run_of_spans(run.codec(), random, axis, 0, core().spans));
    }
  }
};

/// The points of a lattice from a corner on, as a lattice of its own.
LatticeWords part_of(const LatticeWords& whole, const std::array<int, 3>& corner) {
  LatticeWords part;
  part.exponent = whole.exponent;
  for (int axis = 0; axis < 3; ++axis) part.dims[axis] = whole.dims[axis] - corner[axis];
  for (int i = corner[0]; i < whole.dims[0]; ++i) {
    for (int j = corner[1]; j < whole.dims[1]; ++j) {
      for (int k = corner[2]; k < whole.dims[2]; ++k) {
        part.points.push_back(whole.points[(i * whole.dims[1] + j) * whole.dims[2] + k]);
      }
    }
  }
  return part;
}

TEST_P(Origins, AnyPacketsInAnyOrder) {
  constexpr std::uint64_t kRounds = 40;
  for (std::uint64_t seed = tb::seed_from_environment(1), last = seed + 3; seed <= last; ++seed) {
    PageRun run(GetParam(), seed, "bursts", "bernoulli");
    tb::Random random(seed);
    PagePackets packets(run.codec(), random, core());
    send_functions(run, random);
    for (std::uint64_t round = 0; round < kRounds; ++round) {
      run.send(packets.any(5));
      run.send(random_set(run.codec(), random, 3));
    }
    ASSERT_TRUE(run.run());
    EXPECT_GT(run.bench().results().size(), 4 * kRounds);
  }
}

// A page that begins inside a lattice gives the bits of the whole one. Origins are multiples of
// four, so that sums have the same order.
TEST_P(Origins, APageIsAPartOfItsLattice) {
  tb::Random random(2);
  PageRun run(GetParam(), 2);
  send_functions(run, random);
  const std::array<int, 3> origin{8, 4, 0};
  const LatticeWords whole = random_lattice(run.codec(), random, {15, 9, 5});
  const LatticeWords part = part_of(whole, origin);
  std::vector<VertexBeat> there = random_vertices(run.codec(), random, part.dims, 60);
  std::vector<VertexBeat> here = there;
  for (VertexBeat& vertex : here) {
    for (int axis = 0; axis < 3; ++axis) vertex.cell[axis] += origin[axis];
  }
  run.send(page_packet(0, whole));
  run.send(page_packet(1, part, origin));
  run.send(page_vertices_packet(0, here));
  run.send(page_vertices_packet(1, there));
  run.send(page_packet(1, part));
  run.send(page_vertices_packet(1, there));
  ASSERT_TRUE(run.run());
  EXPECT_EQ(run.words(0, 60), run.words(60, 60));
  EXPECT_NE(run.words(0, 60), run.words(120, 60)) << "without its origin";
}

// Cells behind the last span have its functions, and each axis an origin of its own.
TEST_P(Origins, TheLastSpanGoesOn) {
  tb::Random random(3);
  PageRun run(GetParam(), 3);
  send_functions(run, random);
  const LatticeWords lattice = random_lattice(run.codec(), random, {5, 6, 7});
  const auto vertices = random_vertices(run.codec(), random, lattice.dims, 40);
  for (const int origin : {last_span(), 127}) {
    run.send(page_packet(0, lattice, {origin, origin, origin}));
    run.send(page_vertices_packet(0, vertices));
  }
  for (int axis = 0; axis < 3; ++axis) {
    std::array<int, 3> origin{};
    origin[axis] = 4;
    run.send(page_packet(0, lattice, origin));
    run.send(page_vertices_packet(0, vertices));
  }
  ASSERT_TRUE(run.run());
  EXPECT_EQ(run.words(0, 40), run.words(40, 40));
  for (std::size_t a = 0; a < 3; ++a) {
    EXPECT_NE(run.words(80 + 40 * a, 40), run.words(80 + 40 * ((a + 1) % 3), 40)) << a;
  }
}

// Opcode 2 leaves a page without the origin that it had, and interleaved vertices have none.
TEST_P(Origins, PacketsWithoutPagesHaveNone) {
  tb::Random random(4);
  PageRun run(GetParam(), 4);
  send_functions(run, random);
  LatticeWords lattice = random_lattice(run.codec(), random, {4, 4, 4});
  auto vertices = random_vertices(run.codec(), random, lattice.dims, 20);
  std::vector<InterleavedVertex> interleaved(vertices.size());
  for (std::size_t v = 0; v < vertices.size(); ++v) {
    static_cast<VertexBeat&>(interleaved[v]) = vertices[v];
    interleaved[v].exponent = lattice.exponent;
    for (std::size_t p = 0; p < 64; ++p) {
      std::copy_n(lattice.points[p].begin(), 3, &interleaved[v].points[3 * p]);
    }
  }
  PageVertices how;
  how.large = (core().features & model::kLargeFeature) != 0;
  run.send(page_packet(1, lattice, {3, 2, 1}));
  run.send(page_vertices_packet(1, vertices, how));
  run.send(interleaved_packet(interleaved));
  auto packet = lattice_packet(lattice);
  packet[0].words[3] |= 0x7FFFFC00;  // opcode 2 has nothing where opcode 5 has its origin
  run.send(packet);
  run.send(vertices_packet(vertices));
  run.send(page_vertices_packet(1, vertices, how));
  ASSERT_TRUE(run.run());
  EXPECT_NE(run.words(0, 20), run.words(20, 20));
  EXPECT_EQ(run.words(20, 20), run.words(40, 20));
  EXPECT_EQ(run.words(20, 20), run.words(60, 20));
}

INSTANTIATE_TEST_SUITE_P(, Origins, ::testing::ValuesIn(page_builds()), by_name);

}  // namespace
}  // namespace hwffd::test
