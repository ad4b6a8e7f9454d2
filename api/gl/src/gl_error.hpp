#pragma once

#include <functional>

namespace hwffd::gl {

// How a command raises an error of the current context, for glGetError to report: it makes a call
// of OpenGL's own that is wrong in the same way, has no effect and goes into no display list.
// Between glBegin and glEnd all of them raise GL_INVALID_OPERATION, as OpenGL's commands do there.

void raise_invalid_value();
void raise_invalid_enum();
void raise_invalid_operation();

/// Whether commands that are illegal between glBegin and glEnd may go on. There it raises
/// GL_INVALID_OPERATION; without a current context it is false and raises nothing.
bool outside_begin_end();

/// Runs the body of a command; what it throws becomes GL_INVALID_OPERATION.
void guarded(const std::function<void()>& body);

}  // namespace hwffd::gl
