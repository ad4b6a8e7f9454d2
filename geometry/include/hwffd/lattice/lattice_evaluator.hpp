#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "hwffd/lattice/interleave.hpp"
#include "hwffd/lattice/lattice.hpp"
#include "hwffd/oracle/oracle.hpp"

namespace hwffd {

/// Vertices as arrays of one number each.
template <class Real>
struct VertexArrays {
  std::vector<std::uint32_t> origins;         ///< LatticeEvaluator::origin of their cells
  std::array<std::vector<Real>, 3> local;     ///< s, t, u
  std::array<std::vector<Real>, 3> position;  ///< x, y, z: room for the results

  void resize(std::size_t count);
};

/// Eq. (1) by the vector units of the processor, by the widest that it has. Real is float or
/// double.
///
/// The sum is contracted axis by axis, s first: (sum over l of P B_l(s)), then over m, then over n.
/// A position depends on its vertex, lattice and blending functions alone, bit for bit: not on how
/// many vertices there are, on their order or on those beside it. Between processors bits differ
/// where one has no fused multiply-add. Vertices of one cell that follow each other are two to
/// three times as fast as others.
template <class Real>
class LatticeEvaluator {
 public:
  using Blending = std::array<Oracle::Coefficients, 3>;

  /// Of a lattice.
  LatticeEvaluator(const Lattice& lattice, const Blending& blending);
  /// Of supports that vertices bring with them.
  LatticeEvaluator(const std::vector<SupportedVertex>& vertices, const Blending& blending);

  /// What stands for a cell of the lattice in VertexArrays::origins. Unchecked.
  std::uint32_t origin(const Index3& cell) const {
    return static_cast<std::uint32_t>(static_cast<std::size_t>(cell[0]) * strides_[0] +
                                      static_cast<std::size_t>(cell[1]) * strides_[1] +
                                      static_cast<std::size_t>(cell[2]));
  }
  /// What stands for a vertex that brings its support, of the 2^26 that an evaluator may have.
  static std::uint32_t origin(std::size_t vertex) {
    return static_cast<std::uint32_t>(64 * vertex);
  }

  /// Positions of all vertices.
  /// @param vertices  each array as long as `origins`; origins are not checked
  void evaluate(VertexArrays<Real>& vertices) const;

 private:
  explicit LatticeEvaluator(const Blending& blending);

  std::array<std::size_t, 2> strides_{16, 4};  ///< to the next point along s and t, in points
  std::vector<Real> points_;                   ///< x, y, z, 0 each
  std::array<Real, 48> functions_;             ///< axis, power, function
};

/// Positions of vertices in a lattice, n x 3, in double. Cells are not checked.
Points evaluate_in(const Lattice& lattice, const std::vector<Embedded>& vertices,
                   const std::array<Oracle::Coefficients, 3>& blending);
/// Positions of vertices that bring their control points.
Points evaluate_in(const std::vector<SupportedVertex>& vertices,
                   const std::array<Oracle::Coefficients, 3>& blending);

}  // namespace hwffd
