#pragma once

#include <functional>

#include "picture/camera.hpp"

namespace hwffd::picture {

/// Clears the current framebuffer and has `draw` issue calls to the current context, in object
/// space, before the camera: a light background and two lights that move with the camera, a strong
/// one above to the left and a weak one to the right. Both sides of a surface are lit. Colours are
/// those of glColor, normals are normalized; state that `draw` changes is put back.
/// @param aspect  width by height of the viewport
void draw_studio(const Camera& camera, double aspect, const std::function<void()>& draw);

}  // namespace hwffd::picture
