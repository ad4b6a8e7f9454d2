// Every row of the error tables, beside OpenGL's own commands where they can make the same mistake.

#include <gtest/gtest.h>

#include "context.hpp"
#include "error_cases.hpp"
#include "glu_error_cases.hpp"

namespace hwffd::glapi {
namespace {

TEST(GlErrors, AreThoseOfTheTablesAndOfMesa) {
  const Context context;
  int compared = 0;
  int wrong = 0;
  for (const ErrorCase& one : gl_error_cases()) {
    EXPECT_EQ(error_of(one.call), one.expected) << one.name;
    if (one.planar) {
      EXPECT_EQ(error_of(one.planar), one.expected) << "OpenGL's own, beside " << one.name;
      ++compared;
    }
    wrong += one.expected != GL_NO_ERROR ? 1 : 0;
  }
  EXPECT_GT(compared, 900);
  EXPECT_GT(wrong, 900);
}

TEST(GluErrors, ComeOnceThroughTheCallbackAlone) {
  const Context context;
  int wrong = 0;
  for (const GluErrorCase& one : glu_error_cases()) {
    std::vector<GLenum> errors;
    EXPECT_EQ(error_of([&] { errors = errors_of(one); }), GLenum{GL_NO_ERROR}) << one.name;
    if (one.expected == GL_NO_ERROR) {
      EXPECT_TRUE(errors.empty()) << one.name << ": " << errors.front();
    } else {
      EXPECT_EQ(errors, std::vector<GLenum>{one.expected}) << one.name;
      EXPECT_NE(gluFfdErrorString(one.expected), nullptr) << one.name;
      ++wrong;
    }
  }
  EXPECT_GT(wrong, 60);
}

TEST(GluErrors, EachNumberHasALineOfItsOwn) {
  std::vector<std::string> lines;
  for (GLenum error = GLU_FFD_INVALID_ENUM; error <= GLU_FFD_DEVICE_FAILED; ++error) {
    ASSERT_NE(gluFfdErrorString(error), nullptr) << error;
    for (const std::string& other : lines) EXPECT_NE(other, gluFfdErrorString(error)) << error;
    lines.emplace_back(gluFfdErrorString(error));
  }
  EXPECT_EQ(lines.size(), 15U);
  EXPECT_EQ(gluFfdErrorString(GL_NO_ERROR), nullptr);
  EXPECT_EQ(gluFfdErrorString(GLU_FFD_DEVICE_FAILED + 1), nullptr);
}

}  // namespace
}  // namespace hwffd::glapi
