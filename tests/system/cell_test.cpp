// Every cell number in lattices of every size: those beyond the last one become the last one.
#include <gtest/gtest.h>

#include "system_run.hpp"

namespace hwffd::test {
namespace {

constexpr int kLeast = 4;  // points an axis
constexpr int kMost = 16;
constexpr int kCells = 16;  // that a beat can name

class Cells : public PerConfiguration {};

// The model clamps a cell in a line of its own; in mode pass the coordinate stays.
TEST_P(Cells, OfOneAxisInLatticesOfEverySize) {
  SystemRun run(GetParam(), 1);
  tb::Random random(1);
  run.send_bspline();
  for (int axis = 0; axis < 3; ++axis) {
    for (int points = kLeast; points <= kMost; ++points) {
      std::array<int, 3> dims = {kLeast, kLeast, kLeast};
      dims[axis] = points;
      std::vector<VertexBeat> vertices = random_vertices(run.codec(), random, dims, kCells);
      for (int cell = 0; cell < kCells; ++cell) vertices[cell].cell[axis] = cell;
      run.send(lattice_packet(random_lattice(run.codec(), random, dims)));
      run.send(vertices_packet(vertices, OutsideMode::kClamp));
      run.send(vertices_packet(vertices, OutsideMode::kPass));
    }
  }
  ASSERT_TRUE(run.run());
  EXPECT_EQ(run.bench().events(), run.events());
}

HWFFD_FOR_EACH_CONFIGURATION(Cells);

}  // namespace
}  // namespace hwffd::test
