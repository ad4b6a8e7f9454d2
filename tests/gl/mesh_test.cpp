// glMapGrid3, glEvalPoint3 and glEvalMesh3 in three dimensions.

#include <gtest/gtest.h>

#include <limits>

#include "context.hpp"
#include "scene.hpp"

namespace hwffd::gltest {
namespace {

using glapi::error_of;
using glapi::Seen;

class Mesh3 : public testing::Test {
 protected:
  Mesh3() {
    // The identity: the volume's points are the corners of the unit cube.
    GLdouble corners[2][2][2][3];
    for (int i = 0; i < 2; ++i) {
      for (int j = 0; j < 2; ++j) {
        for (int k = 0; k < 2; ++k) {
          corners[i][j][k][0] = i;
          corners[i][j][k][1] = j;
          corners[i][j][k][2] = k;
        }
      }
    }
    glMap3d(GL_MAP3_VERTEX_3, 0, 1, 12, 2, 0, 1, 6, 2, 0, 1, 3, 2, &corners[0][0][0][0]);
    glEnableMap3(GL_MAP3_VERTEX_3);
    glMapGrid3d(4, 0, 1, 2, 1, 0, 5, 0, 0.5);
  }
  ~Mesh3() override { reset_state(); }

  static Eigen::Vector3d grid_point(int i, int j, int k) {
    return {i / 4.0, 1 - j / 2.0, k / 10.0};
  }

  /// Compares with grid points by their numbers.
  static void expect_points(const std::vector<Seen>& seen, const std::vector<Index3>& numbers) {
    ASSERT_EQ(seen.size(), numbers.size());
    for (std::size_t v = 0; v < seen.size(); ++v) {
      const auto& [i, j, k] = numbers[v];
      EXPECT_LT((seen[v].position - grid_point(i, j, k)).norm(), 1e-6) << v;
    }
  }

  glapi::Context context_;
};

TEST_F(Mesh3, PointsRunAlongUThenVThenW) {
  std::vector<Index3> numbers;
  for (int k = 2; k <= 5; ++k) {
    for (int j = 0; j <= 1; ++j) {
      for (int i = 1; i <= 4; ++i) numbers.push_back({i, j, k});
    }
  }
  expect_points(glapi::seen([] { glEvalMesh3(GL_POINT, 1, 4, 0, 1, 2, 5); }), numbers);
}

TEST_F(Mesh3, LinesRunAlongEachAxis) {
  std::vector<Index3> numbers;
  const auto line = [&numbers](const Index3& from, int axis, int count) {
    for (int step = 0; step < count; ++step) {
      for (const int end : {step, step + 1}) {
        Index3 at = from;
        at[axis] += end;
        numbers.push_back(at);
      }
    }
  };
  for (int k = 1; k <= 3; ++k) {
    for (int j = 0; j <= 2; ++j) line({1, j, k}, 0, 3);
  }
  for (int k = 1; k <= 3; ++k) {
    for (int i = 1; i <= 4; ++i) line({i, 0, k}, 1, 2);
  }
  for (int j = 0; j <= 2; ++j) {
    for (int i = 1; i <= 4; ++i) line({i, j, 1}, 2, 2);
  }
  expect_points(glapi::seen([] { glEvalMesh3(GL_LINE, 1, 4, 0, 2, 1, 3); }), numbers);
}

TEST_F(Mesh3, EvalPointHitsTheLastPointExactly) {
  glMapGrid3f(3, 0, 0.7F, 7, 0, 0.9F, 1, 0, 1);
  const std::vector<Seen> seen = glapi::seen([] {
    glBegin(GL_POINTS);
    glEvalPoint3(3, 7, 1);
    glEvalCoord3f(0.7F, 0.9F, 1);
    glEnd();
  });
  ASSERT_EQ(seen.size(), 2U);
  EXPECT_EQ(seen[0].position, seen[1].position);
}

TEST_F(Mesh3, GridCanBeAskedFor) {
  GLdouble domain[6];
  glGetEval3dv(GL_MAP3_GRID_DOMAIN, domain);
  EXPECT_EQ(std::vector<GLdouble>(domain, domain + 6), (std::vector<GLdouble>{0, 1, 1, 0, 0, 0.5}));
  GLdouble segments[3];
  glGetEval3dv(GL_MAP3_GRID_SEGMENTS, segments);
  EXPECT_EQ(Eigen::Vector3d(segments), Eigen::Vector3d(4, 2, 5));
}

TEST_F(Mesh3, NumbersUpToTheLargest) {
  constexpr GLint kMost = std::numeric_limits<GLint>::max();
  constexpr GLint kLeast = std::numeric_limits<GLint>::min();
  for (const GLenum mode : {GLenum{GL_POINT}, GLenum{GL_LINE}}) {
    EXPECT_EQ(error_of([&] { glEvalMesh3(mode, kMost, kMost, kMost, kMost, kMost, kMost); }),
              GLenum{GL_NO_ERROR});
    EXPECT_EQ(error_of([&] { glEvalMesh3(mode, kMost - 2, kMost, 0, 1, kLeast, kLeast + 1); }),
              GLenum{GL_NO_ERROR});
    for (const GLint first : {0, kLeast}) {
      EXPECT_EQ(error_of([&] { glEvalMesh3(mode, first, kMost, first, kMost, first, kMost); }),
                GLenum{GL_INVALID_OPERATION});
    }
    EXPECT_EQ(error_of([&] { glEvalMesh3(mode, kLeast, kMost, 0, 0, 0, 0); }),
              GLenum{GL_INVALID_OPERATION});
  }
}

TEST_F(Mesh3, MapsAreSwitchedOnAndOff) {
  EXPECT_TRUE(glIsEnabledMap3(GL_MAP3_VERTEX_3));
  glDisableMap3(GL_MAP3_VERTEX_3);
  EXPECT_FALSE(glIsEnabledMap3(GL_MAP3_VERTEX_3));
  EXPECT_TRUE(glapi::seen([] { glEvalMesh3(GL_POINT, 0, 1, 0, 1, 0, 1); }).empty());
  glEnableMap3(GL_AUTO_NORMAL);
  EXPECT_TRUE(glIsEnabledMap3(GL_AUTO_NORMAL));
}

}  // namespace
}  // namespace hwffd::gltest
