#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "hwffd/stream/beat.hpp"
#include "hwffd/stream/status.hpp"

namespace hwffd {

/// Packet opcodes, in the low byte of a header's word 0. docs/interface.md section 2.
enum class Opcode : std::uint8_t {
  kCoefficients = 1,
  kLattice = 2,
  kVertices = 3,
  kInterleaved = 4,
  kSpans = 9  ///< hwffd/stream/spans.hpp
};

/// What becomes of a vertex outside the lattice, in a header of vertices. All modes flag it.
enum class OutsideMode : std::uint8_t {
  kClamp = 0,  ///< onto the nearest face
  kPass = 1,   ///< evaluated as it is
  kBlank = 2   ///< no result
};

/// What comes back for a vertex, in a header of vertices.
enum class Results : std::uint8_t {
  kPosition = 0,     ///< q
  kDerivatives = 1,  ///< q, dq/ds, dq/dt, dq/du: four results
  kDeterminant = 2   ///< q, then det J as word x with kStatusFolded: two results
};

/// How many results a vertex has.
constexpr int results_of(Results results) {
  return results == Results::kPosition ? 1 : results == Results::kDerivatives ? 4 : 2;
}

/// Whether a packet of coefficients brings the derivatives of the functions, too.
enum class Functions { kBlending, kDerivativesToo };

constexpr int kCoefficientBeats = 12;                   ///< three axes, four functions
constexpr std::uint32_t kDerivativesFollow = 1U << 31;  ///< in word 2 of a header of coefficients
constexpr std::uint32_t kEndsSet = 1U << 16;  ///< in word 0 of a header of spans
constexpr int kPointBeats = 48;                         ///< 64 points, three words each
constexpr int kVertexBeats = 1 + kPointBeats;
constexpr int kAxisPoints = 16;  ///< of a resident lattice, at most

/// Vertices a packet where many go to the core; tags of 16 bits stay unique within one.
constexpr std::size_t kPacketVertices = 1024;

constexpr std::uint32_t kTagMask = 0xFFFF;  ///< of a vertex and of its results, in word 3

/// The derivatives of an axis's blending functions as stream words: `word[function][power]`.
struct DerivativeWords {
  std::array<std::array<std::uint32_t, 4>, 4> word{};
  int shift = 0;     ///< 0 to 3; coefficients are stored times 2^-shift (fixed point)
  int exponent = 0;  ///< results are dq times 2^-exponent (fixed point); the core does not know it
};

/// The blending functions of one axis as stream words: `word[function][power]`.
struct AxisWords {
  std::array<std::array<std::uint32_t, 4>, 4> word{};
  int degree = 3;  ///< 0 to 3; coefficients of higher powers are taken as 0
  int shift = 0;   ///< 0 to 3; coefficients are stored times 2^-shift (fixed point)
  DerivativeWords derivative;
};

/// A vertex as stream words.
struct VertexBeat {
  std::array<std::uint32_t, 3> local{};  ///< s, t, u
  std::array<int, 3> cell{};             ///< i, j, k, 0 to 15 each
  std::uint16_t tag = 0;                 ///< comes back with the result
};

/// A vertex with its control points as stream words.
struct InterleavedVertex : VertexBeat {
  std::array<std::uint32_t, 192> points{};  ///< 64 x 3, local order (l, m, n), n fastest
  int exponent = 0;                         ///< of the points; only bfp32 looks at it
};

/// A lattice as stream words: points[(i * dims[1] + j) * dims[2] + k].
struct LatticeWords {
  std::array<int, 3> dims{};  ///< points an axis, 4 to kAxisPoints
  std::vector<std::array<std::uint32_t, 3>> points;
  int exponent = 0;  ///< of all points, -512 to 511; only bfp32 looks at it
};

/// The packet that loads a bank of coefficients: 13 beats, or 25. Axes s, t, u.
std::vector<Beat> coefficients_packet(const std::array<AxisWords, 3>& axes,
                                      Functions functions = Functions::kBlending);

/// The packet that makes a lattice resident: a beat a point after the header.
std::vector<Beat> lattice_packet(const LatticeWords& lattice);

/// The packet of vertices of the resident lattice: 1 + n beats, in the order given.
std::vector<Beat> vertices_packet(const std::vector<VertexBeat>& vertices,
                                  OutsideMode mode = OutsideMode::kClamp,
                                  Results results = Results::kPosition);

/// The packet of interleaved vertices: 1 + 49 n beats, in the order given.
/// @throws std::invalid_argument unless all have the same exponent, which is the packet's
std::vector<Beat> interleaved_packet(const std::vector<InterleavedVertex>& vertices,
                                     OutsideMode mode = OutsideMode::kClamp,
                                     Results results = Results::kPosition);

/// All vertices, in packets of at most kPacketVertices.
std::vector<Beat> vertices_packets(const std::vector<VertexBeat>& vertices,
                                   Results results = Results::kPosition);
std::vector<Beat> interleaved_packets(const std::vector<InterleavedVertex>& vertices);

void append(std::vector<Beat>& beats, const std::vector<Beat>& more);

}  // namespace hwffd
