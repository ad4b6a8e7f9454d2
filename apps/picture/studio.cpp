#include "picture/studio.hpp"

#include <array>

#include "picture/opengl.hpp"

namespace hwffd::picture {
namespace {

using Colour = std::array<GLfloat, 4>;

constexpr Colour kBackground{0.96f, 0.965f, 0.975f, 1.0f};
constexpr Colour kAmbient{0.30f, 0.30f, 0.32f, 1.0f};

struct Light {
  Colour colour;
  std::array<GLfloat, 4> direction;  ///< towards the light, in the eye's space
};
constexpr std::array<Light, 2> kLights{{{{0.68f, 0.67f, 0.64f, 1.0f}, {-0.5f, 0.8f, 1.0f, 0.0f}},
                                        {{0.20f, 0.21f, 0.24f, 1.0f}, {0.9f, 0.1f, 0.5f, 0.0f}}}};

/// Keeps the state of the context, matrices included, as it is now.
class GlStateGuard {
 public:
  GlStateGuard() {
    glPushAttrib(GL_ALL_ATTRIB_BITS);
    glPushClientAttrib(GL_CLIENT_ALL_ATTRIB_BITS);
    for (const GLenum mode : {GL_PROJECTION, GL_MODELVIEW}) {
      glMatrixMode(mode);
      glPushMatrix();
    }
  }
  GlStateGuard(const GlStateGuard&) = delete;
  GlStateGuard& operator=(const GlStateGuard&) = delete;
  ~GlStateGuard() {
    for (const GLenum mode : {GL_PROJECTION, GL_MODELVIEW}) {
      glMatrixMode(mode);
      glPopMatrix();
    }
    glPopClientAttrib();
    glPopAttrib();
  }
};

void set_camera(const Camera& camera, double aspect) {
  glMatrixMode(GL_PROJECTION);
  glLoadMatrixd(camera.projection(aspect).data());
  glMatrixMode(GL_MODELVIEW);
  glLoadMatrixd(camera.view().data());
}

/// The lights' directions are taken as the matrices stand.
void set_lights() {
  glMatrixMode(GL_MODELVIEW);
  glLoadIdentity();
  glLightModelfv(GL_LIGHT_MODEL_AMBIENT, kAmbient.data());
  glLightModeli(GL_LIGHT_MODEL_TWO_SIDE, GL_TRUE);
  for (std::size_t i = 0; i < kLights.size(); ++i) {
    const GLenum light = static_cast<GLenum>(GL_LIGHT0 + i);
    glLightfv(light, GL_DIFFUSE, kLights[i].colour.data());
    glLightfv(light, GL_SPECULAR, Colour{0, 0, 0, 1}.data());
    glLightfv(light, GL_POSITION, kLights[i].direction.data());
    glEnable(light);
  }
  glEnable(GL_LIGHTING);
  glEnable(GL_NORMALIZE);
  glEnable(GL_COLOR_MATERIAL);
  glColorMaterial(GL_FRONT_AND_BACK, GL_AMBIENT_AND_DIFFUSE);
}

void clear() {
  glClearColor(kBackground[0], kBackground[1], kBackground[2], kBackground[3]);
  glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
  glEnable(GL_DEPTH_TEST);
  glEnable(GL_MULTISAMPLE);
}

}  // namespace

void draw_studio(const Camera& camera, double aspect, const std::function<void()>& draw) {
  const GlStateGuard guard;
  clear();
  set_lights();
  set_camera(camera, aspect);
  draw();
}

}  // namespace hwffd::picture
