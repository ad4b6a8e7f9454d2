#include "picture/offscreen_context.hpp"

#include <EGL/egl.h>
#include <EGL/eglext.h>
#include <fmt/format.h>

#include "hwffd/error.hpp"

namespace hwffd::picture {
namespace {

[[noreturn]] void fail(const char* step) {
  throw Error(
      fmt::format("no OpenGL without a display here ({}: EGL error 0x{:04X}); install the packages "
                  "libegl1 and libgl1-mesa-dri",
                  step, eglGetError()));
}

/// A process has one display of a platform, and terminating it would end every context on it; so it
/// stays until the process ends.
EGLDisplay open_display() {
  const EGLDisplay display =
      eglGetPlatformDisplay(EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY, nullptr);
  if (display == EGL_NO_DISPLAY) fail("eglGetPlatformDisplay");
  if (eglInitialize(display, nullptr, nullptr) == EGL_FALSE) fail("eglInitialize");
  return display;
}

EGLContext create_context(EGLDisplay display) {
  if (eglBindAPI(EGL_OPENGL_API) == EGL_FALSE) fail("eglBindAPI");
  const EGLint wanted[] = {EGL_SURFACE_TYPE, EGL_PBUFFER_BIT, EGL_RENDERABLE_TYPE, EGL_OPENGL_BIT,
                           EGL_NONE};
  EGLConfig config = nullptr;
  EGLint config_count = 0;
  if (eglChooseConfig(display, wanted, &config, 1, &config_count) == EGL_FALSE ||
      config_count == 0) {
    fail("eglChooseConfig");
  }
  const EGLint profile[] = {EGL_CONTEXT_OPENGL_PROFILE_MASK,
                            EGL_CONTEXT_OPENGL_COMPATIBILITY_PROFILE_BIT, EGL_NONE};
  const EGLContext context = eglCreateContext(display, config, EGL_NO_CONTEXT, profile);
  if (context == EGL_NO_CONTEXT) fail("eglCreateContext");
  return context;
}

}  // namespace

OffscreenContext::OffscreenContext()
    : display_(open_display()), context_(create_context(display_)) {
  make_current();
}

OffscreenContext::~OffscreenContext() {
  if (eglGetCurrentContext() == context_) {
    eglMakeCurrent(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
  }
  eglDestroyContext(display_, context_);
}

void OffscreenContext::make_current() const {
  if (eglMakeCurrent(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, context_) == EGL_FALSE) {
    fail("eglMakeCurrent");
  }
}

}  // namespace hwffd::picture
