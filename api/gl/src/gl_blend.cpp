// glBlendCoefficient: the blending functions of an axis.

#include <cmath>

#include "gl_error.hpp"
#include "hwffd/glffd.h"
#include "state.hpp"

namespace hwffd::gl {
namespace {

std::optional<int> axis_number(GLenum axis) {
  if (axis < GL_MAP3_U || axis > GL_MAP3_W) return std::nullopt;
  return static_cast<int>(axis - GL_MAP3_U);
}

template <class Real>
void blend_coefficient(GLenum axis, GLint degree, const Real* coefficients) {
  if (!outside_begin_end()) return;
  const std::optional<int> number = axis_number(axis);
  if (!number) return raise_invalid_enum();
  std::optional<AxisBlending>& blending = State::current().blending[*number];
  if (coefficients == nullptr) {
    blending.reset();
    return;
  }
  if (degree < 0 || degree > AxisBlending::kMaxDegree) return raise_invalid_value();
  hwffd::Oracle::Coefficients functions = hwffd::Oracle::Coefficients::Zero();
  for (int function = 0; function <= degree; ++function) {
    for (int power = 0; power <= degree; ++power) {
      functions(function, power) = static_cast<double>(*coefficients++);
    }
  }
  if (!functions.allFinite()) return raise_invalid_value();
  blending.emplace(degree, functions);
}

}  // namespace
}  // namespace hwffd::gl

using namespace hwffd::gl;

void glBlendCoefficientf(GLenum axis, GLint degree, const GLfloat* coefficients) {
  blend_coefficient(axis, degree, coefficients);
}

void glBlendCoefficientd(GLenum axis, GLint degree, const GLdouble* coefficients) {
  blend_coefficient(axis, degree, coefficients);
}

void glGetBlendCoefficientdv(GLenum axis, GLenum query, GLdouble* v) {
  if (!outside_begin_end()) return;
  const std::optional<int> number = axis_number(axis);
  if (!number || (query != GL_ORDER && query != GL_COEFF)) return raise_invalid_enum();
  const std::optional<AxisBlending>& blending = State::current().blending[*number];
  const int order = blending ? blending->degree() + 1 : 0;
  if (query == GL_ORDER) {
    *v = order;
    return;
  }
  for (int function = 0; function < order; ++function) {
    for (int power = 0; power < order; ++power) *v++ = blending->coefficients()(function, power);
  }
}
