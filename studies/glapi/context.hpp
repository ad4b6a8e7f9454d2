#pragma once

#include <functional>
#include <vector>

#include "hwffd/points.hpp"

namespace hwffd::glapi {

/// A compatibility context without a display (EGL, platform "surfaceless" of Mesa), with a buffer
/// of 64 x 64 pixels to draw to; current as long as it lives.
class Context {
 public:
  /// @throws Error, which names the packages, where EGL or its drivers are missing
  Context();
  Context(const Context&) = delete;
  Context& operator=(const Context&) = delete;
  ~Context();

 private:
  void* display_;  ///< EGLDisplay; EGL's headers drag in those of X
  void* surface_;
  void* context_;
};

/// What a vertex is when it reaches the rasterizer: in feedback mode, under identity transforms.
struct Seen {
  Point position;           ///< in the cube from -1 to 1
  Eigen::Vector4d color;    ///< 0 to 1
  Eigen::Vector4d texture;  ///< s, t, r, q
};

/// The vertices that `draw` issues, in their order, seen through feedback mode.
std::vector<Seen> seen(const std::function<void()>& draw);

/// The same, with the normal in the place of the texture coordinates.
std::vector<Seen> seen_normals(const std::function<void()>& draw);

/// What glGetError says after `call`, and nothing of what it said before.
unsigned error_of(const std::function<void()>& call);

}  // namespace hwffd::glapi
