#pragma once

#include <optional>
#include <string>
#include <vector>

#include "hwffd/lattice/lattice.hpp"
#include "hwffd/mesh/mesh.hpp"
#include "picture/renderer.hpp"

namespace hwffd::picture {

/// A picture of a mesh in its lattice before and, beside it, after the deformation, both seen by
/// one camera.
class BeforeAfter {
 public:
  /// @param before, after  the lattices, which the camera has in its picture
  BeforeAfter(const Lattice& before, const Lattice& after);

  /// Why there will be no picture: OpenGL is not there. Empty where it is.
  const std::string& missing() const { return missing_; }

  /// Draws the next half: a mesh as it is now, in its lattice. Without OpenGL nothing.
  void draw(const Mesh& mesh, const Lattice& lattice);

  /// Both halves, once they are drawn.
  Image image() const { return strip(halves_); }

 private:
  std::string missing_;
  std::optional<Renderer> renderer_;
  Camera camera_;
  std::vector<Image> halves_;
};

}  // namespace hwffd::picture
