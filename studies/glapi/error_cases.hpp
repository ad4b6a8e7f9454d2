#pragma once

#include <functional>
#include <string>
#include <vector>

#include "hwffd/glffd.h"

namespace hwffd::glapi {

/// A mistake, or the lack of one, in a GL command.
struct ErrorCase {
  std::string name;
  GLenum expected;               ///< GL_NO_ERROR included
  std::function<void()> call;    ///< the command for volumes
  std::function<void()> planar;  ///< the same mistake in OpenGL's own command; empty: it has none
};

/// Every row of the error tables of the GL commands. They need a current context.
std::vector<ErrorCase> gl_error_cases();

}  // namespace hwffd::glapi
