#include "hwffd/stream/grid.hpp"

#include <cmath>
#include <stdexcept>

namespace hwffd {
namespace {

__extension__ using Wide = __int128;

constexpr Wide kCell = Wide{1} << kGridFraction;
constexpr Wide kUnit = kCell >> kGridCoordinate;  // of a coordinate
constexpr double kMostCells = 1 << 23;

/// Where vertex n is, cut to a multiple of a coordinate's unit.
Wide place(const Grid& grid, int axis, std::uint32_t n) {
  const Wide at = Wide{grid.start[axis]} + Wide{grid.step[axis]} * n;
  return (at >= 0 ? at : at - (kUnit - 1)) / kUnit * kUnit;
}

std::uint64_t word_pair(const Beat& beat, int low) {
  return beat.words[low] | std::uint64_t{beat.words[low + 1]} << 32;
}

}  // namespace

Grid grid_between(const std::array<double, 3>& first, const std::array<double, 3>& last,
                  const std::array<int, 3>& count, std::uint16_t tag) {
  Grid grid;
  grid.tag = tag;
  for (int axis = 0; axis < 3; ++axis) {
    if (count[axis] < 1 || count[axis] > 0xFFFF) {
      throw std::invalid_argument("a grid has 1 to 65535 vertices an axis");
    }
    for (const double end : {first[axis], last[axis]}) {
      if (!(end >= 0 && end < kMostCells)) throw std::invalid_argument("a place in no lattice");
    }
    const int steps = count[axis] - 1;
    grid.count[axis] = static_cast<std::uint16_t>(count[axis]);
    // Half a unit more makes what is cut off rounded to nearest.
    grid.start[axis] =
        static_cast<std::uint64_t>(std::llround(std::ldexp(first[axis], kGridFraction)) +
                                   static_cast<std::int64_t>(kUnit / 2));
    grid.step[axis] =
        steps == 0 ? 0 : std::llround(std::ldexp(last[axis] - first[axis], kGridFraction) / steps);
  }
  return grid;
}

bool grid_fits(const Grid& grid, const std::array<int, 3>& dims, int most_cells) {
  for (int axis = 0; axis < 3; ++axis) {
    if (grid.count[axis] == 0) return false;
    const int cells = dims[axis] - 3;
    for (const std::uint32_t n : {0U, grid.count[axis] - 1U}) {
      const Wide at = place(grid, axis, n);
      if (at < 0 || at > cells * kCell) return false;
      // The last face is in the last cell.
      if (at >= most_cells * kCell && (at > most_cells * kCell || cells > most_cells)) return false;
    }
  }
  return true;
}

GridPlace grid_place(const Grid& grid, const std::array<int, 3>& dims,
                     const std::array<std::uint32_t, 3>& at) {
  GridPlace result;
  for (int axis = 0; axis < 3; ++axis) {
    const Wide where = place(grid, axis, at[axis]);
    const int last = dims[axis] - 4;
    const int whole = static_cast<int>(where / kCell);
    result.cell[axis] = whole > last ? last : whole;
    const Wide units = (where - result.cell[axis] * kCell) / kUnit;
    result.local[axis] = std::ldexp(static_cast<double>(units), -kGridCoordinate);
  }
  return result;
}

VertexBeat grid_vertex(const Grid& grid, const std::array<int, 3>& dims, const WordCodec& codec,
                       const std::array<std::uint32_t, 3>& at) {
  const GridPlace grid_point = grid_place(grid, dims, at);
  VertexBeat vertex;
  for (int axis = 0; axis < 3; ++axis) {
    vertex.cell[axis] = grid_point.cell[axis];
    vertex.local[axis] = codec.coordinate(grid_point.local[axis]);
  }
  const std::uint32_t row = at[2] * grid.count[1] + at[1];
  vertex.tag = static_cast<std::uint16_t>(grid.tag + row * grid.count[0] + at[0]);
  return vertex;
}

std::array<std::vector<AxisPlace>, 3> axis_places(const Grid& grid, const std::array<int, 3>& dims,
                                                  const WordCodec& codec) {
  std::array<std::vector<AxisPlace>, 3> places;
  for (int axis = 0; axis < 3; ++axis) {
    places[axis].reserve(grid.count[axis]);
    for (std::uint32_t n = 0; n < grid.count[axis]; ++n) {
      std::array<std::uint32_t, 3> at{};
      at[axis] = n;
      const VertexBeat vertex = grid_vertex(grid, dims, codec, at);
      places[axis].push_back({vertex.cell[axis], vertex.local[axis]});
    }
  }
  return places;
}

std::vector<VertexBeat> grid_vertices(const Grid& grid, const std::array<int, 3>& dims,
                                      const WordCodec& codec) {
  if (!grid_fits(grid, dims)) throw std::invalid_argument("a grid that leaves its lattice");
  std::vector<VertexBeat> vertices;
  for_each_vertex(grid, [&](const std::array<std::uint32_t, 3>& at) {
    vertices.push_back(grid_vertex(grid, dims, codec, at));
  });
  return vertices;
}

std::vector<Beat> grid_packet(const Grid& grid, int page, const PageVertices& how) {
  if (how.every || how.mode != OutsideMode::kClamp) {
    throw std::invalid_argument("a grid has no mode and no E");
  }
  std::vector<Beat> beats = {page_vertices_packet(page, {}, how)[0]};
  beats[0].last = false;
  beats[0].words[0] = (beats[0].words[0] & ~0xFFU) | static_cast<std::uint32_t>(Opcode::kGrid);
  beats[0].words[1] = grid.count[0] | static_cast<std::uint32_t>(grid.count[1]) << 16;
  beats[0].words[3] = grid.count[2] | static_cast<std::uint32_t>(grid.tag) << 16;
  for (int axis = 0; axis < 3; ++axis) {
    const std::uint64_t start = grid.start[axis];
    const auto step = static_cast<std::uint64_t>(grid.step[axis]);
    beats.push_back({{static_cast<std::uint32_t>(start), static_cast<std::uint32_t>(start >> 32),
                      static_cast<std::uint32_t>(step), static_cast<std::uint32_t>(step >> 32)},
                     axis == 2});
  }
  return beats;
}

Grid grid_of(const std::array<Beat, 4>& beats) {
  Grid grid;
  const auto& header = beats[0].words;
  grid.count = {static_cast<std::uint16_t>(header[1]), static_cast<std::uint16_t>(header[1] >> 16),
                static_cast<std::uint16_t>(header[3])};
  grid.tag = static_cast<std::uint16_t>(header[3] >> 16);
  for (int axis = 0; axis < 3; ++axis) {
    grid.start[axis] = word_pair(beats[1 + axis], 0);
    grid.step[axis] = static_cast<std::int64_t>(word_pair(beats[1 + axis], 2));
  }
  return grid;
}

}  // namespace hwffd
