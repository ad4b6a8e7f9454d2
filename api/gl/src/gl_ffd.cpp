// glFFD: an interleaved stream straight to the device. glFfdDevice: which device that is.

#include <algorithm>
#include <cmath>

#include "gl_error.hpp"
#include "hwffd/glffd.h"
#include "state.hpp"
#include "vertex_batch.hpp"

namespace hwffd::gl {
namespace {

constexpr int kSupportPoints = 64;

template <class Real>
std::vector<SupportedVertex> read_stream(const Real* stream, std::size_t count) {
  std::vector<SupportedVertex> vertices(count);
  for (SupportedVertex& vertex : vertices) {
    for (int axis = 0; axis < 3; ++axis) {
      const auto given = static_cast<double>(*stream++);
      // What is not finite stays so, for the device to refuse.
      vertex.local[axis] = std::isfinite(given) ? std::clamp(given, 0.0, 1.0) : given;
    }
    for (int point = 0; point < kSupportPoints; ++point) {
      for (int c = 0; c < 3; ++c) vertex.support(point, c) = static_cast<double>(*stream++);
    }
  }
  return vertices;
}

void draw_stream(GLenum mode, const std::vector<SupportedVertex>& vertices) {
  State& state = State::current();
  // The stream has four points an axis, whatever the degree; those of cubics are all seen.
  const VolumeBlending functions = state.blending_of(ControlGrid({4, 4, 4}, 3));
  VertexBatch batch;
  batch.vertex = VertexBatch::Attribute(state.device().evaluate(
      vertices,
      {functions[0].coefficients(), functions[1].coefficients(), functions[2].coefficients()}));
  std::vector<GLuint> order;
  for (std::size_t v = 0; v < vertices.size(); ++v) order.push_back(static_cast<GLuint>(v));
  batch.draw(mode, {order});
}

}  // namespace
}  // namespace hwffd::gl

using namespace hwffd::gl;

void glFFD(GLenum mode, GLsizei count, GLenum type, const GLvoid* stream) {
  if (!outside_begin_end()) return;
  if (count < 0) return raise_invalid_value();
  if (mode > GL_POLYGON || (type != GL_FLOAT && type != GL_DOUBLE)) return raise_invalid_enum();
  if (stream == nullptr) return raise_invalid_value();
  guarded([&] {
    const auto vertices = static_cast<std::size_t>(count);
    draw_stream(mode, type == GL_FLOAT
                          ? read_stream(static_cast<const GLfloat*>(stream), vertices)
                          : read_stream(static_cast<const GLdouble*>(stream), vertices));
  });
}

void glFfdDevice(const char* name) {
  if (!outside_begin_end()) return;
  try {
    State::current().choose_device(name == nullptr ? std::nullopt
                                                   : std::optional<std::string>(name));
  } catch (const std::exception&) {
    raise_invalid_value();
  }
}
