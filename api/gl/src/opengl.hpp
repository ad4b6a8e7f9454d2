#pragma once

// OpenGL with the calls that came after 1.1, which the library exports by name.
#define GL_GLEXT_PROTOTYPES
#include <GL/gl.h>
#include <GL/glext.h>
