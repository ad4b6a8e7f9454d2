#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "hwffd/lattice/embedder.hpp"

namespace hwffd::test {

/// Kinds of lattices that are tried.
const std::vector<std::string>& lattice_kinds();

/// A lattice of this kind around points (n x 3): box, cylinder or sphere as their `around` makes
/// them; custom, a box 1.6 times as large as the bounding box, twisted by 60 degrees and jittered,
/// by way of the text of a lattice file.
/// @throws Error for another kind, or points without a bounding box
Lattice sample_lattice(const std::string& kind, const Points& points);

/// The eight corners of a box of three different edges, away from the origin.
Points corners();

/// Places in a lattice. Half of them are anywhere; in the other half coordinates are also 0, 1, 1/2
/// and a hair inside, cells also the outermost, so that faces, edges, corners, poles and axes
/// are among them.
std::vector<Embedded> known_places(const Lattice& lattice, std::size_t count, std::uint64_t seed);

/// Eq. (1) at these places, n x 3: points that are inside by construction.
Points points_at(const Embedder& embedder, const std::vector<Embedded>& places);

}  // namespace hwffd::test
