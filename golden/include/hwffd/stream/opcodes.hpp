// Made from rtl/stream/fields.csv by tools/tables/generated_files.py; changes here are lost.
#pragma once

#include <cstdint>

namespace hwffd {

/// Packet opcodes, in the low byte of a header's word 0. docs/interface.md section 2.
enum class Opcode : std::uint8_t {
  kCoefficients = 1,  ///< functions of every cell
  kLattice = 2,       ///< a whole lattice
  kVertices = 3,      ///< vertices of the lattice
  kInterleaved = 4,   ///< vertices with points of their own
  kPage = 5,          ///< a lattice for a page
  kPoints = 6,        ///< points of a page
  kPageVertices = 7,  ///< vertices of a page
  kGrid = 8,          ///< vertices of a grid
  kSpans = 9,         ///< functions of spans
  kGradients = 10,    ///< vertices and their gradients
  kCollect = 11       ///< the sums of a page
};

/// The last of them; the first is 1.
constexpr unsigned kOpcodes = 11;

}  // namespace hwffd
