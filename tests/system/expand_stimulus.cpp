#include "expand_stimulus.hpp"

#include <algorithm>

namespace hwffd::test {
namespace {

/// A place along an axis of so many cells.
double random_place(tb::Random& random, int cells) {
  if (random.chance(0.2)) return cells;
  if (random.chance(0.2)) return static_cast<double>(random.below(cells));
  return random.unit() * cells;
}

}  // namespace

Grid random_grid(tb::Random& random, const std::array<int, 3>& dims, int most) {
  std::array<double, 3> first, last;
  std::array<int, 3> count;
  for (int axis = 0; axis < 3; ++axis) {
    first[axis] = random_place(random, dims[axis] - 3);
    last[axis] = random_place(random, dims[axis] - 3);
    count[axis] = static_cast<int>(random.between(1, most));
  }
  Grid grid = grid_between(first, last, count, static_cast<std::uint16_t>(random.word()));
  if (random.chance(0.5)) return grid;
  // At the lower or the upper end of a coordinate's unit, so that a step that is off by its last
  // bit shows.
  constexpr std::int64_t kUnit = std::int64_t{1} << (kGridFraction - kGridCoordinate);
  for (int axis = 0; axis < 3; ++axis) {
    grid.start[axis] -= grid.start[axis] % kUnit;
    grid.start[axis] += random.chance(0.5) ? kUnit - 1 : 0;
    grid.step[axis] -= grid.step[axis] % kUnit;
  }
  return grid;
}

std::vector<PackedVertex> random_packed(tb::Random& random, const std::array<int, 3>& dims,
                                        std::size_t count, bool stray) {
  std::vector<PackedVertex> vertices(count);
  for (PackedVertex& vertex : vertices) {
    for (int axis = 0; axis < 3; ++axis) {
      const int cells = stray && random.chance(0.1) ? 16 : std::min(dims[axis] - 3, 16);
      vertex.cell[axis] = static_cast<int>(random.below(cells));
      vertex.local[axis] = static_cast<std::uint32_t>(random.below(kPackedOne + 1));
      if (random.chance(0.1)) vertex.local[axis] = random.pick({0U, 1U, kPackedOne});
      if (!stray || !random.chance(0.15)) continue;
      vertex.local[axis] = random.pick({kPackedOne + 1, 0x17FFFU, 0x18000U, kPackedMost});
    }
  }
  return vertices;
}

}  // namespace hwffd::test
