#include "error_cases.hpp"

#include <limits>

#include "map_error_cases.hpp"

namespace hwffd::glapi {
namespace {

/// Room for whatever a query returns.
GLdouble* scratch() {
  static std::vector<GLdouble> numbers(4096);
  return numbers.data();
}

std::function<void()> between_begin_and_end(const std::function<void()>& call) {
  if (!call) return {};
  return [call] {
    glBegin(GL_POINTS);
    call();
    glEnd();
  };
}

/// The cases, and each of them between glBegin and glEnd, where `allowed` says what comes of it.
void add(std::vector<ErrorCase>& all, const std::vector<ErrorCase>& cases,
         GLenum between = GL_INVALID_OPERATION) {
  for (const ErrorCase& one : cases) {
    all.push_back(one);
    all.push_back({one.name + ", between glBegin and glEnd", between,
                   between_begin_and_end(one.call), between_begin_and_end(one.planar)});
  }
}

std::vector<ErrorCase> query_cases() {
  return {
      {"glGetMap3: valid", GL_NO_ERROR, [] { glGetMap3dv(GL_MAP3_VERTEX_3, GL_ORDER, scratch()); },
       [] { glGetMapdv(GL_MAP2_VERTEX_3, GL_ORDER, scratch()); }},
      {"glGetMap3: unknown target", GL_INVALID_ENUM, [] { glGetMap3dv(1, GL_COEFF, scratch()); },
       [] { glGetMapdv(1, GL_COEFF, scratch()); }},
      {"glGetMap3: unknown query", GL_INVALID_ENUM,
       [] { glGetMap3dv(GL_MAP3_VERTEX_3, 1, scratch()); },
       [] { glGetMapdv(GL_MAP2_VERTEX_3, 1, scratch()); }},
      {"glGetMap3: both unknown", GL_INVALID_ENUM, [] { glGetMap3dv(1, 1, scratch()); },
       [] { glGetMapdv(1, 1, scratch()); }},
      {"glEnableMap3: valid", GL_NO_ERROR, [] { glEnableMap3(GL_MAP3_NORMAL); },
       [] { glEnable(GL_MAP2_NORMAL); }},
      {"glEnableMap3: unknown map", GL_INVALID_ENUM, [] { glEnableMap3(1); }, [] { glEnable(1); }},
      {"glDisableMap3: valid", GL_NO_ERROR, [] { glDisableMap3(GL_MAP3_NORMAL); },
       [] { glDisable(GL_MAP2_NORMAL); }},
      {"glDisableMap3: unknown map", GL_INVALID_ENUM, [] { glDisableMap3(1); },
       [] { glDisable(1); }},
      {"glIsEnabledMap3: valid", GL_NO_ERROR, [] { glIsEnabledMap3(GL_AUTO_NORMAL); },
       [] { glIsEnabled(GL_AUTO_NORMAL); }},
      {"glIsEnabledMap3: unknown map", GL_INVALID_ENUM, [] { glIsEnabledMap3(1); },
       [] { glIsEnabled(1); }},
      {"glGetEval3: valid", GL_NO_ERROR, [] { glGetEval3dv(GL_MAP3_GRID_DOMAIN, scratch()); },
       [] { glGetDoublev(GL_MAP2_GRID_DOMAIN, scratch()); }},
      {"glGetEval3: unknown name", GL_INVALID_ENUM, [] { glGetEval3dv(1, scratch()); },
       [] { glGetDoublev(1, scratch()); }}};
}

std::vector<ErrorCase> grid_cases() {
  std::vector<ErrorCase> cases{
      {"glMapGrid3: valid", GL_NO_ERROR, [] { glMapGrid3d(2, 0, 1, 2, 0, 1, 2, 0, 1); },
       [] { glMapGrid2d(2, 0, 1, 2, 0, 1); }},
      {"glMapGrid3: empty domain", GL_NO_ERROR, [] { glMapGrid3f(2, 0, 0, 2, 0, 1, 2, 1, 1); },
       [] { glMapGrid2f(2, 0, 0, 2, 1, 1); }}};
  for (const GLint few : {0, -1}) {
    const std::string n = " = " + std::to_string(few);
    cases.push_back({"glMapGrid3: un" + n, GL_INVALID_VALUE,
                     [few] { glMapGrid3d(few, 0, 1, 2, 0, 1, 2, 0, 1); },
                     [few] { glMapGrid2d(few, 0, 1, 2, 0, 1); }});
    cases.push_back({"glMapGrid3: vn" + n, GL_INVALID_VALUE,
                     [few] { glMapGrid3f(2, 0, 1, few, 0, 1, 2, 0, 1); },
                     [few] { glMapGrid2f(2, 0, 1, few, 0, 1); }});
    cases.push_back({"glMapGrid3: wn" + n, GL_INVALID_VALUE,
                     [few] { glMapGrid3d(2, 0, 1, 2, 0, 1, few, 0, 1); },
                     [few] { glMapGrid2d(2, 0, 1, few, 0, 1); }});
  }
  return cases;
}

std::vector<ErrorCase> mesh_cases() {
  return {
      {"glEvalMesh3: valid", GL_NO_ERROR, [] { glEvalMesh3(GL_LINE, 0, 1, 0, 1, 0, 1); },
       [] { glEvalMesh2(GL_LINE, 0, 1, 0, 1); }},
      {"glEvalMesh3: unknown mode", GL_INVALID_ENUM, [] { glEvalMesh3(1, 0, 1, 0, 1, 0, 1); },
       [] { glEvalMesh2(1, 0, 1, 0, 1); }},
      {"glEvalMesh3: GL_FILL", GL_INVALID_ENUM, [] { glEvalMesh3(GL_FILL, 0, 1, 0, 1, 0, 1); }, {}},
      {"glEvalMesh3: empty range", GL_NO_ERROR, [] { glEvalMesh3(GL_POINT, 1, 0, 1, 0, 1, 0); },
       [] { glEvalMesh2(GL_POINT, 1, 0, 1, 0); }},
      {"glEvalMesh3: beyond the grid", GL_NO_ERROR,
       [] { glEvalMesh3(GL_POINT, -2, 5, 0, 1, 0, 1); },
       [] { glEvalMesh2(GL_POINT, -2, 5, 0, 1); }}};
}

std::vector<ErrorCase> point_cases() {
  return {{"glEvalCoord3: valid", GL_NO_ERROR, [] { glEvalCoord3d(0, 0, 0); },
           [] { glEvalCoord2d(0, 0); }},
          {"glEvalCoord3: beyond the domain", GL_NO_ERROR, [] { glEvalCoord3f(9, -9, 0); },
           [] { glEvalCoord2f(9, -9); }},
          {"glEvalPoint3: valid", GL_NO_ERROR, [] { glEvalPoint3(0, 0, 0); },
           [] { glEvalPoint2(0, 0); }},
          {"glEvalPoint3: beyond the grid", GL_NO_ERROR, [] { glEvalPoint3(99, -1, 0); },
           [] { glEvalPoint2(99, -1); }}};
}

std::vector<ErrorCase> stream_cases() {
  static const std::vector<GLfloat> stream(195);
  return {
      {"glFFD: valid", GL_NO_ERROR, [] { glFFD(GL_POINTS, 1, GL_FLOAT, stream.data()); },
       [] { glDrawArrays(GL_POINTS, 0, 1); }},
      {"glFFD: no vertices", GL_NO_ERROR, [] { glFFD(GL_POINTS, 0, GL_FLOAT, stream.data()); },
       [] { glDrawArrays(GL_POINTS, 0, 0); }},
      {"glFFD: unknown mode", GL_INVALID_ENUM, [] { glFFD(77, 1, GL_FLOAT, stream.data()); },
       [] { glDrawArrays(77, 0, 1); }},
      {"glFFD: count -1", GL_INVALID_VALUE, [] { glFFD(GL_POINTS, -1, GL_FLOAT, stream.data()); },
       [] { glDrawArrays(GL_POINTS, 0, -1); }},
      {"glFFD: count -1, unknown mode", GL_INVALID_VALUE,
       [] { glFFD(77, -1, GL_FLOAT, stream.data()); }, [] { glDrawArrays(77, 0, -1); }},
      {"glFFD: unknown type",
       GL_INVALID_ENUM,
       [] { glFFD(GL_POINTS, 1, GL_SHORT, stream.data()); },
       {}},
      {"glFFD: null stream", GL_INVALID_VALUE, [] { glFFD(GL_POINTS, 1, GL_FLOAT, nullptr); }, {}},
      {"glFfdDevice: unknown device", GL_INVALID_VALUE, [] { glFfdDevice("abacus"); }, {}}};
}

std::vector<ErrorCase> blend_cases() {
  static const std::vector<GLdouble> numbers(16);
  static const std::vector<GLdouble> nan(16, std::numeric_limits<GLdouble>::quiet_NaN());
  return {{"glBlendCoefficient: initial state",
           GL_NO_ERROR,
           [] { glBlendCoefficientd(GL_MAP3_U, 3, nullptr); },
           {}},
          {"glBlendCoefficient: unknown axis",
           GL_INVALID_ENUM,
           [] { glBlendCoefficientd(GL_S, 3, numbers.data()); },
           {}},
          {"glBlendCoefficient: unknown axis, degree 4",
           GL_INVALID_ENUM,
           [] { glBlendCoefficientd(GL_S, 4, numbers.data()); },
           {}},
          {"glBlendCoefficient: degree -1",
           GL_INVALID_VALUE,
           [] { glBlendCoefficientd(GL_MAP3_U, -1, numbers.data()); },
           {}},
          {"glBlendCoefficient: degree 4",
           GL_INVALID_VALUE,
           [] { glBlendCoefficientd(GL_MAP3_W, 4, numbers.data()); },
           {}},
          {"glBlendCoefficient: not a number",
           GL_INVALID_VALUE,
           [] { glBlendCoefficientd(GL_MAP3_V, 3, nan.data()); },
           {}},
          {"glGetBlendCoefficient: unknown axis",
           GL_INVALID_ENUM,
           [] { glGetBlendCoefficientdv(GL_S, GL_ORDER, scratch()); },
           {}},
          {"glGetBlendCoefficient: unknown query",
           GL_INVALID_ENUM,
           [] { glGetBlendCoefficientdv(GL_MAP3_U, GL_DOMAIN, scratch()); },
           {}}};
}

/// Evaluates a map of `points` points along u under blending functions of a degree.
/// @param degree  -1: Bernstein polynomials
void evaluate_line(GLint points, GLint degree) {
  static const std::vector<GLdouble> numbers(3 * 16);
  glMap3d(GL_MAP3_VERTEX_3, 0, 1, 3, points, 0, 1, 3, 1, 0, 1, 3, 1, numbers.data());
  if (degree >= 0) glBlendCoefficientd(GL_MAP3_U, degree, numbers.data());
  glEnableMap3(GL_MAP3_VERTEX_3);
  glEvalCoord3d(0, 0, 0);
  glDisableMap3(GL_MAP3_VERTEX_3);
  glBlendCoefficientd(GL_MAP3_U, 0, nullptr);
}

/// What can be wrong only with volumes.
std::vector<ErrorCase> volume_cases() {
  return {{"glMap3: null points",
           GL_INVALID_VALUE,
           [] { glMap3d(GL_MAP3_VERTEX_3, 0, 1, 3, 1, 0, 1, 3, 1, 0, 1, 3, 1, nullptr); },
           {}},
          {"glMap3: target of glMap2", GL_INVALID_ENUM,
           [] { glMap3d(GL_MAP2_VERTEX_3, 0, 1, 3, 1, 0, 1, 3, 1, 0, 1, 3, 1, scratch()); },
           [] { glMap2d(GL_MAP1_VERTEX_3, 0, 1, 3, 1, 0, 1, 3, 1, scratch()); }},
          {"glEvalCoord3: four points, Bernstein", GL_NO_ERROR, [] { evaluate_line(4, -1); }, {}},
          {"glEvalCoord3: five points, Bernstein",
           GL_INVALID_OPERATION,
           [] { evaluate_line(5, -1); },
           {}},
          {"glEvalCoord3: 13 cells", GL_NO_ERROR, [] { evaluate_line(15, 2); }, {}},
          {"glEvalCoord3: 14 cells", GL_INVALID_OPERATION, [] { evaluate_line(16, 2); }, {}},
          {"glEvalCoord3: fewer points than functions",
           GL_INVALID_OPERATION,
           [] { evaluate_line(3, 3); },
           {}}};
}

}  // namespace

std::vector<ErrorCase> gl_error_cases() {
  std::vector<ErrorCase> all = map_error_cases();
  add(all, query_cases());
  add(all, grid_cases());
  add(all, mesh_cases());
  add(all, point_cases(), GL_NO_ERROR);
  add(all, stream_cases());
  add(all, blend_cases());
  for (const ErrorCase& one : volume_cases()) all.push_back(one);
  return all;
}

}  // namespace hwffd::glapi
