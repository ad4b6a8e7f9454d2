#include "axis_points.hpp"

namespace hwffd {
namespace {

Points zeros(const Index3& dims) {
  return Points::Zero(static_cast<Eigen::Index>(dims[0]) * dims[1] * dims[2], 3);
}

/// Calls visit(row, from, weight) for each row of `mapped` and each row of `dims` that it is made
/// of; these differ along the axis only.
template <typename Visit>
void each_term(const Index3& dims, const Index3& mapped, int axis, const AxisPoints& point_of,
               const Visit& visit) {
  const auto a = static_cast<std::size_t>(axis);
  int step = 1;  // rows between neighbours along the axis
  for (std::size_t later = a + 1; later < 3; ++later) step *= dims[later];
  const Eigen::Index rows = static_cast<Eigen::Index>(mapped[0]) * mapped[1] * mapped[2];
  for (Eigen::Index row = 0; row < rows; ++row) {
    const auto at = static_cast<int>(row / step % mapped[a]);
    const AxisPoint from = point_of(axis, at);
    const Eigen::Index block = row / (static_cast<Eigen::Index>(step) * mapped[a]);
    const Eigen::Index start = (block * dims[a] + from.first) * step + row % step;
    for (int l = 0; l < 4; ++l) {
      if (from.weights[l] != 0) visit(row, start + l * step, from.weights[l]);
    }
  }
}

}  // namespace

Lattice mapped(const Lattice& lattice, const Index3& dims, const AxisPoints& point_of) {
  Index3 now = lattice.dims();
  Points points = lattice.points();
  for (int axis = 0; axis < 3; ++axis) {
    Index3 next = now;
    next[static_cast<std::size_t>(axis)] = dims[static_cast<std::size_t>(axis)];
    Points result = zeros(next);
    each_term(now, next, axis, point_of, [&](Eigen::Index row, Eigen::Index from, double weight) {
      result.row(row) += weight * points.row(from);
    });
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
    Index3 next = now;
    next[static_cast<std::size_t>(axis)] = lattice[static_cast<std::size_t>(axis)];
    Points result = zeros(next);
    each_term(next, now, axis, point_of, [&](Eigen::Index row, Eigen::Index to, double weight) {
      result.row(to) += weight * points.row(row);
    });
    points = std::move(result);
    now = next;
  }
  return points;
}

}  // namespace hwffd
