#include "axis_points.hpp"

namespace hwffd {

Lattice mapped(const Lattice& lattice, const Index3& dims, const AxisPoints& point_of) {
  Index3 now = lattice.dims();
  Points points = lattice.points();
  for (int axis = 0; axis < 3; ++axis) {
    const auto a = static_cast<std::size_t>(axis);
    Index3 next = now;
    next[a] = dims[a];
    int step = 1;  // rows between neighbours along the axis
    for (std::size_t later = a + 1; later < 3; ++later) step *= now[later];
    Points result = Points::Zero(static_cast<Eigen::Index>(next[0]) * next[1] * next[2], 3);
    for (Eigen::Index row = 0; row < result.rows(); ++row) {
      const auto at = static_cast<int>(row / step % next[a]);
      const AxisPoint from = point_of(axis, at);
      const Eigen::Index block = row / (static_cast<Eigen::Index>(step) * next[a]);
      const Eigen::Index start = (block * now[a] + from.first) * step + row % step;
      for (int l = 0; l < 4; ++l) {
        if (from.weights[l] != 0) result.row(row) += from.weights[l] * points.row(start + l * step);
      }
    }
    points = std::move(result);
    now = next;
  }
  return Lattice(dims, std::move(points));
}

Points mapped_back(const Points& gradient, const Index3& dims, const Index3& lattice,
                   const AxisPoints& point_of) {
  Index3 now = dims;
  Points points = gradient;
  for (int axis = 2; axis >= 0; --axis) {
    const auto a = static_cast<std::size_t>(axis);
    Index3 next = now;
    next[a] = lattice[a];
    int step = 1;  // rows between neighbours along the axis
    for (std::size_t later = a + 1; later < 3; ++later) step *= now[later];
    Points result = Points::Zero(static_cast<Eigen::Index>(next[0]) * next[1] * next[2], 3);
    for (Eigen::Index row = 0; row < points.rows(); ++row) {
      const auto at = static_cast<int>(row / step % now[a]);
      const AxisPoint to = point_of(axis, at);
      const Eigen::Index block = row / (static_cast<Eigen::Index>(step) * now[a]);
      const Eigen::Index start = (block * next[a] + to.first) * step + row % step;
      for (int l = 0; l < 4; ++l) {
        if (to.weights[l] != 0) result.row(start + l * step) += to.weights[l] * points.row(row);
      }
    }
    points = std::move(result);
    now = next;
  }
  return points;
}

}  // namespace hwffd
