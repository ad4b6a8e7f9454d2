#pragma once

// OpenGL with the calls that came after 1.1, which the library exports by name:
// GL_GLEXT_PROTOTYPES, defined for all files of the target, since several are compiled as one.
#include <GL/gl.h>
#include <GL/glext.h>
