#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "hwffd/stream/beat.hpp"
#include "hwffd/stream/opcodes.hpp"
#include "hwffd/stream/status.hpp"

namespace hwffd {

/// Flags of opcodes 5 to 8, bits of a header's word 0. docs/interface.md section 2.
constexpr std::uint32_t kEveryFlag = 1U << 16;   ///< vertices come until tlast
constexpr std::uint32_t kFourthFlag = 1U << 17;  ///< points have a fourth component
constexpr std::uint32_t kPackedFlag = 1U << 18;  ///< hwffd/stream/packed.hpp; of opcode 3, too
constexpr std::uint32_t kLargeFlag = 1U << 19;   ///< more than 32 points an axis, tags of 14 bits
constexpr std::uint32_t kCountFlag = 1U << 20;   ///< results end with a unit that counts them
constexpr std::uint32_t kInterruptFlag = 1U << 21;  ///< an interrupt when the results are in memory
constexpr std::uint32_t kHalfFlag = 1U << 22;       ///< hwffd/stream/halves.hpp

/// What becomes of a vertex outside the lattice, in a header of vertices. All modes flag it.
enum class OutsideMode : std::uint8_t {
  kClamp = 0,  ///< onto the nearest face
  kPass = 1,   ///< evaluated as it is
  kBlank = 2   ///< no result
};

/// What comes back for a vertex, in a header of vertices.
enum class Results : std::uint8_t {
  kPosition = 0,         ///< q
  kDerivatives = 1,      ///< q, dq/ds, dq/dt, dq/du: four results
  kDeterminant = 2,      ///< q, then det J as word x with kStatusFolded: two results
  kDeterminantAlone = 3  ///< det J without q
};

/// Whether det J is among them.
constexpr bool has_determinant(Results results) {
  return results == Results::kDeterminant || results == Results::kDeterminantAlone;
}

/// Whether two vertices of them fit a beat (`kHalfFlag`): positions, with the sign of det J or not.
constexpr bool can_be_halved(Results results) {
  return results == Results::kPosition || results == Results::kDeterminant;
}

/// How many results a vertex has.
constexpr int results_of(Results results) {
  constexpr int kResults[] = {1, 4, 2, 1};
  return kResults[static_cast<int>(results)];
}

/// Whether a packet of coefficients brings the derivatives of the functions, too.
enum class Functions { kBlending, kDerivativesToo };

constexpr int kCoefficientBeats = 12;                   ///< three axes, four functions
constexpr std::uint32_t kDerivativesFollow = 1U << 31;  ///< in word 2 of a header of coefficients
constexpr std::uint32_t kEndsSet = 1U << 16;            ///< in word 0 of a header of spans
constexpr int kPointBeats = 48;                         ///< 64 points, three words each
constexpr int kVertexBeats = 1 + kPointBeats;
constexpr int kAxisPoints = 16;       ///< of a resident lattice, at most, in a core as it comes
constexpr int kSmallAxisPoints = 32;  ///< at most without `kLargeFlag`
constexpr int kLargeAxisPoints = 64;  ///< at most with it
/// Cells along an axis, from 0 on, that the beat of a vertex can name in a core that keeps so many
/// points an axis.
constexpr int nameable_cells(int axis_points) {
  return axis_points > kSmallAxisPoints ? kLargeAxisPoints
         : axis_points > kAxisPoints    ? kSmallAxisPoints
                                        : kAxisPoints;
}
constexpr int kPages = 2;  ///< of the point store, in a core as it comes

/// Vertices a packet where many go to the core; tags of 16 bits stay unique within one.
constexpr std::size_t kPacketVertices = 1024;

constexpr std::uint32_t kTagMask = 0xFFFF;       ///< of a vertex and of its results, in word 3
constexpr std::uint32_t kLargeTagMask = 0x3FFF;  ///< with `kLargeFlag`

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
  std::array<int, 3> cell{};             ///< i, j, k, 0 to 15 each, in larger lattices to 31 or 63
  std::uint16_t tag = 0;                 ///< comes back with the result
};

/// A vertex with its control points as stream words.
struct InterleavedVertex : VertexBeat {
  std::array<std::uint32_t, 192> points{};  ///< 64 x 3, local order (l, m, n), n fastest
  int exponent = 0;                         ///< of the points; only bfp32 looks at it
};

/// A lattice as stream words: points[(i * dims[1] + j) * dims[2] + k].
struct LatticeWords {
  std::array<int, 3> dims{};  ///< points an axis, 4 to what the core takes
  std::vector<std::array<std::uint32_t, 3>> points;
  int exponent = 0;                     ///< of all points, -512 to 511; only bfp32 looks at it
  std::vector<std::uint32_t> fourth{};  ///< a fourth component for each point, or none at all
};

/// Whether vertices of a lattice need `kLargeFlag`.
inline bool is_large(const LatticeWords& lattice) {
  return lattice.dims[0] > kSmallAxisPoints || lattice.dims[1] > kSmallAxisPoints ||
         lattice.dims[2] > kSmallAxisPoints;
}

/// The packet that loads a bank of coefficients: 13 beats, or 25. Axes s, t, u.
std::vector<Beat> coefficients_packet(const std::array<AxisWords, 3>& axes,
                                      Functions functions = Functions::kBlending);

/// The packet that makes a lattice resident: a beat a point after the header. Its fourth component
/// does not go with it.
std::vector<Beat> lattice_packet(const LatticeWords& lattice);

/// Of a core with pages: the packet that makes a lattice resident in a page, with its fourth
/// component if it has one, and with `kLargeFlag` if it has more than 32 points along an axis.
/// @param origin  the cell of the whole lattice at which the page begins, which chooses spans
/// @throws std::invalid_argument unless the page is 0 to 255, the origin 0 to 127 along each axis,
///   and there is a fourth component for each point or for none
std::vector<Beat> page_packet(int page, const LatticeWords& lattice,
                              const std::array<int, 3>& origin = {});

/// Of a core with pages: the packet that changes `count` points of a page, from number `first` of
/// the lattice on, to those of `lattice`, which has all points of the page.
/// @throws std::invalid_argument as above, and if those points are not all of the lattice
std::vector<Beat> points_packet(int page, const LatticeWords& lattice, std::size_t first,
                                std::size_t count);

/// How vertices of a page are evaluated and counted.
struct PageVertices {
  OutsideMode mode = OutsideMode::kClamp;
  Results results = Results::kPosition;
  bool fourth = false;     ///< each result is followed by one of the fourth component
  bool large = false;      ///< six bits of cell an axis, tags of 14 bits
  bool every = false;      ///< no count: vertices come until tlast
  bool count = false;      ///< a unit behind the results says how many they are
  bool interrupt = false;  ///< one comes when the last result is in memory
  bool half = false;       ///< a result beat is two vertices (hwffd/stream/halves.hpp)
};

/// Of a core with pages: the packet of vertices of one of them, 1 + n beats, in the order given.
/// @throws std::invalid_argument unless the page is 0 to 255
std::vector<Beat> page_vertices_packet(int page, const std::vector<VertexBeat>& vertices,
                                       const PageVertices& how = {});

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

/// The vertex in a beat, as a core reads it that keeps lattices of so many points an axis.
/// @param large  with `kLargeFlag`; the tag then has two bits that do not come back
VertexBeat vertex_of(const Beat& beat, int axis_points, bool large);

/// Ends the results of a packet with these flags, of which there are so many: with kCountFlag a
/// unit says so, and with kInterruptFlag the last beat asks for an interrupt.
void end_results(std::vector<Beat>& results, std::uint32_t count, std::uint32_t flags);

void append(std::vector<Beat>& beats, const std::vector<Beat>& more);

}  // namespace hwffd
