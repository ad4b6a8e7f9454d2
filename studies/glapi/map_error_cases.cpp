#include "map_error_cases.hpp"

#include <array>

#define GL_GLEXT_PROTOTYPES
#include <GL/glext.h>

namespace hwffd::glapi {
namespace {

constexpr int kLimit3 = 16;  // GL_MAX_EVAL3_ORDER
constexpr int kLimit2 = 30;  // Mesa's GL_MAX_EVAL_ORDER

struct Axis {
  GLdouble last = 1;
  GLint stride = 3;
  GLint order = 2;
};

/// The arguments of glMap3, with those of glMap2 beside them, which the w axis shares with v.
struct Arguments {
  std::array<Axis, 3> axes3;
  std::array<Axis, 2> axes2;
  GLenum target3 = GL_MAP3_VERTEX_3;
  GLenum target2 = GL_MAP2_VERTEX_3;
  GLenum texture_unit = GL_TEXTURE0;
  bool between_begin_and_end = false;

  Axis& planar(int axis) { return axes2[axis == 0 ? 0 : 1]; }
};

struct Mistake {
  std::string name;
  GLenum error;
  std::function<void(Arguments&)> make;
};

std::vector<Mistake> axis_mistakes(int axis) {
  const std::string name = std::string(1, "uvw"[axis]);
  const auto both = [axis](auto change) {
    return [axis, change](Arguments& arguments) {
      change(arguments.axes3[axis], kLimit3);
      change(arguments.planar(axis), kLimit2);
    };
  };
  return {{name + "1 = " + name + "2", GL_INVALID_VALUE, both([](Axis& a, int) { a.last = 0; })},
          {name + "order 0", GL_INVALID_VALUE, both([](Axis& a, int) { a.order = 0; })},
          {name + "order -1", GL_INVALID_VALUE, both([](Axis& a, int) { a.order = -1; })},
          {name + "order too high", GL_INVALID_VALUE,
           both([](Axis& a, int limit) { a.order = limit + 1; })},
          {name + "stride 2", GL_INVALID_VALUE, both([](Axis& a, int) { a.stride = 2; })}};
}

std::vector<Mistake> mistakes() {
  std::vector<Mistake> all;
  for (int axis = 0; axis < 3; ++axis) {
    for (Mistake& mistake : axis_mistakes(axis)) all.push_back(std::move(mistake));
  }
  all.push_back({"unknown target", GL_INVALID_ENUM, [](Arguments& arguments) {
                   arguments.target3 = 1;
                   arguments.target2 = 1;
                 }});
  all.push_back({"texture unit 1", GL_INVALID_OPERATION,
                 [](Arguments& arguments) { arguments.texture_unit = GL_TEXTURE1; }});
  all.push_back({"between glBegin and glEnd", GL_INVALID_OPERATION,
                 [](Arguments& arguments) { arguments.between_begin_and_end = true; }});
  return all;
}

/// The arrangement that a case has around its call.
void around(const Arguments& arguments, const std::function<void()>& call) {
  glActiveTexture(arguments.texture_unit);
  if (arguments.between_begin_and_end) glBegin(GL_POINTS);
  call();
  if (arguments.between_begin_and_end) glEnd();
  glActiveTexture(GL_TEXTURE0);
}

constexpr std::size_t kPoints = 3 * 40 * 40;  // room for every order that is tried

void call_map3(const Arguments& a) {
  static const std::vector<GLdouble> points(kPoints);
  around(a, [&] {
    const auto& [u, v, w] = a.axes3;
    glMap3d(a.target3, 0, u.last, u.stride, u.order, 0, v.last, v.stride, v.order, 0, w.last,
            w.stride, w.order, points.data());
  });
}

void call_map2(const Arguments& a) {
  static const std::vector<GLdouble> points(kPoints);
  around(a, [&] {
    const auto& [u, v] = a.axes2;
    glMap2d(a.target2, 0, u.last, u.stride, u.order, 0, v.last, v.stride, v.order, points.data());
  });
}

/// What the specification says of several mistakes: the first of its order of checks.
GLenum first_error(const std::vector<const Mistake*>& made) {
  const std::vector<std::function<bool(const Mistake&)>> order{
      [](const Mistake& m) { return m.name == "between glBegin and glEnd"; },
      [](const Mistake& m) {
        return m.error == GL_INVALID_VALUE && m.name.find("stride") == std::string::npos;
      },
      [](const Mistake& m) { return m.error == GL_INVALID_ENUM; },
      [](const Mistake& m) { return m.error == GL_INVALID_VALUE; }};
  for (const auto& is_next : order) {
    for (const Mistake* mistake : made) {
      if (is_next(*mistake)) return mistake->error;
    }
  }
  return made.empty() ? GL_NO_ERROR : made.front()->error;
}

ErrorCase case_of(const std::vector<const Mistake*>& made) {
  Arguments arguments;
  std::string name = "glMap3";
  for (const Mistake* mistake : made) {
    name += (mistake == made.front() ? ": " : ", ") + mistake->name;
    mistake->make(arguments);
  }
  return {name, first_error(made), [arguments] { call_map3(arguments); },
          [arguments] { call_map2(arguments); }};
}

}  // namespace

std::vector<ErrorCase> map_error_cases() {
  static const std::vector<Mistake> all = mistakes();
  std::vector<ErrorCase> cases{case_of({})};
  for (std::size_t a = 0; a < all.size(); ++a) {
    cases.push_back(case_of({&all[a]}));
    for (std::size_t b = a + 1; b < all.size(); ++b) {
      cases.push_back(case_of({&all[a], &all[b]}));
      for (std::size_t c = b + 1; c < all.size(); ++c) {
        cases.push_back(case_of({&all[a], &all[b], &all[c]}));
      }
    }
  }
  return cases;
}

}  // namespace hwffd::glapi
