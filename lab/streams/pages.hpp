#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "study.hpp"

namespace hwffd::streams {

/// What a lattice moves that is larger than the core keeps, cut into pages of 16 points an axis.
struct PagesRow {
  std::string mesh;
  std::size_t vertices = 0;
  int points = 0;         ///< of the lattice, an axis
  int pages = 0;          ///< that the core keeps, opcodes 5 and 7; 0: two buffers, opcodes 2, 3
  std::size_t batch = 0;  ///< vertices that are sorted by page together, in the file's order
  std::uint64_t predicted = 0;   ///< beats
  std::uint64_t counted = 0;     ///< beats of the packets
  std::uint64_t mismatches = 0;  ///< results that differ from those of the lattice as one page

  double words_per_vertex() const {
    return 4.0 * static_cast<double>(predicted) / static_cast<double>(vertices);
  }
};

/// Each mesh in a twisted box lattice of each number of points an axis, for cores with none and
/// with several pages, all vertices at once and in batches. The model evaluates them.
std::vector<PagesRow> pages_study(const std::vector<NamedMesh>& meshes,
                                  const std::vector<int>& lattices,
                                  const Configuration& configuration);

}  // namespace hwffd::streams
