#pragma once

#include <array>
#include <cmath>
#include <cstdint>
#include <memory>
#include <random>
#include <string>
#include <vector>

#include "hwffd/model/evaluator.hpp"
#include "hwffd/model/scatter.hpp"
#include "hwffd/stream/blending.hpp"

/// What the tests of scatter share: its models, and vertices with gradients.
namespace hwffd::scatter {

constexpr int kWidth = 17;  // of the rows of affine
constexpr int kPosition = -1;
using Fx = Fixed<kWidth>;

inline const std::vector<std::string>& families() {
  static const std::vector<std::string> names = {"bspline", "bernstein", "catmull-rom", "linear",
                                                 "constant"};
  return names;
}

inline AxisWords words_of(const std::string& name, const WordCodec& codec) {
  return encode(family(name, codec), codec);
}

inline std::string format_of(int width) { return "fx" + std::to_string(width); }

/// A model with a family on all axes.
/// @param width  of its words, those of the row or others
inline std::unique_ptr<model::ScatterModel> scatter_of(const std::string& name,
                                                       const char* row = "affine-fx17-overlapped",
                                                       int width = kWidth) {
  const std::string format = format_of(width);
  Configuration configuration = find_configuration(row);
  configuration.format = format.c_str();
  auto result = model::make_scatter_model(configuration);
  const AxisWords words = words_of(name, WordCodec(format));
  for (int axis = 0; axis < 3; ++axis) result->load(axis, words);
  return result;
}

template <class F>
model::CoefficientBank<F> bank_of(const AxisWords& words) {
  model::CoefficientBank<F> bank;
  for (int axis = 0; axis < 3; ++axis) {
    for (int l = 0; l < 4; ++l) {
      bank.load(axis, l, words.degree, words.shift, words.word[l]);
      bank.load_derivative(axis, l, words.degree, words.derivative.shift, words.derivative.word[l]);
    }
  }
  return bank;
}

/// A place anywhere in a lattice of so many cells, now and then on a face; a gradient of any size,
/// now and then the largest.
inline model::GradientWords random_gradient(std::mt19937_64& engine,
                                            const std::array<int, 3>& cells = {16, 16, 16}) {
  model::GradientWords vertex;
  const unsigned size = engine() % 31;
  for (int axis = 0; axis < 3; ++axis) {
    vertex.cell[axis] = static_cast<int>(engine() % static_cast<unsigned>(cells[axis]));
    vertex.local[axis] = static_cast<std::uint32_t>(engine() % 0x80000001U);
    if (engine() % 16 == 0) vertex.local[axis] = engine() % 2 == 0 ? 0 : 0x80000000;
    const auto bits = static_cast<std::int32_t>(engine() >> 32);
    vertex.gradient[axis] = static_cast<std::uint32_t>(bits >> size);
    if (engine() % 16 == 0) vertex.gradient[axis] = engine() % 2 == 0 ? 0x80000000 : 0x7FFFFFFF;
  }
  return vertex;
}

/// So many vertices of a row, in any order.
inline std::vector<model::GradientWords> random_row(std::mt19937_64& engine, std::size_t count,
                                                    const std::array<int, 3>& cells = {16, 16, 16},
                                                    int derivative = kPosition) {
  std::vector<model::GradientWords> row;
  for (std::size_t v = 0; v < count; ++v) {
    model::GradientWords vertex = random_gradient(engine, cells);
    vertex.derivative = derivative;
    for (int axis = 1; v > 0 && axis < 3; ++axis) {
      vertex.cell[axis] = row[0].cell[axis];
      vertex.local[axis] = row[0].local[axis];
    }
    row.push_back(vertex);
  }
  return row;
}

/// Whether a component is so large that it rounds to 1.
inline bool saturates(const model::GradientWords& vertex) {
  for (const std::uint32_t word : vertex.gradient) {
    if (word == 0x7FFFFFFF) return true;
  }
  return false;
}

inline double coordinate(std::uint32_t word) { return std::ldexp(static_cast<double>(word), -31); }

inline Eigen::Vector3d local_of(const model::GradientWords& vertex) {
  return {coordinate(vertex.local[0]), coordinate(vertex.local[1]), coordinate(vertex.local[2])};
}

inline Eigen::Vector3d gradient_of(const model::GradientWords& vertex) {
  Eigen::Vector3d gradient;
  for (int c = 0; c < 3; ++c) {
    gradient[c] = std::ldexp(static_cast<std::int32_t>(vertex.gradient[c]), -31);
  }
  return gradient;
}

}  // namespace hwffd::scatter
