// glMap3 and what asks for its maps and switches them.

#include <cmath>

#include "gl_error.hpp"
#include "hwffd/glffd.h"
#include "state.hpp"

namespace hwffd::gl {
namespace {

/// The arguments of glMap3 that an axis has.
struct AxisArguments {
  double first;
  double last;
  GLint stride;
  GLint order;
};

bool evaluators_are_on_unit_zero() {
  GLint unit = GL_TEXTURE0;
  glGetIntegerv(GL_ACTIVE_TEXTURE, &unit);
  return unit == GL_TEXTURE0;
}

/// Raises what glMap2 raises, in its order: domain, order, target, stride, texture unit.
bool map_is_valid(GLenum target, const std::array<AxisArguments, 3>& axes, const void* points) {
  if (!outside_begin_end()) return false;
  bool values_are_valid = true;
  for (const AxisArguments& axis : axes) {
    values_are_valid &= axis.first != axis.last && axis.order >= 1 && axis.order <= kMaxOrder;
  }
  if (!values_are_valid) return raise_invalid_value(), false;
  const std::optional<int> number = map_number(target);
  if (!number) return raise_invalid_enum(), false;
  for (const AxisArguments& axis : axes) values_are_valid &= axis.stride >= kComponents[*number];
  if (!values_are_valid) return raise_invalid_value(), false;
  if (!evaluators_are_on_unit_zero()) return raise_invalid_operation(), false;
  if (points == nullptr) return raise_invalid_value(), false;
  return true;
}

template <class Real>
void map3(GLenum target, const std::array<AxisArguments, 3>& axes, const Real* points) {
  if (!map_is_valid(target, axes, points)) return;
  guarded([&] {
    const int number = *map_number(target);
    Map3& map = State::current().maps[number];
    map.grid = ControlGrid({axes[0].order, axes[1].order, axes[2].order}, kComponents[number],
                           {axes[0].stride, axes[1].stride, axes[2].stride}, points);
    for (int axis = 0; axis < 3; ++axis) {
      map.domain[2 * axis] = axes[axis].first;
      map.domain[2 * axis + 1] = axes[axis].last;
    }
  });
}

template <class Number>
Number rounded(double value) {
  return std::is_integral_v<Number> ? static_cast<Number>(std::lround(value))
                                    : static_cast<Number>(value);
}

template <class Number>
void get_map3(GLenum target, GLenum query, Number* v) {
  if (!outside_begin_end()) return;
  const std::optional<int> number = map_number(target);
  if (!number) return raise_invalid_enum();
  const Map3& map = State::current().maps[*number];
  switch (query) {
    case GL_COEFF:
      for (const double value : map.grid.values()) *v++ = rounded<Number>(value);
      return;
    case GL_ORDER:
      for (const int points : map.grid.points()) *v++ = static_cast<Number>(points);
      return;
    case GL_DOMAIN:
      for (const double bound : map.domain) *v++ = rounded<Number>(bound);
      return;
    default:
      raise_invalid_enum();
  }
}

void switch_map3(GLenum cap, bool on) {
  if (!outside_begin_end()) return;
  State& state = State::current();
  if (cap == GL_AUTO_NORMAL) {
    state.auto_normal = on;
    return;
  }
  const std::optional<int> number = map_number(cap);
  if (!number) return raise_invalid_enum();
  state.enabled.set(*number, on);
}

}  // namespace
}  // namespace hwffd::gl

using namespace hwffd::gl;

void glMap3f(GLenum target, GLfloat u1, GLfloat u2, GLint ustride, GLint uorder, GLfloat v1,
             GLfloat v2, GLint vstride, GLint vorder, GLfloat w1, GLfloat w2, GLint wstride,
             GLint worder, const GLfloat* points) {
  map3(target, {{{u1, u2, ustride, uorder}, {v1, v2, vstride, vorder}, {w1, w2, wstride, worder}}},
       points);
}

void glMap3d(GLenum target, GLdouble u1, GLdouble u2, GLint ustride, GLint uorder, GLdouble v1,
             GLdouble v2, GLint vstride, GLint vorder, GLdouble w1, GLdouble w2, GLint wstride,
             GLint worder, const GLdouble* points) {
  map3(target, {{{u1, u2, ustride, uorder}, {v1, v2, vstride, vorder}, {w1, w2, wstride, worder}}},
       points);
}

void glGetMap3dv(GLenum target, GLenum query, GLdouble* v) { get_map3(target, query, v); }
void glGetMap3fv(GLenum target, GLenum query, GLfloat* v) { get_map3(target, query, v); }
void glGetMap3iv(GLenum target, GLenum query, GLint* v) { get_map3(target, query, v); }

void glEnableMap3(GLenum cap) { switch_map3(cap, true); }
void glDisableMap3(GLenum cap) { switch_map3(cap, false); }

GLboolean glIsEnabledMap3(GLenum cap) {
  if (!outside_begin_end()) return GL_FALSE;
  const State& state = State::current();
  if (cap == GL_AUTO_NORMAL) return state.auto_normal ? GL_TRUE : GL_FALSE;
  const std::optional<int> number = map_number(cap);
  if (!number) return raise_invalid_enum(), GLboolean{GL_FALSE};
  return state.enabled.test(*number) ? GL_TRUE : GL_FALSE;
}
