#pragma once

#include <cstdint>
#include <random>
#include <vector>

#include "hwffd/model/evaluator.hpp"
#include "hwffd/points.hpp"

namespace hwffd::words {

/// One vertex, what eq. (1) in double makes of it, and its words in both kinds of format. Points
/// lie in [-1, 1).
struct Sample {
  Point exact;
  model::VertexWords fixed;   ///< the words of every fixed-point format
  model::VertexWords binary;  ///< the words of binary32
};

/// Vertices with uniform coordinates, alternately in a random cell (each control point uniform in
/// [-1, 1) by itself) and in a smooth one (out of a twisted, bent or sheared lattice).
class Samples {
 public:
  Samples();

  /// `count` vertices, the same for the same seed on every machine.
  std::vector<Sample> draw(std::uint64_t seed, int count) const;

 private:
  Sample draw_one(std::mt19937_64& engine, bool smooth) const;

  std::vector<Support> smooth_;  // of every cell of every deformed lattice
};

}  // namespace hwffd::words
