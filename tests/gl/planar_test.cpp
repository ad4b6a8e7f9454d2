// A volume of one point along w is a surface: the same vertices as from OpenGL's own evaluators.

#define GL_GLEXT_PROTOTYPES
#include <GL/gl.h>
#include <GL/glext.h>
#include <gtest/gtest.h>

#include <functional>

#include "context.hpp"
#include "scene.hpp"

namespace hwffd::gltest {
namespace {

using glapi::Seen;

class Planar : public testing::Test {
 protected:
  Planar() {
    glEnable(GL_MAP2_VERTEX_3);
    glEnable(GL_MAP2_COLOR_4);
    glEnableMap3(GL_MAP3_VERTEX_3);
    glEnableMap3(GL_MAP3_COLOR_4);
    define(GL_MAP3_VERTEX_3, GL_MAP2_VERTEX_3, 3);
    define(GL_MAP3_COLOR_4, GL_MAP2_COLOR_4, 4);
  }
  ~Planar() override { reset_state(); }

  /// The same random surface for both, over a domain that runs backwards along v.
  void define(GLenum target3, GLenum target2, int components) {
    RandomMap map(random_, {3, 4, 1}, components);
    for (GLdouble& value : map.values) value = 0.5 + value / 2;
    if (target3 == GL_MAP3_VERTEX_4) map.raise(3, 1);  // the quotient stays in view
    map.define(target3, {0, 2, 1, -1, 0, 1});
    glMap2d(target2, 0, 2, map.strides[0], 3, 1, -1, map.strides[1], 4, map.values.data());
  }

  /// Compares what both draw, of at least `least` vertices.
  void expect_same(const std::function<void()>& volume, const std::function<void()>& surface,
                   std::size_t least) {
    const std::vector<Seen> ours = glapi::seen(volume);
    const std::vector<Seen> theirs = glapi::seen(surface);
    ASSERT_GE(theirs.size(), least);
    ASSERT_EQ(ours.size(), theirs.size());
    for (std::size_t v = 0; v < ours.size(); ++v) {
      EXPECT_LT((ours[v].position - theirs[v].position).norm(), 1e-5) << v;
      EXPECT_LT((ours[v].color - theirs[v].color).norm(), 1e-5) << v;
    }
  }

  glapi::Context context_;
  tb::Random random_{3};
};

TEST_F(Planar, EvalCoord) {
  std::vector<std::array<GLdouble, 2>> at{{0, -1}, {2, 1}, {0, 1}};
  while (at.size() < 30) at.push_back({uniform(random_, 0, 2), uniform(random_, -1, 1)});
  const auto points = [&at](auto evaluate) {
    return [&at, evaluate] {
      glBegin(GL_POINTS);
      for (const auto& [u, v] : at) evaluate(u, v);
      glEnd();
    };
  };
  expect_same(points([](GLdouble u, GLdouble v) { glEvalCoord3d(u, v, 0.5); }),
              points([](GLdouble u, GLdouble v) { glEvalCoord2d(u, v); }), 30);
}

TEST_F(Planar, EvalMeshInPointsAndLines) {
  glMapGrid3d(5, 0.25, 1.75, 3, 0.5, -0.5, 2, 0, 1);
  glMapGrid2d(5, 0.25, 1.75, 3, 0.5, -0.5);
  expect_same([] { glEvalMesh3(GL_POINT, 0, 5, 1, 3, 1, 1); },
              [] { glEvalMesh2(GL_POINT, 0, 5, 1, 3); }, 18);
  expect_same([] { glEvalMesh3(GL_LINE, 1, 5, 0, 3, 0, 0); },
              [] { glEvalMesh2(GL_LINE, 1, 5, 0, 3); }, 62);
}

TEST_F(Planar, EvalPoint) {
  glMapGrid3f(4, 0, 2, 3, 1, -1, 1, 0, 1);
  glMapGrid2f(4, 0, 2, 3, 1, -1);
  const auto strip = [](auto evaluate) {
    return [evaluate] {
      glBegin(GL_LINE_STRIP);
      for (GLint i = 0; i <= 4; ++i) evaluate(i, 3 - i % 4);
      glEnd();
    };
  };
  expect_same(strip([](GLint i, GLint j) { glEvalPoint3(i, j, 0); }),
              strip([](GLint i, GLint j) { glEvalPoint2(i, j); }), 8);
}

TEST_F(Planar, DisabledVerticesDrawNothing) {
  glDisableMap3(GL_MAP3_VERTEX_3);
  glDisable(GL_MAP2_VERTEX_3);
  expect_same([] { glEvalMesh3(GL_POINT, 0, 1, 0, 1, 0, 1); },
              [] { glEvalMesh2(GL_POINT, 0, 1, 0, 1); }, 0);
}

TEST_F(Planar, AutomaticNormals) {
  glMapGrid3d(4, 0, 2, 4, 1, -1, 1, 0, 1);
  glMapGrid2d(4, 0, 2, 4, 1, -1);
  glEnable(GL_AUTO_NORMAL);
  glEnableMap3(GL_AUTO_NORMAL);
  const std::vector<Seen> theirs = glapi::seen_normals([] { glEvalMesh2(GL_POINT, 0, 4, 0, 4); });
  ASSERT_EQ(theirs.size(), 25U);
  for (const auto& [device, tolerance] :
       {std::pair("reference", 1e-5), std::pair("model", 1e-5), std::pair("model:basic:fx18", 3e-2),
        std::pair("rtl:basic:fx32", 1e-5)}) {
    glFfdDevice(device);
    const std::vector<Seen> ours =
        glapi::seen_normals([] { glEvalMesh3(GL_POINT, 0, 4, 0, 4, 0, 0); });
    ASSERT_EQ(ours.size(), theirs.size());
    for (std::size_t v = 0; v < ours.size(); ++v) {
      EXPECT_NEAR(theirs[v].texture.head<3>().norm(), 1, 1e-5) << v;
      EXPECT_LT((ours[v].texture - theirs[v].texture).head<3>().norm(), tolerance) << device << v;
    }
  }
}

TEST_F(Planar, AutomaticNormalsOfHomogeneousVertices) {
  glDisableMap3(GL_MAP3_VERTEX_3);
  glDisable(GL_MAP2_VERTEX_3);
  glEnableMap3(GL_MAP3_VERTEX_4);
  glEnable(GL_MAP2_VERTEX_4);
  define(GL_MAP3_VERTEX_4, GL_MAP2_VERTEX_4, 4);
  glMapGrid3d(4, 0, 2, 4, 1, -1, 1, 0, 1);
  glMapGrid2d(4, 0, 2, 4, 1, -1);
  glEnable(GL_AUTO_NORMAL);
  glEnableMap3(GL_AUTO_NORMAL);
  const auto ours = glapi::seen_normals([] { glEvalMesh3(GL_POINT, 0, 4, 0, 4, 0, 0); });
  const auto theirs = glapi::seen_normals([] { glEvalMesh2(GL_POINT, 0, 4, 0, 4); });
  ASSERT_EQ(theirs.size(), 25U);
  ASSERT_EQ(ours.size(), theirs.size());
  for (std::size_t v = 0; v < ours.size(); ++v) {
    EXPECT_NEAR(theirs[v].texture.head<3>().norm(), 1, 1e-5) << v;
    EXPECT_LT((ours[v].texture - theirs[v].texture).head<3>().norm(), 1e-4) << v;
  }
}

TEST_F(Planar, MeshesLeaveTheContextAsItWas) {
  glColor4f(0.25F, 0.5F, 0.75F, 1);
  GLuint buffer = 0;
  glGenBuffers(1, &buffer);
  glBindBuffer(GL_ARRAY_BUFFER, buffer);
  glEnableClientState(GL_NORMAL_ARRAY);
  glEvalMesh3(GL_LINE, 0, 1, 0, 1, 0, 1);
  GLfloat color[4];
  glGetFloatv(GL_CURRENT_COLOR, color);
  EXPECT_EQ(std::vector<GLfloat>(color, color + 4), (std::vector<GLfloat>{0.25F, 0.5F, 0.75F, 1}));
  GLint bound = 0;
  glGetIntegerv(GL_ARRAY_BUFFER_BINDING, &bound);
  EXPECT_EQ(bound, static_cast<GLint>(buffer));
  glGetIntegerv(GL_VERTEX_ARRAY_BINDING, &bound);
  EXPECT_EQ(bound, 0);
  EXPECT_TRUE(glIsEnabled(GL_NORMAL_ARRAY));
  EXPECT_FALSE(glIsEnabled(GL_VERTEX_ARRAY));
  EXPECT_EQ(glGetError(), GLenum{GL_NO_ERROR});
}

}  // namespace
}  // namespace hwffd::gltest
