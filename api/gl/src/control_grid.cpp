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
                                          const VolumeBlending& blending) const {
  Values values(static_cast<Eigen::Index>(vertices.size()), components_);
  for (int first = 0; first < components_; first += 3) {
    const int count = std::min(3, components_ - first);
    const Points sums =
        weighted_sums(device, lattice(first, blending), vertices, functions_of(blending));
    values.middleCols(first, count) = sums.leftCols(count);
  }
  return values;
}

ControlGrid::Slopes ControlGrid::slopes(Device& device, const std::vector<Embedded>& vertices,
                                        const VolumeBlending& blending) const {
  const auto rows = static_cast<Eigen::Index>(vertices.size());
  Slopes slopes{Values(rows, components_), {}};
  slopes.along.fill(Values(rows, components_));
  for (int first = 0; first < components_; first += 3) {
    const int count = std::min(3, components_ - first);
    const Device::Tangents part =
        weighted_tangents(device, lattice(first, blending), vertices, functions_of(blending));
    slopes.value.middleCols(first, count) = part.positions.leftCols(count);
    for (Eigen::Index v = 0; v < rows; ++v) {
      const Eigen::Matrix3d& jacobian = part.jacobians[static_cast<std::size_t>(v)];
      for (int axis = 0; axis < 3; ++axis) {
        slopes.along[axis].row(v).segment(first, count) =
            jacobian.col(axis).head(count).transpose();
      }
    }
  }
  return slopes;
}

ControlGrid::Values ControlGrid::derivatives(Device& device, const std::vector<Embedded>& vertices,
                                             const VolumeBlending& blending) const {
  const Slopes all = slopes(device, vertices, blending);
  Values columns(static_cast<Eigen::Index>(vertices.size()), 9);
  for (int axis = 0; axis < 3; ++axis) {
    columns.middleCols<3>(3 * axis) = all.along[axis].leftCols<3>();
  }
  return columns;
}

ControlGrid::Values ControlGrid::sheet_normals(Device& device,
                                               const std::vector<Embedded>& vertices,
                                               const VolumeBlending& blending) const {
  const Slopes all = slopes(device, vertices, blending);
  Values normals(all.value.rows(), 3);
  for (Eigen::Index v = 0; v < normals.rows(); ++v) {
    Eigen::Vector3d du = all.along[0].row(v).head<3>();
    Eigen::Vector3d dv = all.along[1].row(v).head<3>();
    if (components_ == 4) {
      du = projected(all.along[0].row(v), all.value.row(v));
      dv = projected(all.along[1].row(v), all.value.row(v));
    }
    const Eigen::Vector3d normal = du.cross(dv);
    normals.row(v) = normal.norm() > 0 ? Eigen::Vector3d(normal.normalized()) : normal;
  }
  return normals;
}

}  // namespace hwffd::gl
