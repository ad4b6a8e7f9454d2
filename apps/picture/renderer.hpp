#pragma once

#include <functional>

#include "picture/camera.hpp"
#include "picture/framebuffer.hpp"
#include "picture/image.hpp"
#include "picture/offscreen_context.hpp"

namespace hwffd::picture {

/// A studio (draw_studio()) without a screen: context and framebuffer.
class Renderer {
 public:
  /// @param width, height  of the pictures, in pixels
  /// @throws Error as OffscreenContext and Framebuffer do
  Renderer(int width, int height);
  ~Renderer();

  /// Width by height.
  double aspect() const;

  /// A picture of what `draw` issues to the context, as draw_studio() shows it: draw_mesh(),
  /// draw_lattice(), or any calls of OpenGL.
  /// @throws Error for an error of OpenGL, and what `draw` throws
  Image render(const Camera& camera, const std::function<void()>& draw) const;

 private:
  OffscreenContext context_;
  Framebuffer framebuffer_;
};

}  // namespace hwffd::picture
