#include "picture/framebuffer.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "hwffd/error.hpp"
#include "picture/opengl.hpp"

namespace hwffd::picture {
namespace {

constexpr int kMostSamples = 4;

int limit(GLenum name) {
  GLint value = 0;
  glGetIntegerv(name, &value);
  return value;
}

void attach(GLenum place, unsigned buffer, int samples, GLenum format, int width, int height) {
  glBindRenderbuffer(GL_RENDERBUFFER, buffer);
  glRenderbufferStorageMultisample(GL_RENDERBUFFER, samples, format, width, height);
  glFramebufferRenderbuffer(GL_FRAMEBUFFER, place, GL_RENDERBUFFER, buffer);
}

}  // namespace

Framebuffer::Framebuffer(int width, int height) : width_(width), height_(height) {
  const int most = limit(GL_MAX_RENDERBUFFER_SIZE) / kScale;
  if (std::min(width, height) < 1 || std::max(width, height) > most) {
    throw Error(fmt::format("picture of {}x{} pixels: give 1 to {} a side", width, height, most));
  }
  const int samples = std::min(limit(GL_MAX_SAMPLES), kMostSamples);
  const int wide = kScale * width;
  const int high = kScale * height;
  glGenFramebuffers(1, &samples_[0]);
  glGenRenderbuffers(2, &samples_[1]);
  glBindFramebuffer(GL_FRAMEBUFFER, samples_[0]);
  attach(GL_COLOR_ATTACHMENT0, samples_[1], samples, GL_RGBA8, wide, high);
  attach(GL_DEPTH_ATTACHMENT, samples_[2], samples, GL_DEPTH_COMPONENT24, wide, high);
  const GLenum drawn = glCheckFramebufferStatus(GL_FRAMEBUFFER);
  glGenFramebuffers(1, &resolved_[0]);
  glGenRenderbuffers(1, &resolved_[1]);
  glBindFramebuffer(GL_FRAMEBUFFER, resolved_[0]);
  attach(GL_COLOR_ATTACHMENT0, resolved_[1], 0, GL_RGBA8, wide, high);
  const GLenum read = glCheckFramebufferStatus(GL_FRAMEBUFFER);
  if (drawn == GL_FRAMEBUFFER_COMPLETE && read == GL_FRAMEBUFFER_COMPLETE) return;
  throw Error(fmt::format("picture of {}x{} pixels: OpenGL has no room for it; make it smaller",
                          width, height));
}

Framebuffer::~Framebuffer() {
  glDeleteFramebuffers(1, &samples_[0]);
  glDeleteRenderbuffers(2, &samples_[1]);
  glDeleteFramebuffers(1, &resolved_[0]);
  glDeleteRenderbuffers(1, &resolved_[1]);
}

void Framebuffer::bind() const {
  glBindFramebuffer(GL_FRAMEBUFFER, samples_[0]);
  glViewport(0, 0, kScale * width_, kScale * height_);
}

Image Framebuffer::read() const {
  const int wide = kScale * width_;
  const int high = kScale * height_;
  glBindFramebuffer(GL_READ_FRAMEBUFFER, samples_[0]);
  glBindFramebuffer(GL_DRAW_FRAMEBUFFER, resolved_[0]);
  glBlitFramebuffer(0, 0, wide, high, 0, 0, wide, high, GL_COLOR_BUFFER_BIT, GL_NEAREST);
  glBindFramebuffer(GL_READ_FRAMEBUFFER, resolved_[0]);
  Image image{wide, high,
              std::vector<Pixel>(static_cast<std::size_t>(wide) * static_cast<std::size_t>(high))};
  glPixelStorei(GL_PACK_ALIGNMENT, 1);
  glReadPixels(0, 0, wide, high, GL_RGB, GL_UNSIGNED_BYTE, image.pixels.data());
  // OpenGL's first row is the lowest.
  for (int y = 0; y < high / 2; ++y) {
    const auto row = image.pixels.begin() + static_cast<std::ptrdiff_t>(y) * wide;
    std::swap_ranges(row, row + wide,
                     image.pixels.end() - static_cast<std::ptrdiff_t>(y + 1) * wide);
  }
  return halved(image);
}

}  // namespace hwffd::picture
