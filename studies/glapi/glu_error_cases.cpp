#include "glu_error_cases.hpp"

#include <limits>

namespace hwffd::glapi {
namespace {

/// The arguments of gluFfdVolume: one vertex in a lattice of 4 x 4 x 4 points.
struct Arguments {
  GLsizei count = 1;
  GLint stride = 4;
  std::vector<GLfloat> coordinates{0.5F, 0.5F, 0.5F, 0};
  GLint knot_count[3] = {8, 8, 8};
  std::vector<GLfloat> knots[3];  ///< none: uniform
  GLint strides[3] = {48, 12, 3};
  std::vector<GLfloat> control = std::vector<GLfloat>(4 * 20 * 20 * 20);
  GLint orders[3] = {4, 4, 4};
  GLenum type = GL_MAP3_VERTEX_3;
};

void give(GLUffd* ffd, const Arguments& a) {
  const auto of = [](const std::vector<GLfloat>& numbers) {
    return numbers.empty() ? nullptr : numbers.data();
  };
  gluFfdVolume(ffd, a.count, a.stride, of(a.coordinates), a.knot_count[0], of(a.knots[0]),
               a.knot_count[1], of(a.knots[1]), a.knot_count[2], of(a.knots[2]), a.strides[0],
               a.strides[1], a.strides[2], of(a.control), a.orders[0], a.orders[1], a.orders[2],
               a.type);
}

using Change = std::function<void(Arguments&)>;

/// A case of gluFfdVolume, within a volume that has nothing else.
GluErrorCase volume_case(const std::string& name, GLenum expected, const Change& change) {
  return {"gluFfdVolume: " + name, expected, [change](GLUffd* ffd) {
            Arguments arguments;
            change(arguments);
            gluBeginVolume(ffd);
            give(ffd, arguments);
            gluEndVolume(ffd);
          }};
}

/// Mistakes that each axis can have.
void add_axis_cases(std::vector<GluErrorCase>& cases, int axis) {
  const auto add = [&](const std::string& name, GLenum expected, const Change& change) {
    cases.push_back(volume_case(std::string(1, "stu"[axis]) + ": " + name, expected, change));
  };
  const auto knots = [axis](const std::vector<GLfloat>& sequence) {
    return [axis, sequence](Arguments& a) {
      a.knots[axis] = sequence;
      a.knot_count[axis] = static_cast<GLint>(sequence.size());
    };
  };
  constexpr GLfloat kNan = std::numeric_limits<GLfloat>::quiet_NaN();
  add("order 0", GLU_FFD_INVALID_ORDER, [axis](Arguments& a) { a.orders[axis] = 0; });
  add("order 5", GLU_FFD_INVALID_ORDER, [axis](Arguments& a) { a.orders[axis] = 5; });
  add("7 knots for order 4", GLU_FFD_TOO_FEW_KNOTS,
      [axis](Arguments& a) { a.knot_count[axis] = 7; });
  add("empty range", GLU_FFD_EMPTY_KNOT_RANGE, knots({0, 1, 2, 3, 3, 4, 5, 6}));
  add("decreasing outside the range", GLU_FFD_DECREASING_KNOTS, knots({1, 0, 2, 3, 4, 5, 6, 7}));
  add("decreasing, at the end", GLU_FFD_DECREASING_KNOTS, knots({0, 1, 2, 3, 4, 5, 7, 6}));
  add("a knot that is not a number", GLU_FFD_DECREASING_KNOTS, knots({0, kNan, 2, 3, 4, 5, 6, 7}));
  add("five equal knots", GLU_FFD_KNOT_MULTIPLICITY, knots({0, 0, 0, 0, 1, 1, 1, 1, 1, 2}));
  add("five equal knots, then decreasing", GLU_FFD_DECREASING_KNOTS,
      knots({0, 0, 0, 0, 1, 1, 1, 1, 1, 0}));
  add("14 cells", GLU_FFD_TOO_MANY_CELLS, [axis](Arguments& a) { a.knot_count[axis] = 21; });
  add("13 cells", GL_NO_ERROR, [axis](Arguments& a) { a.knot_count[axis] = 20; });
  add("clamped knots", GL_NO_ERROR, knots({0, 0, 0, 0, 1, 1, 1, 1}));
  add("negative stride", GLU_FFD_INVALID_STRIDE, [axis](Arguments& a) { a.strides[axis] = -1; });
}

std::vector<GluErrorCase> volume_cases() {
  std::vector<GluErrorCase> cases{
      volume_case("valid", GL_NO_ERROR, [](Arguments&) {}),
      volume_case("unknown type", GLU_FFD_INVALID_ENUM, [](Arguments& a) { a.type = 1; }),
      volume_case("colour index", GLU_FFD_INVALID_ENUM,
                  [](Arguments& a) { a.type = GL_MAP3_INDEX; }),
      volume_case("unknown type, negative stride", GLU_FFD_INVALID_ENUM,
                  [](Arguments& a) {
                    a.type = 1;
                    a.strides[0] = -1;
                  }),
      volume_case("negative stride, order 0", GLU_FFD_INVALID_STRIDE,
                  [](Arguments& a) {
                    a.orders[2] = 0;
                    a.strides[0] = -1;
                  }),
      volume_case("no control points, order 0", GLU_FFD_NULL_CONTROL,
                  [](Arguments& a) {
                    a.orders[2] = 0;
                    a.control.clear();
                  }),
      volume_case("stride 3 of vertices", GLU_FFD_INVALID_STRIDE,
                  [](Arguments& a) { a.stride = 3; }),
      volume_case("stride 3, no control points", GLU_FFD_INVALID_STRIDE,
                  [](Arguments& a) {
                    a.stride = 3;
                    a.control.clear();
                  }),
      volume_case("count -1", GLU_FFD_INVALID_VALUE, [](Arguments& a) { a.count = -1; }),
      volume_case("no coordinates", GLU_FFD_NULL_CONTROL,
                  [](Arguments& a) { a.coordinates.clear(); }),
      volume_case("no control points", GLU_FFD_NULL_CONTROL,
                  [](Arguments& a) { a.control.clear(); }),
      volume_case("only a colour", GLU_FFD_MISSING_DATA,
                  [](Arguments& a) { a.type = GL_MAP3_COLOR_4; }),
      volume_case(
          "control point not a number", GLU_FFD_DEVICE_FAILED,
          [](Arguments& a) { a.control.front() = std::numeric_limits<GLfloat>::quiet_NaN(); }),
      volume_case(
          "coordinate not a number", GLU_FFD_INVALID_VALUE,
          [](Arguments& a) { a.coordinates[1] = std::numeric_limits<GLfloat>::quiet_NaN(); }),
      volume_case("vertex of an empty cell", GLU_FFD_INVALID_INDEX, [](Arguments& a) {
        a.knots[2] = {0, 0, 0, 0, 1, 1, 2, 2, 2, 2};
        a.knot_count[2] = 10;
        a.coordinates[3] = 1;
      })};
  for (const GLfloat number : {-1.0F, 0.5F, 1.0F, 64.0F, 1e9F}) {
    cases.push_back(volume_case("cell " + std::to_string(number), GLU_FFD_INVALID_INDEX,
                                [number](Arguments& a) { a.coordinates[3] = number; }));
  }
  for (int axis = 0; axis < 3; ++axis) add_axis_cases(cases, axis);
  return cases;
}

/// Cases of what lies in a volume beside its positions.
GluErrorCase content_case(const std::string& name, GLenum expected,
                          const std::function<void(GLUffd*)>& content) {
  return {name, expected, [content](GLUffd* ffd) {
            gluBeginVolume(ffd);
            give(ffd, {});
            content(ffd);
            gluEndVolume(ffd);
          }};
}

std::vector<GluErrorCase> content_cases() {
  static const GLfloat normals[6] = {0, 0, 1, 0, 0, 1};
  static const GLuint elements[2] = {0, 1};
  const auto with_type = [](GLenum type, GLsizei count) {
    return [type, count](GLUffd* ffd) {
      Arguments arguments;
      arguments.type = type;
      arguments.count = count;
      arguments.coordinates.resize(8);
      give(ffd, arguments);
    };
  };
  return {content_case("gluEndVolume: positions twice", GLU_FFD_MISSING_DATA,
                       with_type(GL_MAP3_VERTEX_3, 1)),
          content_case("gluEndVolume: more colours than positions", GLU_FFD_MISSING_DATA,
                       with_type(GL_MAP3_COLOR_4, 2)),
          content_case("gluEndVolume: a colour", GL_NO_ERROR, with_type(GL_MAP3_COLOR_4, 1)),
          content_case("gluFfdNormals: valid", GL_NO_ERROR,
                       [](GLUffd* ffd) { gluFfdNormals(ffd, 1, 3, normals); }),
          content_case("gluFfdNormals: more than positions", GLU_FFD_MISSING_DATA,
                       [](GLUffd* ffd) { gluFfdNormals(ffd, 2, 3, normals); }),
          content_case("gluFfdNormals: stride 2", GLU_FFD_INVALID_STRIDE,
                       [](GLUffd* ffd) { gluFfdNormals(ffd, 1, 2, normals); }),
          content_case("gluFfdNormals: count -1", GLU_FFD_INVALID_VALUE,
                       [](GLUffd* ffd) { gluFfdNormals(ffd, -1, 3, normals); }),
          content_case("gluFfdNormals: none", GLU_FFD_NULL_CONTROL,
                       [](GLUffd* ffd) { gluFfdNormals(ffd, 1, 3, nullptr); }),
          content_case("gluFfdElements: valid", GL_NO_ERROR,
                       [](GLUffd* ffd) { gluFfdElements(ffd, 1, elements); }),
          content_case("gluFfdElements: beyond the vertices", GLU_FFD_INVALID_INDEX,
                       [](GLUffd* ffd) { gluFfdElements(ffd, 2, elements); }),
          content_case("gluFfdElements: count -1", GLU_FFD_INVALID_VALUE,
                       [](GLUffd* ffd) { gluFfdElements(ffd, -1, elements); }),
          content_case("gluFfdElements: none", GLU_FFD_NULL_CONTROL,
                       [](GLUffd* ffd) { gluFfdElements(ffd, 1, nullptr); })};
}

std::vector<GluErrorCase> order_cases() {
  static const GLfloat normal[3] = {0, 0, 1};
  static const GLuint element = 0;
  return {
      {"gluBeginVolume: twice", GLU_FFD_NESTED_VOLUME,
       [](GLUffd* ffd) {
         gluBeginVolume(ffd);
         gluBeginVolume(ffd);
       }},
      {"gluEndVolume: without begin", GLU_FFD_MISSING_BEGIN, gluEndVolume},
      {"gluEndVolume: without positions", GLU_FFD_MISSING_DATA,
       [](GLUffd* ffd) {
         gluBeginVolume(ffd);
         gluEndVolume(ffd);
       }},
      {"gluFfdVolume: without begin", GLU_FFD_MISSING_BEGIN, [](GLUffd* ffd) { give(ffd, {}); }},
      {"gluFfdNormals: without begin", GLU_FFD_MISSING_BEGIN,
       [](GLUffd* ffd) { gluFfdNormals(ffd, 1, 3, normal); }},
      {"gluFfdElements: without begin", GLU_FFD_MISSING_BEGIN,
       [](GLUffd* ffd) { gluFfdElements(ffd, 1, &element); }}};
}

GluErrorCase property_case(const std::string& name, GLenum expected, GLenum property,
                           GLfloat value) {
  return {"gluFfdProperty: " + name, expected,
          [property, value](GLUffd* ffd) { gluFfdProperty(ffd, property, value); }};
}

std::vector<GluErrorCase> property_cases() {
  constexpr GLfloat kNan = std::numeric_limits<GLfloat>::quiet_NaN();
  return {property_case("valid", GL_NO_ERROR, GLU_FFD_LINE_WIDTH, 2),
          property_case("unknown", GLU_FFD_INVALID_ENUM, 1, 1),
          property_case("unknown mode", GLU_FFD_INVALID_VALUE, GLU_FFD_MODE, 1),
          property_case("unknown primitive", GLU_FFD_INVALID_VALUE, GLU_FFD_PRIMITIVE, 77),
          property_case("unknown display mode", GLU_FFD_INVALID_VALUE, GLU_FFD_DISPLAY_MODE, 1),
          property_case("line width 0", GLU_FFD_INVALID_VALUE, GLU_FFD_LINE_WIDTH, 0),
          property_case("line width not a number", GLU_FFD_INVALID_VALUE, GLU_FFD_LINE_WIDTH, kNan),
          property_case("point size -1", GLU_FFD_INVALID_VALUE, GLU_FFD_POINT_SIZE, -1),
          property_case("unknown device", GLU_FFD_INVALID_VALUE, GLU_FFD_DEVICE, 1),
          {"gluGetFfdProperty: unknown", GLU_FFD_INVALID_ENUM,
           [](GLUffd* ffd) {
             GLfloat value = 0;
             gluGetFfdProperty(ffd, 1, &value);
           }},
          {"gluFfdDevice: unknown kind", GLU_FFD_DEVICE_FAILED,
           [](GLUffd* ffd) { gluFfdDevice(ffd, "abacus"); }},
          {"gluFfdDevice: unknown organization", GLU_FFD_DEVICE_FAILED,
           [](GLUffd* ffd) { gluFfdDevice(ffd, "model:circle:fp32"); }},
          {"gluFfdDevice: empty part", GLU_FFD_DEVICE_FAILED,
           [](GLUffd* ffd) { gluFfdDevice(ffd, "model::fp32"); }},
          {"gluFfdCallback: unknown", GLU_FFD_INVALID_ENUM,
           [](GLUffd* ffd) { gluFfdCallback(ffd, GLU_FFD_END + 1, nullptr); }}};
}

void note(GLenum error, void* errors) {
  static_cast<std::vector<GLenum>*>(errors)->push_back(error);
}

}  // namespace

std::vector<GluErrorCase> glu_error_cases() {
  std::vector<GluErrorCase> all = volume_cases();
  for (const auto& cases : {content_cases(), order_cases(), property_cases()}) {
    all.insert(all.end(), cases.begin(), cases.end());
  }
  return all;
}

std::vector<GLenum> errors_of(const GluErrorCase& error_case) {
  std::vector<GLenum> errors;
  GLUffd* ffd = gluNewFfdRenderer();
  gluFfdCallbackData(ffd, &errors);
  gluFfdCallback(ffd, GLU_FFD_ERROR_DATA, reinterpret_cast<GLUffdCallback>(&note));
  gluFfdProperty(ffd, GLU_FFD_MODE, GLU_FFD_EVALUATOR);
  error_case.call(ffd);
  gluDeleteFfdRenderer(ffd);
  return errors;
}

}  // namespace hwffd::glapi
