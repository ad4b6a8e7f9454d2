#pragma once

#include <algorithm>
#include <array>
#include <random>
#include <vector>

#include "hwffd/stream/packets.hpp"
#include "random_vertex.hpp"

namespace hwffd {

using Dims = std::array<int, 3>;

inline LatticeWords random_words(const WordCodec& codec, const Dims& dims,
                                 std::mt19937_64& random) {
  LatticeWords lattice;
  lattice.dims = dims;
  lattice.exponent = codec.is_block() ? 3 : 0;
  lattice.points.resize(static_cast<std::size_t>(dims[0]) * dims[1] * dims[2]);
  for (auto& point : lattice.points) {
    for (std::uint32_t& word : point) word = codec.point(2 * unit(random) - 1);
  }
  return lattice;
}

/// @param most  cells an axis are below that and those of the lattice
inline std::vector<VertexBeat> random_beats(const WordCodec& codec, const Dims& dims,
                                            std::size_t count, std::mt19937_64& random,
                                            bool stray = false, int most = 1000) {
  std::vector<VertexBeat> vertices(count);
  for (VertexBeat& vertex : vertices) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const int cells = std::min(most, dims[axis] - (stray && random() % 8 == 0 ? 0 : 3));
      vertex.cell[axis] = static_cast<int>(random() % cells);
      const double at = random() % 8 == 0 ? static_cast<double>(random() % 2) : unit(random);
      vertex.local[axis] = codec.coordinate(stray && random() % 8 == 0 ? 1.25 : at);
    }
    vertex.tag = static_cast<std::uint16_t>(random());
  }
  return vertices;
}

}  // namespace hwffd
