#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "hwffd/stream/packets.hpp"

namespace hwffd {

/// A part of a lattice that is larger than the core keeps.
struct LatticePage {
  std::array<int, 3> origin{};  ///< its first cell, a multiple of 4 along each axis
  LatticeWords lattice;
};

/// Vertices of a large lattice, each with the cell of its page.
struct PagedVertices {
  std::vector<std::vector<VertexBeat>> of_page;  ///< in the order of `pages_of`
  std::vector<std::size_t> sent;                 ///< the pages that have any, as they are sent
  std::vector<std::size_t> from;                 ///< of all in that order, which each was
};

/// Cuts a lattice of any size into pages of at most `axis_points` along each axis, s slowest.
///
/// Neighbouring pages share three layers of points, so that every cell lies whole in one of them.
/// All have the exponent of the lattice. As they begin at multiples of four, a point lies in the
/// same bank as it would in one lattice, so results are the same to the bit. A lattice that fits is
/// one page.
/// @param axis_points  7 or more where the lattice does not fit, since four cells are seven points
/// @throws UsageError for less, and for a lattice with fewer than 4 points along an axis
std::vector<LatticePage> pages_of(const LatticeWords& lattice, int axis_points = kAxisPoints);

/// Sorts vertices by the page that has their cell; those of one page keep their order. A cell
/// beyond the lattice's last goes to the last page, as one that is beyond its last.
/// @param vertices  `cell` counts from the lattice's first cell, whatever its size
/// @param dims      the lattice's points an axis
PagedVertices by_page(const std::vector<VertexBeat>& vertices, const std::array<int, 3>& dims,
                      int axis_points = kAxisPoints);

/// Packets that any core with resident lattices takes: each page that has vertices is loaded, then
/// they follow, at most `kPacketVertices` in a packet. While one page is read the next one is
/// loaded into the other buffer.
std::vector<Beat> page_packets(const std::vector<LatticePage>& pages, const PagedVertices& vertices,
                               OutsideMode mode = OutsideMode::kClamp,
                               Results results = Results::kPosition);

/// Those of a page as they go into packets, at most `kPacketVertices` in each.
std::vector<std::vector<VertexBeat>> in_packets(const std::vector<VertexBeat>& vertices);

/// Results of these packets in the order of the vertices before they were sorted; `last` is set on
/// the last one only.
/// @throws std::invalid_argument unless there are as many as were asked for
std::vector<Beat> in_order(const std::vector<Beat>& sorted, const PagedVertices& vertices,
                           Results results = Results::kPosition);

}  // namespace hwffd
