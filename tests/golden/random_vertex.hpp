#pragma once

#include <algorithm>
#include <random>
#include <string>

#include "hwffd/model/evaluator.hpp"
#include "hwffd/oracle/oracle.hpp"
#include "hwffd/stream/blending.hpp"
#include "uniform.hpp"

namespace hwffd {

/// Loads functions and their derivatives on all axes.
inline void load(model::EvaluatorModel& model, const AxisWords& axis, int bank = 0) {
  for (int a = 0; a < 3; ++a) {
    for (int l = 0; l < 4; ++l) {
      model.load(bank, a, l, axis.degree, axis.shift, axis.word[l]);
      model.load_derivative(bank, a, l, axis.degree, axis.derivative.shift,
                            axis.derivative.word[l]);
    }
  }
}

/// The overlapped `basic` of a number format.
inline const Configuration& basic_row(const std::string& format) {
  return find_configuration("basic-" + format + "-overlapped");
}

/// A vertex as the model takes it, and what it stands for.
struct Vertex {
  model::VertexWords words;
  Support support;
  Eigen::Vector3d local;
};

/// Points uniform in [-reach, reach).
inline Vertex random_vertex(const WordCodec& codec, double reach, std::mt19937_64& engine) {
  Vertex vertex;
  for (int a = 0; a < 3; ++a) {
    vertex.local[a] = unit(engine);
    vertex.words.local[a] = codec.coordinate(vertex.local[a]);
    vertex.words.cell[a] = static_cast<int>(engine() & 15);
  }
  for (int i = 0; i < 192; ++i) {
    vertex.support(i / 3, i % 3) = reach * (2 * unit(engine) - 1);
    vertex.words.points[i] = codec.point(vertex.support(i / 3, i % 3));
  }
  return vertex;
}

/// The largest difference of a component from the oracle's, over so many random vertices; nothing
/// may saturate or be NaN.
inline double largest_error(const model::EvaluatorModel& model, const WordCodec& codec,
                            const Oracle& oracle, double reach, int vertices) {
  std::mt19937_64 engine(1);
  double largest = 0;
  for (int v = 0; v < vertices; ++v) {
    const Vertex vertex = random_vertex(codec, reach, engine);
    const model::ResultWords result = model.evaluate(0, vertex.words);
    EXPECT_FALSE(result.nan || (result.saturated && reach < 1));
    const Eigen::Vector3d& at = vertex.local;
    const Eigen::Vector3d exact = oracle.evaluate(vertex.support, at[0], at[1], at[2]);
    for (int c = 0; c < 3; ++c) {
      largest = std::max(largest, std::abs(codec.decode_point(result.words[c]) - exact[c]));
    }
  }
  return largest;
}

/// The largest error that a row may have with a family: an upper bound that says something.
struct Bound {
  std::string name() const { return std::string(row) + "_" + family; }

  const char* row;
  const char* family;
  double error;
};
inline void PrintTo(const Bound& bound, std::ostream* out) { *out << bound.name(); }

}  // namespace hwffd
