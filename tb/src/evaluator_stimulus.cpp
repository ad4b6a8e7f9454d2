#include "hwffd/tb/evaluator_stimulus.hpp"

#include <cmath>

#include "hwffd/tb/random.hpp"

namespace hwffd::tb {
namespace {

constexpr std::size_t kSupports = 240;
constexpr int kCells = 6;  // of the lattice with seams, an axis
constexpr int kPoints = kCells + 3;

int cell_number(const std::array<int, 3>& cell) {
  return (cell[0] * kCells + cell[1]) * kCells + cell[2];
}

std::vector<SupportWords> lattice_supports(const WordCodec& codec, Random& random) {
  std::vector<std::array<std::uint32_t, 3>> points(kPoints * kPoints * kPoints);
  for (auto& point : points) {
    for (std::uint32_t& word : point) word = codec.point(2 * random.unit() - 1);
  }
  std::vector<SupportWords> supports(kCells * kCells * kCells);
  for (std::size_t s = 0; s < supports.size(); ++s) {
    const int cell = static_cast<int>(s);
    const std::array<int, 3> first = {cell / (kCells * kCells), cell / kCells % kCells,
                                      cell % kCells};
    for (int p = 0; p < 64; ++p) {
      const int at =
          ((first[0] + p / 16) * kPoints + first[1] + p / 4 % 4) * kPoints + first[2] + p % 4;
      for (int c = 0; c < 3; ++c) supports[s].points[3 * p + c] = points[at][c];
    }
  }
  return supports;
}

}  // namespace

EvaluatorStimulus random_stimulus(const WordCodec& codec, std::size_t vertices, std::uint64_t seed,
                                  std::size_t together) {
  Random random(seed);
  EvaluatorStimulus stimulus;
  stimulus.supports.resize(kSupports);
  for (SupportWords& support : stimulus.supports) {
    if (codec.is_block()) support.exponent = static_cast<int>(random.below(121)) - 60;
    for (std::uint32_t& word : support.points) {
      word = codec.point(std::ldexp(2 * random.unit() - 1, support.exponent));
    }
  }
  stimulus.vertices.resize(vertices);
  for (std::size_t v = 0; v < vertices; ++v) {
    EvaluatorVertex& vertex = stimulus.vertices[v];
    for (std::uint32_t& word : vertex.local) {
      word = codec.coordinate(random.chance(0.1) ? random.pick({0.0, 1.0}) : random.unit());
    }
    if (v % together != 0) {
      vertex.cell = stimulus.vertices[v - 1].cell;
    } else {
      for (int& cell : vertex.cell) cell = static_cast<int>(random.below(16));
    }
    vertex.support = static_cast<std::uint8_t>(v / together % kSupports);
  }
  return stimulus;
}

std::vector<InterleavedVertex> interleaved(const EvaluatorStimulus& stimulus) {
  std::vector<InterleavedVertex> vertices;
  for (const EvaluatorVertex& from : stimulus.vertices) {
    InterleavedVertex& vertex = vertices.emplace_back();
    vertex.local = from.local;
    vertex.cell = from.cell;
    vertex.points = stimulus.supports[from.support].points;
    vertex.exponent = stimulus.supports[from.support].exponent;
  }
  return vertices;
}

SeamStimulus seam_stimulus(const WordCodec& codec, std::size_t values, std::uint64_t seed) {
  Random random(seed);
  SeamStimulus stimulus;
  stimulus.supports = lattice_supports(codec, random);
  for (std::size_t group = 0; 3 * stimulus.vertices.size() < values; ++group) {
    const auto shared = static_cast<unsigned>(1 + random.below(7));  // axes, as bits
    EvaluatorVertex inside;
    for (std::uint32_t& word : inside.local) word = codec.coordinate(random.unit());
    for (int& cell : inside.cell) cell = static_cast<int>(random.below(kCells - 1));
    for (unsigned upper = 0; upper < 8; ++upper) {
      if ((upper & ~shared) != 0) continue;
      EvaluatorVertex vertex = inside;
      for (int axis = 0; axis < 3; ++axis) {
        if ((shared >> axis & 1) == 0) continue;
        const bool is_upper = (upper >> axis & 1) != 0;
        vertex.cell[axis] += is_upper ? 1 : 0;
        vertex.local[axis] = codec.coordinate(is_upper ? 0.0 : 1.0);
      }
      vertex.support = static_cast<std::uint8_t>(cell_number(vertex.cell));
      stimulus.vertices.push_back(vertex);
      stimulus.group.push_back(group);
    }
  }
  return stimulus;
}

}  // namespace hwffd::tb
