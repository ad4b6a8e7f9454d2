#pragma once

#include <optional>
#include <vector>

#include "control_grid.hpp"
#include "glu/knots.hpp"
#include "vertex_batch.hpp"

namespace hwffd::glu {

/// What gluFfdVolume gives: one attribute of the model's vertices.
class VolumeAttribute {
 public:
  /// @param places  n x 4: s, t, u and the number of the cell's first control point
  /// @throws GluError if a number is not that of a cell
  VolumeAttribute(GLenum type, std::array<Knots, 3> knots, gl::ControlGrid grid,
                  const std::vector<std::array<float, 4>>& places);

  GLenum type() const { return type_; }
  std::size_t vertices() const { return places_.size(); }
  const gl::ControlGrid& grid() const { return grid_; }

  /// The grid's values at the vertices, in their order; the device is asked once for all vertices
  /// whose cells have the same blending functions.
  gl::ControlGrid::Values evaluate(Device& device, bool derivatives = false) const;

 private:
  Index3 cell_of(float number) const;
  gl::VolumeBlending blending_of(const Index3& cell) const;

  GLenum type_;
  std::array<Knots, 3> knots_;
  gl::ControlGrid grid_;
  std::vector<Embedded> places_;
};

/// What lies between gluBeginVolume and gluEndVolume.
class Volume {
 public:
  void add(VolumeAttribute attribute);
  void set_normals(gl::ControlGrid::Values normals) { normals_ = std::move(normals); }
  void set_elements(std::vector<GLuint> elements) { elements_ = std::move(elements); }

  /// A volume in which a call failed is not drawn.
  void spoil() { spoilt_ = true; }
  bool is_spoilt() const { return spoilt_; }

  /// @throws GluError where something is missing, twice or beyond the vertices
  void check() const;

  /// All attributes on a device, after check().
  /// @param progress  called with 0 to 1 over all of the volume
  gl::VertexBatch evaluate(Device& device, const Progress& progress) const;

  /// The vertices' numbers in the order in which they are drawn.
  std::vector<GLuint> elements() const;

 private:
  const VolumeAttribute* positions() const;
  gl::ControlGrid::Values deformed_normals(Device& device) const;
  double work() const;

  std::vector<VolumeAttribute> attributes_;
  std::optional<gl::ControlGrid::Values> normals_;
  std::optional<std::vector<GLuint>> elements_;
  bool spoilt_ = false;
};

}  // namespace hwffd::glu
