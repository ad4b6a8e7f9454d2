#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "hwffd/lattice/lattice.hpp"
#include "hwffd/model/configuration.hpp"
#include "hwffd/stream/grid.hpp"
#include "hwffd/stream/packets.hpp"

namespace hwffd {

/// Gradients pulled back by the bit-true model of a scatter core, with the weights of a row of
/// `affine`. All are scaled by one power of two; pages of so few vertices that their collects are
/// exact are added as whole numbers, on all threads.
/// @param saturated  grows by the vertices that saturated on the way
Points model_pull_back(const Configuration& row, const Index3& dims,
                       const std::vector<Embedded>& vertices, const Points& gradient,
                       const std::array<AxisWords, 3>& axes, std::uint64_t& saturated);

/// The same of a grid by rows, as a core with ROWS 1 adds them.
Points model_pull_back_rows(const Configuration& row, const Index3& dims, const Grid& grid,
                            const Points& gradient, const std::array<AxisWords, 3>& axes,
                            std::uint64_t& saturated);

}  // namespace hwffd
