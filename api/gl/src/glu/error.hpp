#pragma once

#include "hwffd/glffd.h"

namespace hwffd::glu {

/// A GLU error on its way to the callback.
struct GluError {
  GLenum code;
};

/// The line of gluFfdErrorString; null for another number.
const char* error_string(GLenum code);

}  // namespace hwffd::glu
