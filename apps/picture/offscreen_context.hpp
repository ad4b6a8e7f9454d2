#pragma once

namespace hwffd::picture {

/// An OpenGL context without display, window or screen (EGL, platform "surfaceless" of Mesa). It is
/// of the compatibility profile: fixed function, display lists and evaluators are there. There is
/// no default framebuffer to draw to, see Framebuffer.
class OffscreenContext {
 public:
  /// Creates the context and makes it current.
  /// @throws Error, which names the packages, where EGL or its drivers are missing
  OffscreenContext();
  OffscreenContext(const OffscreenContext&) = delete;
  OffscreenContext& operator=(const OffscreenContext&) = delete;
  ~OffscreenContext();

  /// Makes it the calling thread's current context.
  /// @throws Error if it is another thread's
  void make_current() const;

 private:
  void* display_;  ///< EGLDisplay; EGL's headers drag in those of X
  void* context_;  ///< EGLContext
};

}  // namespace hwffd::picture
