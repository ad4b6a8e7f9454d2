#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

namespace hwffd {

/// Eq. (1) for many vertices, contracted axis by axis: s, then t, then u. A vertex's result depends
/// on nothing but its own numbers, bit for bit, whatever comes before and behind it.
template <class Real>
struct Contraction {
  const Real* points;                  ///< x, y, z and a fourth number that counts for nothing
  std::array<std::size_t, 2> strides;  ///< to the next point along s and t, in points; 1 along u
  const Real* functions;               ///< 3 x 4 x 4: axis, power of the coordinate, function
  const std::uint32_t* origins;        ///< the first of each vertex's 4 x 4 x 4 points
  std::array<const Real*, 3> local;    ///< s, t, u of each vertex
  std::array<Real*, 3> results;        ///< x, y, z of each vertex
  std::size_t count;                   ///< vertices
};

/// By the widest vectors that the processor has. Where it has fused multiply-add the bits are the
/// same for all widths.
void contract(const Contraction<float>& job);
void contract(const Contraction<double>& job);

}  // namespace hwffd
