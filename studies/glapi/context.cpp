#include "context.hpp"

#define EGL_NO_X11
#include <EGL/egl.h>
#include <EGL/eglext.h>
#include <GL/gl.h>
#include <fmt/format.h>

#include "hwffd/error.hpp"

namespace hwffd::glapi {
namespace {

constexpr int kSize = 64;  // pixels

template <class Handle>
Handle checked(const char* step, Handle handle) {
  if (handle) return handle;
  throw Error(
      fmt::format("no OpenGL without a display here ({}: EGL error 0x{:04X}); install the packages "
                  "libegl1 and libgl1-mesa-dri",
                  step, eglGetError()));
}

EGLConfig choose_config(EGLDisplay display) {
  const EGLint wanted[] = {EGL_SURFACE_TYPE, EGL_PBUFFER_BIT, EGL_RENDERABLE_TYPE, EGL_OPENGL_BIT,
                           EGL_NONE};
  EGLConfig config = nullptr;
  EGLint found = 0;
  checked("eglChooseConfig", eglChooseConfig(display, wanted, &config, 1, &found));
  return checked("eglChooseConfig", found > 0 ? config : nullptr);
}

/// Vertices of a feedback buffer of GL_3D_COLOR_TEXTURE: x, y, z, colour, texture coordinates.
std::vector<Seen> vertices_of(const std::vector<GLfloat>& buffer, std::size_t used) {
  std::vector<Seen> vertices;
  std::size_t at = 0;
  while (at < used) {
    const auto token = static_cast<GLenum>(buffer[at++]);
    std::size_t count = token == GL_POINT_TOKEN ? 1 : 2;  // a point or a line
    if (token == GL_POLYGON_TOKEN) count = static_cast<std::size_t>(buffer[at++]);
    for (; count > 0; --count, at += 11) {
      const GLfloat* v = &buffer[at];
      vertices.push_back({Point(v[0] * 2 / kSize - 1, v[1] * 2 / kSize - 1, v[2] * 2 - 1),
                          {v[3], v[4], v[5], v[6]},
                          {v[7], v[8], v[9], v[10]}});
    }
  }
  return vertices;
}

}  // namespace

Context::Context() {
  display_ = checked("eglGetPlatformDisplay", eglGetPlatformDisplay(EGL_PLATFORM_SURFACELESS_MESA,
                                                                    EGL_DEFAULT_DISPLAY, nullptr));
  checked("eglInitialize", eglInitialize(display_, nullptr, nullptr));
  checked("eglBindAPI", eglBindAPI(EGL_OPENGL_API));
  const EGLConfig config = choose_config(display_);
  const EGLint size[] = {EGL_WIDTH, kSize, EGL_HEIGHT, kSize, EGL_NONE};
  surface_ = checked("eglCreatePbufferSurface", eglCreatePbufferSurface(display_, config, size));
  context_ = checked("eglCreateContext", eglCreateContext(display_, config, nullptr, nullptr));
  checked("eglMakeCurrent", eglMakeCurrent(display_, surface_, surface_, context_));
}

Context::~Context() {
  eglMakeCurrent(display_, nullptr, nullptr, nullptr);
  eglDestroyContext(display_, context_);
  eglDestroySurface(display_, surface_);
}

std::vector<Seen> seen(const std::function<void()>& draw) {
  std::vector<GLfloat> buffer(1 << 20);
  glFeedbackBuffer(static_cast<GLsizei>(buffer.size()), GL_3D_COLOR_TEXTURE, buffer.data());
  glRenderMode(GL_FEEDBACK);
  draw();
  const GLint used = glRenderMode(GL_RENDER);
  if (used < 0) throw Error("more vertices than the feedback buffer holds; draw fewer");
  return vertices_of(buffer, static_cast<std::size_t>(used));
}

std::vector<Seen> seen_normals(const std::function<void()>& draw) {
  glPushAttrib(GL_TEXTURE_BIT | GL_ENABLE_BIT);
  for (const GLenum axis : {GL_S, GL_T, GL_R}) {
    constexpr GLint kNormalMap = 0x8511;  // GL_NORMAL_MAP
    glTexGeni(axis, GL_TEXTURE_GEN_MODE, kNormalMap);
    glEnable(GL_TEXTURE_GEN_S + (axis - GL_S));
  }
  // Coordinates are generated only for a texture that is there.
  const GLubyte texel[4] = {255, 255, 255, 255};
  glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA, 1, 1, 0, GL_RGBA, GL_UNSIGNED_BYTE, texel);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
  glEnable(GL_TEXTURE_2D);
  std::vector<Seen> vertices = seen(draw);
  glPopAttrib();
  return vertices;
}

unsigned error_of(const std::function<void()>& call) {
  while (glGetError() != GL_NO_ERROR) {
  }
  call();
  return glGetError();
}

}  // namespace hwffd::glapi
