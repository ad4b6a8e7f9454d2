#pragma once

#include <array>
#include <vector>

#include "hwffd/lattice/lattice.hpp"
#include "hwffd/oracle/oracle.hpp"

namespace hwffd {

/// The transpose of evaluate_in(), in double: of the gradient of a number with respect to the
/// positions of vertices, n x 3, that with respect to the control points of a lattice of so many
/// points an axis, in their order.
///
/// Sums are exact until their end, which rounds: each term is cut to a multiple of one unit, its
/// rest to one of a second, and multiples of a unit are added without rounding as long as they are
/// below 2^53 of it. Both units follow from the largest gradient and the number of vertices. So
/// bits depend neither on the order of the vertices nor on how they are spread over threads. Beside
/// its own rounding and that of its terms, a sum is off by less than 2^(2 log2(n) - 95) of the
/// largest gradient for each of n vertices, with B-splines. Cells are not checked.
Points pull_back_in(const Index3& dims, const std::vector<Embedded>& vertices,
                    const Points& gradient, const std::array<Oracle::Coefficients, 3>& blending);

}  // namespace hwffd
