#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "hwffd/stream/packets.hpp"
#include "hwffd/stream/word_codec.hpp"

namespace hwffd {

/// Bits behind the point of a grid's start and step, and of the coordinate that they give.
constexpr int kGridFraction = 40;
constexpr int kGridCoordinate = 24;
/// log2 of more vertices than any grid has.
constexpr int kGridLimit = 48;

/// A regular grid of vertices of a lattice, in the words of its packet. Along an axis vertex n is
/// at start + n * step cells, a sum without any rounding; the coordinate is cut to its first
/// `kGridCoordinate` bits. docs/interface.md section 2.
struct Grid {
  std::array<std::uint64_t, 3> start{};  ///< s, t, u, in cells times 2^40
  std::array<std::int64_t, 3> step{};    ///< the same, of either sign
  std::array<std::uint16_t, 3> count{};  ///< vertices an axis, 1 to 65,535
  std::uint16_t tag = 0;                 ///< of the first vertex; the others count on
};

/// The grid of so many vertices an axis from one place to another, in cells from the lattice's
/// first face on, both included. Coordinates are those nearest to what the grid asks for, off by
/// less than 2^-24 of a cell.
/// @throws std::invalid_argument for a count that is none, or a place that is none of any lattice
Grid grid_between(const std::array<double, 3>& first, const std::array<double, 3>& last,
                  const std::array<int, 3>& count, std::uint16_t tag = 0);

/// Whether a grid has vertices and all of them are in a lattice of so many points an axis.
/// @param most_cells  a cell from this one on cannot be named
bool grid_fits(const Grid& grid, const std::array<int, 3>& dims, int most_cells = kLargeAxisPoints);

/// How many vertices a grid has.
inline std::size_t vertex_count(const Grid& grid) {
  return std::size_t{grid.count[0]} * grid.count[1] * grid.count[2];
}

/// Calls visit({a, b, c}) for each vertex in the order of its results: s fastest, then t, then u.
template <class Visit>
void for_each_vertex(const Grid& grid, const Visit& visit) {
  for (std::uint32_t c = 0; c < grid.count[2]; ++c) {
    for (std::uint32_t b = 0; b < grid.count[1]; ++b) {
      for (std::uint32_t a = 0; a < grid.count[0]; ++a)
        visit(std::array<std::uint32_t, 3>{a, b, c});
    }
  }
}

/// Where a vertex of a grid is: its cell, and local coordinates of `kGridCoordinate` bits.
struct GridPlace {
  std::array<int, 3> cell{};
  std::array<double, 3> local{};  ///< 1 on the last face only
};

/// The place of vertex (a, b, c) of a grid that fits.
GridPlace grid_place(const Grid& grid, const std::array<int, 3>& dims,
                     const std::array<std::uint32_t, 3>& at);

/// Where a vertex of a grid is along one axis: its cell, and its coordinate as a word.
struct AxisPlace {
  int cell = 0;
  std::uint32_t local = 0;
};

/// The places of a grid that fits along s, t and u. Vertex (a, b, c) is at place a of s, b of t and
/// c of u.
std::array<std::vector<AxisPlace>, 3> axis_places(const Grid& grid, const std::array<int, 3>& dims,
                                                  const WordCodec& codec);

/// Vertex (a, b, c) of a grid that fits: what a driver would send in its place.
VertexBeat grid_vertex(const Grid& grid, const std::array<int, 3>& dims, const WordCodec& codec,
                       const std::array<std::uint32_t, 3>& at);

/// All vertices of a grid in the order of its results: s fastest, then t, then u.
/// @throws std::invalid_argument unless it fits
std::vector<VertexBeat> grid_vertices(const Grid& grid, const std::array<int, 3>& dims,
                                      const WordCodec& codec);

/// Of a core with grids: the packet that evaluates one, four beats. Of a core without pages the
/// page is 0, and the grid is of the resident lattice.
/// @throws std::invalid_argument for a mode or a flag that grids have not, or a page beyond 255
std::vector<Beat> grid_packet(const Grid& grid, int page = 0, const PageVertices& how = {});

/// The grid that a packet brings, from its four beats.
Grid grid_of(const std::array<Beat, 4>& beats);

}  // namespace hwffd
