#include "gl_error.hpp"

#include <exception>

#include "opengl.hpp"

namespace hwffd::gl {

void raise_invalid_value() { glGenLists(-1); }

void raise_invalid_enum() {
  GLint result = 0;
  glGetIntegerv(GL_NONE, &result);
}

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
