#include "control_grid.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "weighted_sum.hpp"

namespace hwffd::gl {
namespace {

/// Derivative of X / w, but for a positive factor, for a position of four components.
Eigen::Vector3d projected(const Eigen::Vector4d& slope, const Eigen::Vector4d& position) {
  return slope.head<3>() * position[3] - position.head<3>() * slope[3];
}

Device::Blending functions_of(const VolumeBlending& blending) {
  return {blending[0].coefficients(), blending[1].coefficients(), blending[2].coefficients()};
}

}  // namespace

ControlGrid::ControlGrid(const Index3& points, int components)
    : points_(points),
      components_(components),
      values_(static_cast<std::size_t>(points[0]) * points[1] * points[2] * components) {}

Embedded ControlGrid::place(const Eigen::Vector3d& position, const VolumeBlending& blending) const {
  Embedded at;
  at.inside = true;
  for (int axis = 0; axis < 3; ++axis) {
    const int cells = blending[axis].cells(points_[axis]);
    // So written, a coordinate that is not a number is 0.
    const double along = position[axis] > 0 ? std::min(position[axis], 1.0) * cells : 0.0;
    at.cell[axis] = std::min(static_cast<int>(along), cells - 1);
    at.local[axis] = along - at.cell[axis];
  }
  return at;
}

Lattice ControlGrid::lattice(int first_component, const VolumeBlending& blending) const {
  Index3 dims;
  for (int axis = 0; axis < 3; ++axis) {
    dims[axis] = blending[axis].cells(points_[axis]) + AxisBlending::kMaxDegree;
  }
  const int count = std::min(3, components_ - first_component);
  Points points = Points::Zero(static_cast<Eigen::Index>(dims[0]) * dims[1] * dims[2], 3);
  Eigen::Index row = 0;
  for (int i = 0; i < dims[0]; ++i) {
    for (int j = 0; j < dims[1]; ++j) {
      for (int k = 0; k < dims[2]; ++k, ++row) {
        // Points beyond the grid repeat its last ones; functions of lower degree do not see them.
        const Index3 from{std::min(i, points_[0] - 1), std::min(j, points_[1] - 1),
                          std::min(k, points_[2] - 1)};
        const std::size_t point =
            (static_cast<std::size_t>(from[0]) * points_[1] + from[1]) * points_[2] + from[2];
        for (int c = 0; c < count; ++c) {
          points(row, c) = values_[point * components_ + first_component + c];
        }
      }
    }
  }
  return Lattice(dims, std::move(points));
}

ControlGrid::Values ControlGrid::evaluate(Device& device, const std::vector<Embedded>& vertices,
                                          const VolumeBlending& blending, bool derivatives) const {
  const auto rows = static_cast<Eigen::Index>(vertices.size());
  Values values(rows, columns(derivatives));
  for (int first = 0; first < components_; first += 3) {
    const int count = std::min(3, components_ - first);
    const Device::Tangents part = weighted_sums(device, lattice(first, blending), vertices,
                                                functions_of(blending), derivatives);
    values.middleCols(first, count) = part.positions.leftCols(count);
    for (Eigen::Index v = 0; derivatives && v < rows; ++v) {
      const Eigen::Matrix3d& jacobian = part.jacobians[static_cast<std::size_t>(v)];
      for (int axis = 0; axis < 3; ++axis) {
        values.row(v).segment((axis + 1) * components_ + first, count) =
            jacobian.col(axis).head(count).transpose();
      }
    }
  }
  return values;
}

ControlGrid::Values ControlGrid::sheet_normals(Device& device,
                                               const std::vector<Embedded>& vertices,
                                               const VolumeBlending& blending) const {
  const Values all = evaluate(device, vertices, blending, true);
  Values normals(all.rows(), 3);
  for (Eigen::Index v = 0; v < normals.rows(); ++v) {
    const auto part = [&](int number, double weight) {
      Eigen::Vector4d four(0, 0, 0, weight);
      four.head(components_) = all.row(v).segment(number * components_, components_);
      return four;
    };
    const Eigen::Vector4d position = part(0, 1);
    const Eigen::Vector3d normal =
        projected(part(1, 0), position).cross(projected(part(2, 0), position));
    normals.row(v) = normal.norm() > 0 ? Eigen::Vector3d(normal.normalized()) : normal;
  }
  return normals;
}

}  // namespace hwffd::gl
