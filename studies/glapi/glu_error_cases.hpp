#pragma once

#include <functional>
#include <string>
#include <vector>

#include "hwffd/glffd.h"

namespace hwffd::glapi {

/// A mistake, or the lack of one, in a GLU command.
struct GluErrorCase {
  std::string name;
  GLenum expected;  ///< what the callback gets, once; GL_NO_ERROR: it is not called
  std::function<void(GLUffd*)> call;
};

/// Every row of the error tables of the GLU commands. They need no context.
std::vector<GluErrorCase> glu_error_cases();

/// The errors that a new renderer reports during a case.
std::vector<GLenum> errors_of(const GluErrorCase& error_case);

}  // namespace hwffd::glapi
