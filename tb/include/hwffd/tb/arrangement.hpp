#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "hwffd/lattice/lattice.hpp"
#include "hwffd/stream/packets.hpp"

namespace hwffd::tb {

/// How control points get to the evaluator (the question that section 3.3.2 of the paper leaves
/// open).
struct Arrangement {
  enum class Kind {
    kInterleaved,  ///< every vertex with its 64 points (fig. 3)
    kChanged,      ///< every vertex with those of its points that the vertex before did not have
    kCells,        ///< vertices, and the 64 points of a cell that is not among the last few used
    kResident,     ///< the lattice once, then vertices
    kPacked        ///< the same with packed vertices, two a beat (flag P)
  };
  Kind kind;
  std::size_t cells = 0;  ///< kCells: how many are kept; the one unused for longest makes room
  std::vector<std::string> orders;  ///< of the vertices, as far as they make a difference

  std::string name() const;
  /// Whether a core without options takes it. kCells with one cell is a lattice of 4 x 4 x 4
  /// points, reloaded; kPacked is for cores with packed vertices.
  bool is_built() const;
};

/// All that are compared.
std::vector<Arrangement> arrangements();

/// The arrangement of that name among them.
/// @throws std::invalid_argument if there is none
Arrangement find_arrangement(const std::string& name);

/// Beats that an arrangement needs for vertices of these cells in this order, packet headers and
/// the packet of coefficients included: known before anything runs. Points are a beat each where
/// they are loaded, three words each where they come with a vertex; the points that changed are
/// named by a mask of 64 bits.
std::uint64_t predicted_beats(const Arrangement& arrangement, const Index3& dims,
                              const std::vector<Index3>& cells);

/// The packets themselves.
/// @throws std::invalid_argument for an arrangement that is not built
std::vector<Beat> packets(const Arrangement& arrangement, const Lattice& lattice,
                          const std::vector<Embedded>& vertices, const std::string& format);

}  // namespace hwffd::tb
