#include "hwffd/lattice/lattice_evaluator.hpp"

#include <algorithm>

#include "hwffd/on_threads.hpp"
#include "lattice/contraction.hpp"

namespace hwffd {
namespace {

constexpr std::size_t kBlock = 1024;  // vertices whose arrays stay in the nearest cache
constexpr std::size_t kVerticesAtOnce = 16 * kBlock;  // vertices that a thread takes at once

/// Points, n x 3, as x, y, z, 0 each, behind those that are there.
template <class Real, class Rows>
void append(std::vector<Real>& to, const Rows& points) {
  for (Eigen::Index row = 0; row < points.rows(); ++row) {
    for (Eigen::Index c = 0; c < 3; ++c) to.push_back(static_cast<Real>(points(row, c)));
    to.push_back(0);
  }
}

/// Positions of `count` vertices, block by block, on all threads. put(v, i, arrays) puts vertex v
/// into place i of the arrays; evaluate(first, arrays) evaluates a block.
template <class Put, class Evaluate>
Points by_blocks(std::size_t count, const Put& put, const Evaluate& evaluate) {
  Points positions(static_cast<Eigen::Index>(count), 3);
  on_ranges(count, kVerticesAtOnce, [&](std::size_t begin, std::size_t end) {
    VertexArrays<double> block;
    for (std::size_t first = begin; first < end; first += kBlock) {
      const std::size_t size = std::min(kBlock, end - first);
      block.resize(size);
      for (std::size_t i = 0; i < size; ++i) put(first + i, i, block);
      evaluate(first, block);
      for (std::size_t i = 0; i < size; ++i) {
        for (std::size_t c = 0; c < 3; ++c) {
          positions(static_cast<Eigen::Index>(first + i), static_cast<Eigen::Index>(c)) =
              block.position[c][i];
        }
      }
    }
  });
  return positions;
}

void put_local(const Eigen::Vector3d& local, std::size_t i, VertexArrays<double>& to) {
  for (std::size_t axis = 0; axis < 3; ++axis) {
    to.local[axis][i] = local[static_cast<Eigen::Index>(axis)];
  }
}

}  // namespace

template <class Real>
void VertexArrays<Real>::resize(std::size_t count) {
  origins.resize(count);
  for (auto* arrays : {&local, &position}) {
    for (std::vector<Real>& array : *arrays) array.resize(count);
  }
}

template <class Real>
LatticeEvaluator<Real>::LatticeEvaluator(const Blending& blending) {
  Real* next = functions_.data();
  for (const Oracle::Coefficients& axis : blending) {
    for (Eigen::Index power = 0; power < 4; ++power) {
      for (Eigen::Index l = 0; l < 4; ++l) *next++ = static_cast<Real>(axis(l, power));
    }
  }
}

template <class Real>
LatticeEvaluator<Real>::LatticeEvaluator(const Lattice& lattice, const Blending& blending)
    : LatticeEvaluator(blending) {
  const Index3& dims = lattice.dims();
  strides_[1] = static_cast<std::size_t>(dims[2]);
  strides_[0] = static_cast<std::size_t>(dims[1]) * strides_[1];
  points_.reserve(4 * static_cast<std::size_t>(lattice.points().rows()));
  append(points_, lattice.points());
}

template <class Real>
LatticeEvaluator<Real>::LatticeEvaluator(const std::vector<SupportedVertex>& vertices,
                                         const Blending& blending)
    : LatticeEvaluator(blending) {
  points_.reserve(4 * 64 * vertices.size());
  for (const SupportedVertex& vertex : vertices) append(points_, vertex.support);
}

template <class Real>
void LatticeEvaluator<Real>::evaluate(VertexArrays<Real>& vertices) const {
  auto& [origins, local, position] = vertices;
  contract(Contraction<Real>{points_.data(),
                             strides_,
                             functions_.data(),
                             origins.data(),
                             {local[0].data(), local[1].data(), local[2].data()},
                             {position[0].data(), position[1].data(), position[2].data()},
                             origins.size()});
}

template struct VertexArrays<float>;
template struct VertexArrays<double>;
template class LatticeEvaluator<float>;
template class LatticeEvaluator<double>;

Points evaluate_in(const Lattice& lattice, const std::vector<Embedded>& vertices,
                   const std::array<Oracle::Coefficients, 3>& blending) {
  const LatticeEvaluator<double> evaluator(lattice, blending);
  return by_blocks(
      vertices.size(),
      [&](std::size_t v, std::size_t i, VertexArrays<double>& to) {
        to.origins[i] = evaluator.origin(vertices[v].cell);
        put_local(vertices[v].local, i, to);
      },
      [&](std::size_t, VertexArrays<double>& block) { evaluator.evaluate(block); });
}

Points evaluate_in(const std::vector<SupportedVertex>& vertices,
                   const std::array<Oracle::Coefficients, 3>& blending) {
  using Evaluator = LatticeEvaluator<double>;
  return by_blocks(
      vertices.size(),
      [&](std::size_t v, std::size_t i, VertexArrays<double>& to) {
        to.origins[i] = Evaluator::origin(i);
        put_local(vertices[v].local, i, to);
      },
      [&](std::size_t first, VertexArrays<double>& block) {
        const auto begin = vertices.begin() + static_cast<std::ptrdiff_t>(first);
        const auto end = begin + static_cast<std::ptrdiff_t>(block.origins.size());
        Evaluator({begin, end}, blending).evaluate(block);
      });
}

}  // namespace hwffd
