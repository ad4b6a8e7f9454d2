#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <vector>

#include "hwffd/lattice/lattice.hpp"
#include "hwffd/stream/grid.hpp"

namespace hwffd::compare {

/// What all programs and cores evaluate: vertices in a lattice with uniform B-splines.
struct Scene {
  Lattice lattice;
  std::vector<Embedded> vertices;
  Points exact;  ///< their positions by the oracle, n x 3
};

/// A lattice of 16 x 16 x 16 random points that reach from one end of (-1, 1) to the other, and
/// vertices at random. Points and local coordinates are multiples of 2^-16, which every number
/// format holds: an error is one of the evaluation, not of its input.
Scene random_scene(std::size_t vertices, std::uint64_t seed);

/// The same vertices, sorted by cell, those of a cell in their order.
Scene sorted_by_cell(const Scene& scene);

/// The first of its vertices.
Scene first_of(const Scene& scene, std::size_t vertices);

/// The vertices of a regular grid.
struct GridScene {
  Scene scene;
  Grid grid;
};

/// A grid over all cells of that lattice, of as many vertices along each axis as give about so
/// many, at multiples of 2^-16.
GridScene grid_scene(const Lattice& lattice, std::size_t vertices);

/// The largest difference of a component from the oracle's.
double largest_error(const Scene& scene, const Points& positions);

/// Writes a scene for other programs, as arrays of the machine's own numbers: points.f64,
/// cells.i32, local.f64 and exact.f64, three a point or vertex.
void write_scene(const Scene& scene, const std::filesystem::path& folder);

}  // namespace hwffd::compare
