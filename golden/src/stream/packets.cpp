#include "hwffd/stream/packets.hpp"

namespace hwffd {

std::vector<Beat> coefficients_packet(const std::array<AxisWords, 3>& axes) {
  std::vector<Beat> beats(1);
  beats[0].words = {static_cast<std::uint32_t>(Opcode::kCoefficients), kCoefficientBeats, 0, 0};
  for (int axis = 0; axis < 3; ++axis) {
    beats[0].words[2] |= static_cast<std::uint32_t>(axes[axis].degree) << (2 * axis);
    beats[0].words[2] |= static_cast<std::uint32_t>(axes[axis].shift) << (8 + 2 * axis);
    for (const auto& words : axes[axis].word) beats.push_back({words, false});
  }
  beats.back().last = true;
  return beats;
}

std::vector<Beat> interleaved_packet(const std::vector<InterleavedVertex>& vertices) {
  std::vector<Beat> beats(1);
  beats.reserve(1 + kVertexBeats * vertices.size());
  beats[0].words = {static_cast<std::uint32_t>(Opcode::kInterleaved),
                    static_cast<std::uint32_t>(vertices.size()), 0, 0};
  for (const InterleavedVertex& vertex : vertices) {
    std::uint32_t word = vertex.tag;
    for (int axis = 0; axis < 3; ++axis) {
      word |= static_cast<std::uint32_t>(vertex.cell[axis] & 15) << (16 + 4 * axis);
    }
    beats.push_back({{vertex.local[0], vertex.local[1], vertex.local[2], word}, false});
    for (int row = 0; row < kPointBeats; ++row) {
      const std::uint32_t* words = &vertex.points[4 * row];
      beats.push_back({{words[0], words[1], words[2], words[3]}, false});
    }
  }
  beats.back().last = true;
  return beats;
}

}  // namespace hwffd
