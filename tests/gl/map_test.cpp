// glMap3 and glEvalCoord3: values against eq. (1), and state.

#include <gtest/gtest.h>

#include <cmath>
#include <thread>

#include "context.hpp"
#include "scene.hpp"

namespace hwffd::gltest {
namespace {

using glapi::Context;
using glapi::error_of;
using glapi::Seen;

class Map : public testing::Test {
 protected:
  ~Map() override { reset_state(); }

  std::vector<Seen> seen_at(const std::vector<Eigen::Vector3d>& uvw) {
    return glapi::seen([&] {
      glBegin(GL_POINTS);
      for (const Eigen::Vector3d& at : uvw) glEvalCoord3dv(at.data());
      glEnd();
    });
  }

  std::vector<Eigen::Vector3d> positions(int count) {
    std::vector<Eigen::Vector3d> all{{0, 0, 0}, {1, 1, 1}, {0, 1, 0.5}};
    while (static_cast<int>(all.size()) < count) {
      all.emplace_back(random_.unit(), random_.unit(), random_.unit());
    }
    return all;
  }

  Context context_;
  tb::Random random_{7};
};

/// A point of the domain at a position, 0 to 1 an axis.
Eigen::Vector3d in_domain(const std::array<double, 6>& domain, const Eigen::Vector3d& position) {
  Eigen::Vector3d at;
  for (int axis = 0; axis < 3; ++axis) {
    const double first = domain[2 * axis];
    at[axis] = first + position[axis] * (domain[2 * axis + 1] - first);
  }
  return at;
}

struct DeviceCase {
  const char* name;
  double tolerance;
};

const DeviceCase kDevices[] = {{"reference", 2e-6},        {"model", 2e-6},
                               {"model:tree4:fp32", 2e-6}, {"rtl:basic:fp32", 2e-6},
                               {"model:basic:fx18", 5e-4}, {"rtl:basic:fx18", 5e-4}};

TEST_F(Map, BezierVolumesOfEveryOrderInEveryDomain) {
  int compared = 0;
  const std::array<double, 6> domain{2, -1, 0.5, 4, 10, 10.25};  // u runs backwards
  glEnableMap3(GL_MAP3_VERTEX_3);
  for (const Index3& points :
       {Index3{1, 2, 3}, Index3{4, 3, 2}, Index3{2, 1, 4}, Index3{4, 4, 4}}) {
    const RandomMap map(random_, points, 3);
    map.define(GL_MAP3_VERTEX_3, domain);
    const std::array<int, 3> degrees{points[0] - 1, points[1] - 1, points[2] - 1};
    const std::vector<Eigen::Vector3d> at = positions(10);
    std::vector<Eigen::Vector3d> uvw;
    for (const Eigen::Vector3d& position : at) uvw.push_back(in_domain(domain, position));
    for (const DeviceCase& device : kDevices) {
      glFfdDevice(device.name);
      const std::vector<Seen> seen = seen_at(uvw);
      ASSERT_EQ(seen.size(), at.size());
      for (std::size_t v = 0; v < at.size(); ++v, ++compared) {
        const Eigen::VectorXd expected = map.expected(
            {bernstein(degrees[0]), bernstein(degrees[1]), bernstein(degrees[2])}, degrees, at[v]);
        EXPECT_LT((seen[v].position - expected).cwiseAbs().maxCoeff(), device.tolerance)
            << device.name << " " << points[0] << points[1] << points[2] << " at "
            << at[v].transpose();
      }
    }
  }
  EXPECT_EQ(compared, 240);
}

TEST_F(Map, BlendingFunctionsOfTheirOwnAlongEachAxis) {
  int compared = 0;
  const RandomMap map(random_, {6, 4, 5}, 3);
  map.define(GL_MAP3_VERTEX_3, {0, 1, 0, 1, 0, 1});
  glEnableMap3(GL_MAP3_VERTEX_3);
  // Weights of Hermite functions do not sum to 1; small tangents keep the sum in view.
  Oracle::Coefficients hermite = Oracle::hermite();
  hermite.row(1) *= 0.25;
  hermite.row(3) *= 0.25;
  const std::array<Oracle::Coefficients, 3> functions{Oracle::uniform_bspline(), hermite,
                                                      Oracle::catmull_rom()};
  for (int axis = 0; axis < 3; ++axis) {
    glBlendCoefficientd(GL_MAP3_U + static_cast<GLenum>(axis), 3, rows_of(functions[axis]).data());
  }
  const std::vector<Eigen::Vector3d> at = positions(20);
  for (const DeviceCase& device : kDevices) {
    glFfdDevice(device.name);
    const std::vector<Seen> seen = seen_at(at);
    ASSERT_EQ(seen.size(), at.size()) << device.name;
    for (std::size_t v = 0; v < at.size(); ++v, ++compared) {
      EXPECT_LT(
          (seen[v].position - map.expected(functions, {3, 3, 3}, at[v])).cwiseAbs().maxCoeff(),
          2 * device.tolerance)
          << device.name << " at " << at[v].transpose();
    }
  }
  EXPECT_EQ(compared, 120);
}

TEST_F(Map, BlendingFunctionsOfLowDegreeHaveMoreCells) {
  const RandomMap map(random_, {14, 9, 13}, 3);
  map.define(GL_MAP3_VERTEX_3, {0, 1, 0, 1, 0, 1});
  glEnableMap3(GL_MAP3_VERTEX_3);
  const GLfloat linear[4] = {1, -1, 0, 1};
  const GLfloat quadratic[9] = {0.5F, -1, 0.5F, 0.5F, 1, -1, 0, 0, 0.5F};
  const GLfloat constant[1] = {1};
  glBlendCoefficientf(GL_MAP3_U, 1, linear);
  glBlendCoefficientf(GL_MAP3_V, 2, quadratic);
  glBlendCoefficientf(GL_MAP3_W, 0, constant);
  Oracle::Coefficients bspline2 = Oracle::Coefficients::Zero();
  bspline2.topLeftCorner<3, 3>() << 0.5, -1, 0.5, 0.5, 1, -1, 0, 0, 0.5;
  const std::vector<Eigen::Vector3d> at = positions(20);
  const std::vector<Seen> seen = seen_at(at);
  ASSERT_EQ(seen.size(), at.size());
  for (std::size_t v = 0; v < at.size(); ++v) {
    const Eigen::VectorXd expected =
        map.expected({bernstein(1), bspline2, bernstein(0)}, {1, 2, 0}, at[v]);
    EXPECT_LT((seen[v].position - expected).cwiseAbs().maxCoeff(), 2e-6) << at[v].transpose();
  }
}

TEST_F(Map, CoordinatesBeyondTheDomainAreClamped) {
  const RandomMap map(random_, {3, 3, 3}, 3);
  map.define(GL_MAP3_VERTEX_3, {0, 1, 0, 1, 0, 1});
  glEnableMap3(GL_MAP3_VERTEX_3);
  for (const char* device : {"model", "reference"}) {
    glFfdDevice(device);
    const std::vector<Seen> seen =
        seen_at({{-3, 0.5, 9}, {0, 0.5, 1}, {NAN, 0.5, 1}, {HUGE_VAL, 0.5, 1}, {1, 0.5, 1}});
    ASSERT_EQ(seen.size(), 5U);
    EXPECT_EQ(seen[0].position, seen[1].position) << device;
    EXPECT_EQ(seen[2].position, seen[1].position) << device;
    EXPECT_EQ(seen[3].position, seen[4].position) << device;
  }
}

TEST_F(Map, EveryTargetIssuesItsAttributeBeforeTheVertex) {
  const std::array<double, 6> unit{0, 1, 0, 1, 0, 1};
  const Eigen::Vector3d at(0.25, 0.5, 0.75);
  const std::array<Oracle::Coefficients, 3> functions{bernstein(1), bernstein(2), bernstein(3)};
  const auto define = [&](GLenum target, int components) {
    RandomMap map(random_, {2, 3, 4}, components);
    for (GLdouble& value : map.values) value = 0.5 + value / 2;
    if (target == GL_MAP3_VERTEX_4) map.raise(3, 1);  // the quotient stays in view
    map.define(target, unit);
    glEnableMap3(target);
    return Eigen::VectorXd(map.expected(functions, {1, 2, 3}, at));
  };
  glEnable(GL_TEXTURE_2D);
  const Eigen::VectorXd vertex = define(GL_MAP3_VERTEX_4, 4);
  define(GL_MAP3_VERTEX_3, 3);  // VERTEX_4 has precedence
  const Eigen::VectorXd color = define(GL_MAP3_COLOR_4, 4);
  const Eigen::VectorXd index = define(GL_MAP3_INDEX, 1);
  const Eigen::VectorXd normal = define(GL_MAP3_NORMAL, 3);
  for (int size = 1; size <= 4; ++size) {
    const GLenum target = GL_MAP3_TEXTURE_COORD_1 + static_cast<GLenum>(size) - 1;
    Eigen::Vector4d texture(0, 0, 0, 1);
    texture.head(size) = define(target, size);
    const std::vector<Seen> seen = seen_at({at});
    ASSERT_EQ(seen.size(), 1U);
    EXPECT_LT((seen[0].position - vertex.head<3>() / vertex[3]).norm(), 1e-5);
    EXPECT_LT((seen[0].color - color).norm(), 1e-5);
    EXPECT_LT((seen[0].texture - texture).norm(), 1e-5) << size;
  }
  GLfloat current[4];
  glGetFloatv(GL_CURRENT_NORMAL, current);
  EXPECT_LT((Eigen::Vector3f(current) - normal.cast<float>()).norm(), 1e-5);
  glGetFloatv(GL_CURRENT_INDEX, current);
  EXPECT_NEAR(current[0], index[0], 1e-5);
}

TEST_F(Map, QueriesGiveBackWhatWasGiven) {
  const RandomMap map(random_, {2, 4, 3}, 4);
  map.define(GL_MAP3_COLOR_4, {-2, 3.6, 4, 1, 0, 8});
  GLdouble order[3];
  glGetMap3dv(GL_MAP3_COLOR_4, GL_ORDER, order);
  EXPECT_EQ(Eigen::Vector3d(order), Eigen::Vector3d(2, 4, 3));
  GLfloat domain[6];
  glGetMap3fv(GL_MAP3_COLOR_4, GL_DOMAIN, domain);
  EXPECT_EQ(std::vector<GLfloat>(domain, domain + 6), (std::vector<GLfloat>{-2, 3.6F, 4, 1, 0, 8}));
  GLint rounded[6];
  glGetMap3iv(GL_MAP3_COLOR_4, GL_DOMAIN, rounded);
  EXPECT_EQ(std::vector<GLint>(rounded, rounded + 6), (std::vector<GLint>{-2, 4, 4, 1, 0, 8}));
  GLdouble values[96];
  glGetMap3dv(GL_MAP3_COLOR_4, GL_COEFF, values);
  for (int i = 0, n = 0; i < 2; ++i) {
    for (int j = 0; j < 4; ++j) {
      for (int k = 0; k < 3; ++k) {
        for (int c = 0; c < 4; ++c, ++n) EXPECT_EQ(values[n], map.at(i, j, k, c)) << n;
      }
    }
  }
}

TEST_F(Map, FailedCommandsLeaveTheirStateAlone) {
  const RandomMap map(random_, {2, 2, 2}, 3);
  map.define(GL_MAP3_VERTEX_3, {0, 1, 0, 1, 0, 2});
  const GLdouble points[3] = {5, 5, 5};
  EXPECT_NE(
      error_of([&] { glMap3d(GL_MAP3_VERTEX_3, 3, 4, 3, 1, 3, 4, 3, 1, 3, 3, 3, 1, points); }),
      GLenum{GL_NO_ERROR});
  EXPECT_NE(error_of([] { glMapGrid3d(5, 0, 9, 5, 0, 9, 0, 0, 9); }), GLenum{GL_NO_ERROR});
  EXPECT_NE(error_of([&] { glBlendCoefficientd(GL_MAP3_U, 7, points); }), GLenum{GL_NO_ERROR});
  GLdouble got[6];
  glGetMap3dv(GL_MAP3_VERTEX_3, GL_ORDER, got);
  EXPECT_EQ(Eigen::Vector3d(got), Eigen::Vector3d(2, 2, 2));
  glGetMap3dv(GL_MAP3_VERTEX_3, GL_DOMAIN, got);
  EXPECT_EQ(got[5], 2);
  glGetEval3dv(GL_MAP3_GRID_SEGMENTS, got);
  EXPECT_EQ(Eigen::Vector3d(got), Eigen::Vector3d(1, 1, 1));
  glGetBlendCoefficientdv(GL_MAP3_U, GL_ORDER, got);
  EXPECT_EQ(got[0], 0);
}

TEST_F(Map, FloatsOfTheBSplineAreTakenAsTheBSpline) {
  std::vector<GLfloat> floats;
  for (const GLdouble value : rows_of(Oracle::uniform_bspline())) {
    floats.push_back(static_cast<GLfloat>(value));
  }
  glBlendCoefficientf(GL_MAP3_V, 3, floats.data());
  GLdouble order = 0;
  glGetBlendCoefficientdv(GL_MAP3_V, GL_ORDER, &order);
  EXPECT_EQ(order, 4);
  std::vector<GLdouble> got(16);
  glGetBlendCoefficientdv(GL_MAP3_V, GL_COEFF, got.data());
  EXPECT_EQ(got, rows_of(Oracle::uniform_bspline()));
}

TEST_F(Map, InitialStateIsThatOfOpenGl) {
  const std::vector<std::vector<GLdouble>> initial{
      {1, 1, 1, 1}, {1}, {0, 0, 1}, {0}, {0, 0}, {0, 0, 0}, {0, 0, 0, 1}, {0, 0, 0}, {0, 0, 0, 1}};
  // A new thread has a state of its own, and no context until it makes one current.
  std::thread([&] {
    const Context context;
    for (GLenum map = GL_MAP3_COLOR_4; map <= GL_MAP3_VERTEX_4; ++map) {
      const std::vector<GLdouble>& expected = initial[map - GL_MAP3_COLOR_4];
      std::vector<GLdouble> points(expected.size());
      glGetMap3dv(map, GL_COEFF, points.data());
      EXPECT_EQ(points, expected) << map;
      std::vector<GLdouble> planar(expected.size());
      glGetMapdv(map - GL_MAP3_COLOR_4 + GL_MAP2_COLOR_4, GL_COEFF, planar.data());
      EXPECT_EQ(planar, expected) << "OpenGL's own, beside " << map;
      EXPECT_FALSE(glIsEnabledMap3(map)) << map;
    }
    EXPECT_FALSE(glIsEnabledMap3(GL_AUTO_NORMAL));
    GLdouble limit = 0;
    glGetEval3dv(GL_MAX_EVAL3_ORDER, &limit);
    EXPECT_EQ(limit, 16);
  }).join();
}

}  // namespace
}  // namespace hwffd::gltest
