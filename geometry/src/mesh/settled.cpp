#include "hwffd/mesh/settled.hpp"

#include <cmath>

namespace hwffd {

Points settled(Points positions, const Points& rest) {
  constexpr double kRounding = 0x1p-50;  // of a double, a few times
  const double most = rest.rows() == 0 ? 0.0 : kRounding * rest.cwiseAbs().maxCoeff();
  for (Eigen::Index row = 0; row < rest.rows(); ++row) {
    for (int axis = 0; axis < 3; ++axis) {
      const bool stays = std::abs(positions(row, axis) - rest(row, axis)) <= most;
      if (stays) positions(row, axis) = rest(row, axis);
    }
  }
  return positions;
}

}  // namespace hwffd
