#include "hwffd/stream/packets.hpp"

#include <algorithm>
#include <stdexcept>

namespace hwffd {
namespace {

/// A header's word 3: ten bits, two's complement.
std::uint32_t exponent_word(int exponent) { return static_cast<std::uint32_t>(exponent) & 0x3FF; }

Beat vertices_header(Opcode opcode, std::size_t count, OutsideMode mode, Results results) {
  return {{static_cast<std::uint32_t>(opcode), static_cast<std::uint32_t>(count),
           static_cast<std::uint32_t>(mode) | static_cast<std::uint32_t>(results) << 8, 0},
          false};
}

Beat beat_of(const VertexBeat& vertex) {
  std::uint32_t word = vertex.tag;
  for (int axis = 0; axis < 3; ++axis) {
    const auto cell = static_cast<std::uint32_t>(vertex.cell[axis]);
    word |= (cell & 15) << (16 + 4 * axis) | (cell >> 4 & 1) << (28 + axis);
  }
  return {{vertex.local[0], vertex.local[1], vertex.local[2], word}, false};
}

/// The same with kLargeFlag.
Beat large_beat_of(const VertexBeat& vertex) {
  std::uint32_t word = vertex.tag & 0x3FFFU;
  for (int axis = 0; axis < 3; ++axis) {
    word |= static_cast<std::uint32_t>(vertex.cell[axis] & 63) << (14 + 6 * axis);
  }
  return {{vertex.local[0], vertex.local[1], vertex.local[2], word}, false};
}

std::uint32_t page_word(Opcode opcode, int page) {
  if (page < 0 || page > 255) throw std::invalid_argument("a page is 0 to 255");
  return static_cast<std::uint32_t>(opcode) | static_cast<std::uint32_t>(page) << 8;
}

/// Points of a lattice with its fourth component behind a header, which gets the flag for it.
void append_points(std::vector<Beat>& beats, const LatticeWords& lattice, std::size_t first,
                   std::size_t count) {
  if (!lattice.fourth.empty() && lattice.fourth.size() != lattice.points.size()) {
    throw std::invalid_argument("a fourth component is for each point or for none");
  }
  if (!lattice.fourth.empty()) beats[0].words[0] |= kFourthFlag;
  for (std::size_t p = first; p < first + count; ++p) {
    const auto& point = lattice.points[p];
    beats.push_back(
        {{point[0], point[1], point[2], lattice.fourth.empty() ? 0 : lattice.fourth[p]}, false});
  }
  beats.back().last = true;
}

std::uint32_t dims_word(const LatticeWords& lattice) {
  std::uint32_t word = 0;
  for (int axis = 0; axis < 3; ++axis) {
    word |= static_cast<std::uint32_t>(lattice.dims[axis]) << (8 * axis);
  }
  return word;
}

template <class Vertex, class PacketOf>
std::vector<Beat> in_packets(const std::vector<Vertex>& vertices, PacketOf packet_of) {
  std::vector<Beat> beats;
  for (auto first = vertices.begin(); first != vertices.end();) {
    const auto left = static_cast<std::size_t>(vertices.end() - first);
    const auto last = first + static_cast<std::ptrdiff_t>(std::min(kPacketVertices, left));
    append(beats, packet_of(std::vector<Vertex>(first, last)));
    first = last;
  }
  return beats;
}

}  // namespace

std::vector<Beat> coefficients_packet(const std::array<AxisWords, 3>& axes, Functions functions) {
  std::vector<Beat> beats(1);
  beats[0].words = {static_cast<std::uint32_t>(Opcode::kCoefficients), kCoefficientBeats, 0, 0};
  for (int axis = 0; axis < 3; ++axis) {
    beats[0].words[2] |= static_cast<std::uint32_t>(axes[axis].degree) << (2 * axis);
    beats[0].words[2] |= static_cast<std::uint32_t>(axes[axis].shift) << (8 + 2 * axis);
    for (const auto& words : axes[axis].word) beats.push_back({words, false});
  }
  for (int axis = 0; axis < 3 && functions == Functions::kDerivativesToo; ++axis) {
    const DerivativeWords& derivative = axes[axis].derivative;
    beats[0].words[1] = 2 * kCoefficientBeats;
    beats[0].words[2] |= kDerivativesFollow;
    beats[0].words[2] |= static_cast<std::uint32_t>(derivative.shift) << (16 + 2 * axis);
    for (const auto& words : derivative.word) beats.push_back({words, false});
  }
  beats.back().last = true;
  return beats;
}

std::vector<Beat> lattice_packet(const LatticeWords& lattice) {
  std::vector<Beat> beats(1);
  beats.reserve(1 + lattice.points.size());
  beats[0].words = {static_cast<std::uint32_t>(Opcode::kLattice),
                    static_cast<std::uint32_t>(lattice.points.size()), dims_word(lattice),
                    exponent_word(lattice.exponent)};
  for (const auto& point : lattice.points) {
    beats.push_back({{point[0], point[1], point[2], 0}, false});
  }
  beats.back().last = true;
  return beats;
}

std::vector<Beat> page_packet(int page, const LatticeWords& lattice,
                              const std::array<int, 3>& origin) {
  std::vector<Beat> beats(1);
  beats[0].words = {page_word(Opcode::kPage, page),
                    static_cast<std::uint32_t>(lattice.points.size()), dims_word(lattice),
                    exponent_word(lattice.exponent)};
  if (*std::max_element(lattice.dims.begin(), lattice.dims.end()) > kSmallAxisPoints) {
    beats[0].words[0] |= kLargeFlag;
  }
  for (int axis = 0; axis < 3; ++axis) {
    if (origin[axis] < 0 || origin[axis] > 127) {
      throw std::invalid_argument("an origin beyond 127 cells");
    }
    beats[0].words[3] |= static_cast<std::uint32_t>(origin[axis]) << (10 + 7 * axis);
  }
  append_points(beats, lattice, 0, lattice.points.size());
  return beats;
}

std::vector<Beat> points_packet(int page, const LatticeWords& lattice, std::size_t first,
                                std::size_t count) {
  if (first > lattice.points.size() || count > lattice.points.size() - first) {
    throw std::invalid_argument("points beyond the end of the page");
  }
  std::vector<Beat> beats(1);
  beats[0].words = {page_word(Opcode::kPoints, page), static_cast<std::uint32_t>(count),
                    static_cast<std::uint32_t>(first), exponent_word(lattice.exponent)};
  append_points(beats, lattice, first, count);
  return beats;
}

std::vector<Beat> page_vertices_packet(int page, const std::vector<VertexBeat>& vertices,
                                       const PageVertices& how) {
  std::vector<Beat> beats = {vertices_header(Opcode::kPageVertices, how.every ? 0 : vertices.size(),
                                             how.mode, how.results)};
  beats[0].words[0] = page_word(Opcode::kPageVertices, page) | (how.every ? kEveryFlag : 0) |
                      (how.fourth ? kFourthFlag : 0) | (how.large ? kLargeFlag : 0) |
                      (how.count ? kCountFlag : 0) | (how.interrupt ? kInterruptFlag : 0) |
                      (how.half ? kHalfFlag : 0);
  for (const VertexBeat& vertex : vertices) {
    beats.push_back(how.large ? large_beat_of(vertex) : beat_of(vertex));
  }
  beats.back().last = true;
  return beats;
}

std::vector<Beat> vertices_packet(const std::vector<VertexBeat>& vertices, OutsideMode mode,
                                  Results results) {
  std::vector<Beat> beats = {vertices_header(Opcode::kVertices, vertices.size(), mode, results)};
  beats.reserve(1 + vertices.size());
  for (const VertexBeat& vertex : vertices) beats.push_back(beat_of(vertex));
  beats.back().last = true;
  return beats;
}

std::vector<Beat> interleaved_packet(const std::vector<InterleavedVertex>& vertices,
                                     OutsideMode mode, Results results) {
  std::vector<Beat> beats = {vertices_header(Opcode::kInterleaved, vertices.size(), mode, results)};
  beats.reserve(1 + kVertexBeats * vertices.size());
  if (!vertices.empty()) beats[0].words[3] = exponent_word(vertices.front().exponent);
  for (const InterleavedVertex& vertex : vertices) {
    if (vertex.exponent != vertices.front().exponent) {
      throw std::invalid_argument("interleaved vertices of one packet have one exponent");
    }
    beats.push_back(beat_of(vertex));
    for (int row = 0; row < kPointBeats; ++row) {
      const std::uint32_t* words = &vertex.points[4 * row];
      beats.push_back({{words[0], words[1], words[2], words[3]}, false});
    }
  }
  beats.back().last = true;
  return beats;
}

std::vector<Beat> vertices_packets(const std::vector<VertexBeat>& vertices, Results results) {
  return in_packets(vertices, [results](const auto& some) {
    return vertices_packet(some, OutsideMode::kClamp, results);
  });
}

std::vector<Beat> interleaved_packets(const std::vector<InterleavedVertex>& vertices) {
  return in_packets(vertices, [](const auto& some) { return interleaved_packet(some); });
}

VertexBeat vertex_of(const Beat& beat, int axis_points, bool large) {
  VertexBeat vertex;
  const std::uint32_t word = beat.words[3];
  for (int axis = 0; axis < 3; ++axis) {
    vertex.local[axis] = beat.words[axis];
    const std::uint32_t fifth = axis_points > kAxisPoints ? word >> (28 + axis) & 1 : 0;
    vertex.cell[axis] = static_cast<int>(large ? word >> (14 + 6 * axis) & 63
                                               : (word >> (16 + 4 * axis) & 15) | fifth << 4);
  }
  vertex.tag = static_cast<std::uint16_t>(word);
  return vertex;
}

void end_results(std::vector<Beat>& results, std::uint32_t count, std::uint32_t flags) {
  if ((flags & kCountFlag) != 0) results.push_back({{count, 0, 0, ~0U}, false});
  results.back().last = true;
  results.back().user = (flags & kInterruptFlag) != 0;
}

void append(std::vector<Beat>& beats, const std::vector<Beat>& more) {
  beats.insert(beats.end(), more.begin(), more.end());
}

}  // namespace hwffd
