#pragma once

#include <vector>

#include "axis_blending.hpp"

namespace hwffd::gl {

/// Control points of 1 to 4 components each, as glMap3 and gluFfdVolume take them.
class ControlGrid {
 public:
  /// One value a vertex and component, n x components.
  using Values = Eigen::MatrixXd;

  /// All components of all points are zero.
  /// @param points  along the three axes
  ControlGrid(const Index3& points, int components);

  /// Reads point (i, j, k) from from[i * strides[0] + j * strides[1] + k * strides[2]] on.
  template <class Real>
  ControlGrid(const Index3& points, int components, const Index3& strides, const Real* from);

  const Index3& points() const { return points_; }
  int components() const { return components_; }

  /// Component c of point (i, j, k) at ((i * points[1] + j) * points[2] + k) * components + c.
  std::vector<double>& values() { return values_; }
  const std::vector<double>& values() const { return values_; }

  /// Where the axes' blending functions put a point of the whole grid.
  /// @param position  0 to 1 along each axis, from the first cell to the last; clamped
  Embedded place(const Eigen::Vector3d& position, const VolumeBlending& blending) const;

  /// Passes over a device that `evaluate` makes: it evaluates three components at once.
  int passes() const { return (components_ + 2) / 3; }

  /// Columns of what `evaluate` gives.
  int columns(bool derivatives) const { return components_ * (derivatives ? 4 : 1); }

  /// @param vertices  cell, and coordinates in it from 0 to 1; others are clamped, as by hardware
  /// @param derivatives  whether those along the axes of the cell are wanted, too: after the values
  ///   that along the first axis, that along the second, that along the third
  /// @throws Error, and what Device::evaluate throws
  Values evaluate(Device& device, const std::vector<Embedded>& vertices,
                  const VolumeBlending& blending, bool derivatives = false) const;

  /// Normals of the sheets w = constant of a position with 3 or 4 components: d/du x d/dv of the
  /// position, along the axes of the cell, of length 1 as OpenGL's evaluators make them; 0 where
  /// there is none.
  Values sheet_normals(Device& device, const std::vector<Embedded>& vertices,
                       const VolumeBlending& blending) const;

 private:
  Lattice lattice(int first_component, const VolumeBlending& blending) const;

  Index3 points_;
  int components_;
  std::vector<double> values_;
};

template <class Real>
ControlGrid::ControlGrid(const Index3& points, int components, const Index3& strides,
                         const Real* from)
    : ControlGrid(points, components) {
  std::size_t to = 0;
  for (std::ptrdiff_t i = 0; i < points[0]; ++i) {
    for (std::ptrdiff_t j = 0; j < points[1]; ++j) {
      for (std::ptrdiff_t k = 0; k < points[2]; ++k) {
        const Real* point = from + i * strides[0] + j * strides[1] + k * strides[2];
        for (int c = 0; c < components; ++c) values_[to++] = static_cast<double>(point[c]);
      }
    }
  }
}

}  // namespace hwffd::gl
