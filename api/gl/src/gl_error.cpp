#include "gl_error.hpp"

#include <exception>

#include "opengl.hpp"

namespace hwffd::gl {
namespace {

constexpr GLdouble kPoint[3] = {0, 0, 0};

void map2(GLenum target, GLdouble u1, GLdouble u2) {
  glMap2d(target, u1, u2, 3, 1, 0, 1, 3, 1, kPoint);
}

}  // namespace

void raise_invalid_value() { map2(GL_MAP2_VERTEX_3, 0, 0); }

void raise_invalid_enum() { map2(GL_NONE, 0, 1); }

void raise_invalid_operation() {
  // Zero is never the name of a query.
  GLint result = 0;
  glGetQueryObjectiv(0, GL_QUERY_RESULT, &result);
}

bool outside_begin_end() {
  GLint order = 0;
  glGetIntegerv(GL_MAX_EVAL_ORDER, &order);
  return order > 0;
}

void guarded(const std::function<void()>& body) {
  try {
    body();
  } catch (const std::exception&) {
    raise_invalid_operation();
  }
}

}  // namespace hwffd::gl
