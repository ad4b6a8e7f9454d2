#include "picture/renderer.hpp"

#include <gtest/gtest.h>
#include <stdlib.h>

#include "colours.hpp"
#include "errors.hpp"
#include "picture/opengl.hpp"

namespace hwffd::picture {
namespace {

/// From (0, 0, 2) with a right angle: at z = 0 the picture shows -2 to 2.
Camera straight() {
  Camera camera;
  camera.angle = 90;
  camera.eye = Point(0, 0, 2);
  return camera;
}

void red() { glColor3f(0.9f, 0.1f, 0.1f); }
void blue() { glColor3f(0.1f, 0.1f, 0.9f); }

/// A triangle at this depth with the corners (-1, -1), (1, -1), (-1, 1), facing the eye.
void triangle(double z) {
  glNormal3f(0, 0, 1);
  glBegin(GL_TRIANGLES);
  glVertex3d(-1, -1, z);
  glVertex3d(1, -1, z);
  glVertex3d(-1, 1, z);
  glEnd();
}

/// A grey square that fills the picture, with this normal.
void wall(const Eigen::Vector3f& normal) {
  glColor3f(0.7f, 0.7f, 0.7f);
  glNormal3fv(normal.data());
  glBegin(GL_QUADS);
  for (const auto& [x, y] : {std::pair(-3, -3), {3, -3}, {3, 3}, {-3, 3}}) glVertex3d(x, y, 0);
  glEnd();
}

TEST(Renderer, ATriangleIsWhereItBelongs) {
  const Image image = Renderer(80, 80).render(straight(), [] {
    red();
    triangle(0);
  });
  ASSERT_EQ(image.width, 80);
  ASSERT_EQ(image.height, 80);
  ASSERT_EQ(image.pixels.size(), 6400u);
  EXPECT_TRUE(is_red(image.at(25, 55)));         // lower left, rows run from the top
  EXPECT_TRUE(is_background(image.at(55, 25)));  // beyond the long edge
  EXPECT_TRUE(is_background(image.at(25, 15)));
  EXPECT_NEAR(count(image, is_red), 800, 25);  // 40 x 40 / 2
  // The long edge runs from pixel to pixel corner; half covered pixels are mixed.
  const int mixed = count(image, [](const Pixel& p) { return !is_background(p) && p[2] > 60; });
  EXPECT_GE(mixed, 38);
  EXPECT_LE(mixed, 42);
}

TEST(Renderer, PicturesHaveTheirSizeAndShape) {
  const Renderer renderer(121, 47);
  EXPECT_NEAR(renderer.aspect(), 121.0 / 47.0, 1e-15);
  const Image image = renderer.render(straight(), [] {});
  EXPECT_EQ(image.width, 121);
  EXPECT_EQ(image.height, 47);
  EXPECT_EQ(count(image, is_background), 121 * 47);
}

TEST(Renderer, WhatIsNearerHidesWhatIsBehind) {
  const Renderer renderer(40, 40);
  const auto front_first = renderer.render(straight(), [] {
    red();
    triangle(0.1);
    blue();
    triangle(0);
  });
  const auto front_last = renderer.render(straight(), [] {
    blue();
    triangle(0);
    red();
    triangle(0.1);
  });
  EXPECT_TRUE(is_red(front_first.at(12, 28)));
  EXPECT_EQ(count(front_first, is_blue), 0);
  EXPECT_EQ(front_first.pixels, front_last.pixels);
}

TEST(Renderer, LightComesFromAboveToTheLeftOnBothSides) {
  const Renderer renderer(8, 8);
  const auto lit = [&](const Eigen::Vector3f& normal) {
    return brightness(renderer.render(straight(), [&] { wall(normal); }).at(4, 4));
  };
  const int facing = lit({0, 0, 1});
  EXPECT_GT(lit({0, 0.7f, 0.7f}), facing + 20);
  EXPECT_GT(lit({-0.6f, 0.4f, 0.7f}), lit({0.6f, 0.4f, 0.7f}) + 20);
  EXPECT_LT(lit({0, -0.7f, 0.7f}), facing - 20);
  EXPECT_EQ(lit({0, 0, 10}), facing) << "normals are normalized";

  Camera behind = straight();
  behind.eye.z() = -2;
  EXPECT_EQ(brightness(renderer.render(behind, [] { wall({0, 0, 1}); }).at(4, 4)), facing);
}

TEST(Renderer, TwoRendersGiveTheSameBytes) {
  const auto scene = [] {
    red();
    triangle(0);
    blue();
    triangle(-0.5);
  };
  const Renderer renderer(90, 60);
  const Image first = renderer.render(straight(), scene);
  EXPECT_EQ(renderer.render(straight(), scene).pixels, first.pixels);
  EXPECT_EQ(Renderer(90, 60).render(straight(), scene).pixels, first.pixels);
  EXPECT_GT(count(first, is_red), 0);
}

TEST(Renderer, TwoRenderersTakeTurns) {
  const Renderer renderer(20, 20);
  const Image before = renderer.render(straight(), [] { triangle(0); });
  {
    const Renderer other(30, 10);
    EXPECT_EQ(other.render(straight(), [] { triangle(0); }).width, 30);
    EXPECT_EQ(renderer.render(straight(), [] { triangle(0); }).pixels, before.pixels);
  }
  EXPECT_EQ(renderer.render(straight(), [] { triangle(0); }).pixels, before.pixels);
}

TEST(Renderer, StateThatADrawingChangesIsPutBack) {
  const Renderer renderer(20, 20);
  const Image before = renderer.render(straight(), [] { triangle(0); });
  renderer.render(straight(), [] {
    red();
    glDisable(GL_DEPTH_TEST);
    glDepthFunc(GL_NEVER);
    glTranslated(1, 1, 1);
    glEnableClientState(GL_COLOR_ARRAY);
    GLfloat dark[] = {0, 0, 0, 1};
    glLightfv(GL_LIGHT0, GL_DIFFUSE, dark);
  });
  EXPECT_EQ(renderer.render(straight(), [] { triangle(0); }).pixels, before.pixels);
}

TEST(Renderer, EvaluatorsAndListsOfTheFixedPipelineAreThere) {
  const Renderer renderer(40, 40);
  const Image image = renderer.render(straight(), [] {
    const GLfloat corners[] = {-1, -1, 0, 1, -1, 0, -1, 1, 0, 1, 1, 0};
    red();
    glNormal3f(0, 0, 1);
    glMap2f(GL_MAP2_VERTEX_3, 0, 1, 3, 2, 0, 1, 6, 2, corners);
    glEnable(GL_MAP2_VERTEX_3);
    const GLuint list = glGenLists(1);
    glNewList(list, GL_COMPILE_AND_EXECUTE);
    glMapGrid2f(4, 0, 1, 4, 0, 1);
    glEvalMesh2(GL_FILL, 0, 4, 0, 4);
    glEndList();
    glDeleteLists(list, 1);
  });
  EXPECT_NEAR(count(image, is_red), 400, 25);
}

TEST(Renderer, ErrorsOfOpenGlAndBadSizesAreErrors) {
  const Renderer renderer(8, 8);
  expect_part(message_of<Error>([&] { renderer.render(straight(), [] { glEnable(1); }); }),
              "OpenGL error 0x0500");
  expect_part(message_of<Error>(
                  [&] { renderer.render(straight(), [] { throw Error("from the drawing"); }); }),
              "from the drawing");
  EXPECT_ERROR_PART(Renderer(0, 8), "picture of 0x8 pixels: give 1 to");
  EXPECT_ERROR_PART(Renderer(8, 1 << 20), "give 1 to");
}

/// In a process of its own: EGL keeps its display as long as a process lives.
TEST(OffscreenContextDeathTest, WithoutDriversTheErrorNamesThePackages) {
  GTEST_FLAG_SET(death_test_style, "threadsafe");
  const auto without_drivers = [] {
    ::setenv("__EGL_VENDOR_LIBRARY_FILENAMES", "/nowhere.json", 1);
    try {
      OffscreenContext context;
    } catch (const Error& error) {
      std::fprintf(stderr, "%s\n", error.what());
      std::exit(error.exit_status());
    }
    std::exit(0);
  };
  EXPECT_EXIT(without_drivers(), testing::ExitedWithCode(1),
              "no OpenGL without a display here .*; install .*libegl1 and libgl1-mesa-dri");
}

}  // namespace
}  // namespace hwffd::picture
