#pragma once

#include <functional>

#include "picture/camera.hpp"
#include "picture/framebuffer.hpp"
#include "picture/image.hpp"
#include "picture/offscreen_context.hpp"

namespace hwffd::picture {

/// A studio without a screen: context, framebuffer, a light background and two lights that move
/// with the camera, a strong one above to the left and a weak one to the right. Both sides of a
/// surface are lit.
class Renderer {
 public:
  /// @param width, height  of the pictures, in pixels
  /// @throws Error as OffscreenContext and Framebuffer do
  Renderer(int width, int height);
  ~Renderer();

  /// Width by height.
  double aspect() const;

  /// A picture of what `draw` issues to the context, in object space: draw_mesh(), draw_lattice(),
  /// or any calls of OpenGL. Colours are those of glColor, normals are normalized; state that
  /// `draw` changes is put back.
  /// @throws Error for an error of OpenGL, and what `draw` throws
  Image render(const Camera& camera, const std::function<void()>& draw) const;

 private:
  OffscreenContext context_;
  Framebuffer framebuffer_;
};

}  // namespace hwffd::picture
