#include "picture/renderer.hpp"

#include <fmt/format.h>

#include "hwffd/error.hpp"
#include "picture/opengl.hpp"
#include "picture/studio.hpp"

namespace hwffd::picture {

Renderer::Renderer(int width, int height) : framebuffer_(width, height) {}

Renderer::~Renderer() { context_.make_current(); }  // whose framebuffer now goes

double Renderer::aspect() const {
  return static_cast<double>(framebuffer_.width()) / framebuffer_.height();
}

Image Renderer::render(const Camera& camera, const std::function<void()>& draw) const {
  context_.make_current();
  framebuffer_.bind();
  draw_studio(camera, aspect(), draw);
  Image image = framebuffer_.read();
  const GLenum error = glGetError();
  if (error != GL_NO_ERROR) {
    throw Error(
        fmt::format("a picture's drawing raised OpenGL error 0x{:04X}; mend its calls", error));
  }
  return image;
}

}  // namespace hwffd::picture
