#pragma once

#include "picture/image.hpp"

namespace hwffd::picture {

/// Where a picture is drawn: colour and depth of the current context, each pixel drawn as 2 x 2
/// pixels with as many samples as OpenGL has, four at most. It belongs to the context that was
/// current when it was made, which must be current again for every call and when it goes.
class Framebuffer {
 public:
  /// @param width, height  of the picture that read() returns
  /// @throws Error for a size below 1 or beyond what OpenGL has room for
  Framebuffer(int width, int height);
  Framebuffer(const Framebuffer&) = delete;
  Framebuffer& operator=(const Framebuffer&) = delete;
  ~Framebuffer();

  int width() const { return width_; }
  int height() const { return height_; }

  /// What is drawn from now on goes here; the viewport is all of it.
  void bind() const;

  /// The picture as drawn so far.
  Image read() const;

 private:
  static constexpr int kScale = 2;

  int width_;
  int height_;
  unsigned samples_[3] = {0, 0, 0};  ///< framebuffer, colour, depth
  unsigned resolved_[2] = {0, 0};    ///< framebuffer, colour, one sample a pixel
};

}  // namespace hwffd::picture
