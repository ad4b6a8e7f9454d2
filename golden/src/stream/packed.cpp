#include "hwffd/stream/packed.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace hwffd {
namespace {

constexpr int kCoordinateBits = 17;
constexpr int kCellsAt = 3 * kCoordinateBits;

/// A header of single vertices, made that of packed ones, and the beats behind it.
std::vector<Beat> with_pairs(Beat header, const std::vector<PackedVertex>& vertices) {
  header.words[0] |= kPackedFlag;
  header.last = vertices.empty();
  std::vector<Beat> beats = {header};
  for (std::size_t v = 0; v < vertices.size(); v += 2) {
    const std::uint64_t low = packed_bits(vertices[v]);
    const bool pair = v + 1 < vertices.size();
    const std::uint64_t high = pair ? packed_bits(vertices[v + 1]) : kNoPackedVertex;
    beats.push_back({{static_cast<std::uint32_t>(low), static_cast<std::uint32_t>(low >> 32),
                      static_cast<std::uint32_t>(high), static_cast<std::uint32_t>(high >> 32)},
                     v + 2 >= vertices.size()});
  }
  return beats;
}

}  // namespace

PackedVertex packed(const VertexBeat& vertex, const WordCodec& codec) {
  PackedVertex small;
  for (int axis = 0; axis < 3; ++axis) {
    if (vertex.cell[axis] < 0 || vertex.cell[axis] > 15) {
      throw std::invalid_argument("a packed vertex has cells 0 to 15");
    }
    small.cell[axis] = vertex.cell[axis];
    const double value = codec.decode_coordinate(vertex.local[axis]);
    small.local[axis] = static_cast<std::uint32_t>(
        std::lround(std::ldexp(std::clamp(std::isnan(value) ? 0.0 : value, 0.0, 1.0), 16)));
  }
  return small;
}

VertexBeat unpacked(const PackedVertex& vertex, std::size_t n, const WordCodec& codec) {
  VertexBeat whole;
  whole.cell = vertex.cell;
  whole.tag = static_cast<std::uint16_t>(n);
  for (int axis = 0; axis < 3; ++axis) {
    whole.local[axis] = codec.coordinate(std::ldexp(vertex.local[axis], -16));
  }
  return whole;
}

std::uint64_t packed_bits(const PackedVertex& vertex) {
  std::uint64_t bits = 0;
  for (int axis = 0; axis < 3; ++axis) {
    bits |= std::uint64_t{vertex.local[axis] & kPackedMost} << (kCoordinateBits * axis) |
            std::uint64_t{static_cast<unsigned>(vertex.cell[axis]) & 15} << (kCellsAt + 4 * axis);
  }
  return bits;
}

PackedVertex vertex_of_bits(std::uint64_t bits) {
  PackedVertex vertex;
  for (int axis = 0; axis < 3; ++axis) {
    vertex.local[axis] = static_cast<std::uint32_t>(bits >> (kCoordinateBits * axis)) & kPackedMost;
    vertex.cell[axis] = static_cast<int>(bits >> (kCellsAt + 4 * axis) & 15);
  }
  return vertex;
}

std::vector<Beat> packed_packet(const std::vector<PackedVertex>& vertices, OutsideMode mode,
                                Results results) {
  Beat header = vertices_packet({}, mode, results)[0];
  header.words[1] = static_cast<std::uint32_t>(vertices.size());
  return with_pairs(header, vertices);
}

std::vector<Beat> page_packed_packet(int page, const std::vector<PackedVertex>& vertices,
                                     const PageVertices& how) {
  if (how.large) throw std::invalid_argument("packed vertices have no flag L");
  Beat header = page_vertices_packet(page, {}, how)[0];
  if (!how.every) header.words[1] = static_cast<std::uint32_t>(vertices.size());
  return with_pairs(header, vertices);
}

}  // namespace hwffd
