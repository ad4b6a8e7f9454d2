#include "call_checks.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>

#include "context.hpp"
#include "hwffd/glffd.h"
#include "hwffd/oracle/oracle.hpp"

namespace hwffd::glapi {
namespace {

constexpr double kTolerance = 1e-5;

/// A volume that is the unit cube itself: q(u, v, w) = (u, v, w).
void define_cube() {
  std::vector<GLdouble> corners;
  std::vector<GLfloat> floats;
  for (int corner = 0; corner < 8; ++corner) {
    for (const int axis : {4, 2, 1}) corners.push_back((corner & axis) != 0 ? 1 : 0);
  }
  floats.assign(corners.begin(), corners.end());
  glMap3f(GL_MAP3_COLOR_4, 0, 1, 4, 1, 0, 1, 4, 1, 0, 1, 4, 1, floats.data());
  glMap3f(GL_MAP3_NORMAL, 0, 1, 12, 2, 0, 1, 6, 2, 0, 1, 3, 2, floats.data());
  glMap3d(GL_MAP3_VERTEX_3, 0, 1, 12, 2, 0, 1, 6, 2, 0, 1, 3, 2, corners.data());
  glEnableMap3(GL_MAP3_VERTEX_3);
}

bool are(const std::vector<Seen>& vertices, const std::vector<Point>& expected) {
  return std::equal(vertices.begin(), vertices.end(), expected.begin(), expected.end(),
                    [](const Seen& vertex, const Point& point) {
                      return (vertex.position - point).norm() < kTolerance;
                    });
}

bool maps_give_back_their_points() {
  define_cube();
  GLdouble doubles[24];
  GLfloat floats[24];
  GLint integers[24];
  glGetMap3dv(GL_MAP3_VERTEX_3, GL_COEFF, doubles);
  glGetMap3fv(GL_MAP3_NORMAL, GL_COEFF, floats);
  glGetMap3iv(GL_MAP3_NORMAL, GL_COEFF, integers);
  const std::vector<GLdouble> expected{0, 0, 0, 0, 0, 1, 0, 1, 0, 0, 1, 1,
                                       1, 0, 0, 1, 0, 1, 1, 1, 0, 1, 1, 1};
  return std::equal(expected.begin(), expected.end(), doubles) &&
         std::equal(expected.begin(), expected.end(), floats) &&
         std::equal(expected.begin(), expected.end(), integers);
}

bool maps_are_switched() {
  glEnableMap3(GL_MAP3_COLOR_4);
  const bool on = glIsEnabledMap3(GL_MAP3_COLOR_4) == GL_TRUE;
  glDisableMap3(GL_MAP3_COLOR_4);
  return on && glIsEnabledMap3(GL_MAP3_COLOR_4) == GL_FALSE;
}

bool coordinates_are_evaluated() {
  define_cube();
  const GLfloat floats[3] = {0.25F, 0.5F, 0.75F};
  const GLdouble doubles[3] = {0.125, 0.625, 0.375};
  const std::vector<Seen> vertices = seen([&] {
    glBegin(GL_POINTS);
    glEvalCoord3f(0.25F, 0.5F, 0.75F);
    glEvalCoord3fv(floats);
    glEvalCoord3d(0.125, 0.625, 0.375);
    glEvalCoord3dv(doubles);
    glEnd();
  });
  const Point a(0.25, 0.5, 0.75);
  const Point b(0.125, 0.625, 0.375);
  return are(vertices, {a, a, b, b});
}

bool grids_are_evaluated() {
  define_cube();
  glMapGrid3f(2, 1, 0, 2, 0, 1, 4, 0, 1);
  GLdouble segments[3];
  glGetEval3dv(GL_MAP3_GRID_SEGMENTS, segments);
  const std::vector<Seen> point = seen([] {
    glBegin(GL_POINTS);
    glEvalPoint3(0, 1, 3);
    glEnd();
  });
  glMapGrid3d(1, 0, 1, 1, 0, 1, 1, 0, 1);
  const std::vector<Seen> mesh = seen([] { glEvalMesh3(GL_POINT, 0, 1, 0, 1, 1, 1); });
  return segments[2] == 4 && are(point, {{1, 0.5, 0.75}}) &&
         are(mesh, {{0, 0, 1}, {1, 0, 1}, {0, 1, 1}, {1, 1, 1}});
}

bool blending_functions_are_kept() {
  const GLfloat linear[4] = {1, -1, 0, 1};
  const GLdouble constant[1] = {1};
  GLdouble got[4] = {0, 0, 0, 0};
  glBlendCoefficientf(GL_MAP3_V, 1, linear);
  glGetBlendCoefficientdv(GL_MAP3_V, GL_COEFF, got);
  const bool kept = std::equal(linear, linear + 4, got);
  glBlendCoefficientd(GL_MAP3_V, 0, constant);
  glGetBlendCoefficientdv(GL_MAP3_V, GL_ORDER, got);
  glBlendCoefficientd(GL_MAP3_V, 0, nullptr);
  return kept && got[0] == 1;
}

/// A vertex with its 64 points, as glFFD takes it.
std::vector<GLfloat> one_vertex() {
  std::vector<GLfloat> stream{0.5F, 0.25F, 0.75F};
  for (int number = 0; number < 192; ++number) {
    stream.push_back(static_cast<GLfloat>(number * 37 % 64) / 64);
  }
  return stream;
}

Point expected_of(const std::vector<GLfloat>& vertex, const Oracle& oracle) {
  Support support;
  for (int point = 0; point < 64; ++point) {
    for (int c = 0; c < 3; ++c) support(point, c) = static_cast<double>(vertex[3 + 3 * point + c]);
  }
  return oracle.evaluate(support, vertex[0], vertex[1], vertex[2]);
}

bool streams_are_evaluated_on_the_device_chosen() {
  const std::vector<GLfloat> stream = one_vertex();
  const Point expected = expected_of(stream, Oracle(Oracle::bernstein()));
  bool right = true;
  for (const char* device : {"reference", "model", "rtl"}) {
    glFfdDevice(device);
    right &= are(seen([&] { glFFD(GL_POINTS, 1, GL_FLOAT, stream.data()); }), {expected});
  }
  glFfdDevice(nullptr);
  return right;
}

/// What the callbacks of a renderer get.
struct Heard {
  std::vector<GLenum> errors;
  std::vector<GLfloat> vertex;
  std::vector<GLfloat> normal;
  int vertices = 0;
};

void hear_error(GLenum error, void* heard) { static_cast<Heard*>(heard)->errors.push_back(error); }
void hear_vertex(const GLfloat* v, void* heard) {
  static_cast<Heard*>(heard)->vertex.assign(v, v + 3);
  ++static_cast<Heard*>(heard)->vertices;
}
void hear_normal(const GLfloat* n, void* heard) {
  static_cast<Heard*>(heard)->normal.assign(n, n + 3);
}

GLUffd* listening_renderer(Heard& heard) {
  GLUffd* ffd = gluNewFfdRenderer();
  gluFfdCallbackData(ffd, &heard);
  gluFfdCallback(ffd, GLU_FFD_ERROR_DATA, reinterpret_cast<GLUffdCallback>(&hear_error));
  gluFfdCallback(ffd, GLU_FFD_VERTEX_DATA, reinterpret_cast<GLUffdCallback>(&hear_vertex));
  gluFfdCallback(ffd, GLU_FFD_NORMAL_DATA, reinterpret_cast<GLUffdCallback>(&hear_normal));
  gluFfdProperty(ffd, GLU_FFD_MODE, GLU_FFD_EVALUATOR);
  return ffd;
}

bool volumes_are_evaluated() {
  Heard heard;
  GLUffd* ffd = listening_renderer(heard);
  gluFfdDevice(ffd, "reference");
  const std::vector<GLfloat> vertex = one_vertex();
  const GLfloat place[4] = {vertex[0], vertex[1], vertex[2], 0};
  const GLfloat normal[3] = {0, 0, 1};
  const GLuint twice[2] = {0, 0};
  gluBeginVolume(ffd);
  gluFfdVolume(ffd, 1, 4, place, 8, nullptr, 8, nullptr, 8, nullptr, 48, 12, 3, &vertex[3], 4, 4, 4,
               GL_MAP3_VERTEX_3);
  gluFfdNormals(ffd, 1, 3, normal);
  gluFfdElements(ffd, 2, twice);
  gluEndVolume(ffd);
  gluDeleteFfdRenderer(ffd);
  if (!heard.errors.empty() || heard.vertices != 2 || heard.normal.empty()) return false;
  const Point expected = expected_of(vertex, Oracle());
  return (Eigen::Map<Eigen::Vector3f>(heard.vertex.data()).cast<double>() - expected).norm() <
         kTolerance;
}

bool properties_are_kept() {
  Heard heard;
  GLUffd* ffd = listening_renderer(heard);
  gluFfdProperty(ffd, GLU_FFD_LINE_WIDTH, 3);
  GLfloat width = 0;
  gluGetFfdProperty(ffd, GLU_FFD_LINE_WIDTH, &width);
  gluFfdProperty(ffd, GLU_FFD_LINE_WIDTH, 0);
  gluDeleteFfdRenderer(ffd);
  return width == 3 && heard.errors == std::vector<GLenum>{GLU_FFD_INVALID_VALUE} &&
         gluFfdErrorString(GLU_FFD_INVALID_VALUE) != nullptr;
}

}  // namespace

std::vector<CallCheck> call_checks() {
  return {{{"glMap3f", "glMap3d", "glGetMap3dv", "glGetMap3fv", "glGetMap3iv"},
           maps_give_back_their_points},
          {{"glEnableMap3", "glDisableMap3", "glIsEnabledMap3"}, maps_are_switched},
          {{"glEvalCoord3f", "glEvalCoord3d", "glEvalCoord3fv", "glEvalCoord3dv"},
           coordinates_are_evaluated},
          {{"glMapGrid3f", "glMapGrid3d", "glGetEval3dv", "glEvalPoint3", "glEvalMesh3"},
           grids_are_evaluated},
          {{"glBlendCoefficientf", "glBlendCoefficientd", "glGetBlendCoefficientdv"},
           blending_functions_are_kept},
          {{"glFFD", "glFfdDevice"}, streams_are_evaluated_on_the_device_chosen},
          {{"gluNewFfdRenderer", "gluDeleteFfdRenderer", "gluFfdCallback", "gluFfdCallbackData",
            "gluFfdDevice", "gluBeginVolume", "gluEndVolume", "gluFfdVolume", "gluFfdNormals",
            "gluFfdElements"},
           volumes_are_evaluated},
          {{"gluFfdProperty", "gluGetFfdProperty", "gluFfdErrorString"}, properties_are_kept}};
}

}  // namespace hwffd::glapi
