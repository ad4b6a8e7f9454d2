// glFFD and the devices: an interleaved stream gives the positions of eq. (1).

#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>

#include "context.hpp"
#include "hwffd/device/device.hpp"
#include "scene.hpp"

namespace hwffd::gltest {
namespace {

using glapi::error_of;
using glapi::Seen;

constexpr int kVertices = 40;
constexpr int kNumbers = 195;  // a vertex

class Stream : public testing::Test {
 protected:
  Stream() {
    for (int v = 0; v < kVertices; ++v) {
      for (int axis = 0; axis < 3; ++axis) stream_.push_back(random_.unit());
      for (int number = 3; number < kNumbers; ++number) {
        stream_.push_back(uniform(random_, -0.9, 0.9));
      }
    }
    for (GLenum axis = GL_MAP3_U; axis <= GL_MAP3_W; ++axis) {
      glBlendCoefficientd(axis, 3, rows_of(Oracle::uniform_bspline()).data());
    }
  }
  ~Stream() override {
    unsetenv("HWFFD_DEVICE");
    reset_state();
  }

  Eigen::Vector3d expected(int vertex) const {
    const double* from = &stream_[static_cast<std::size_t>(vertex * kNumbers)];
    const Support support = Eigen::Map<const Support>(from + 3);
    return Oracle().evaluate(support, from[0], from[1], from[2]);
  }

  void expect_all(double tolerance, const std::string& what) {
    const std::vector<Seen> seen =
        glapi::seen([&] { glFFD(GL_POINTS, kVertices, GL_DOUBLE, stream_.data()); });
    ASSERT_EQ(seen.size(), std::size_t{kVertices}) << what;
    for (int v = 0; v < kVertices; ++v) {
      EXPECT_LT((seen[v].position - expected(v)).cwiseAbs().maxCoeff(), tolerance)
          << what << " " << v;
    }
  }

  glapi::Context context_;
  tb::Random random_{11};
  std::vector<GLdouble> stream_;
};

TEST_F(Stream, EveryDevice) {
  for (const char* device :
       {"reference", "model", "model:parallel:fp32", "rtl", "rtl:basic:fx32"}) {
    glFfdDevice(device);
    expect_all(2e-6, device);
  }
  for (const char* device : {"model:parallel:fx18", "rtl:basic:fx18"}) {
    glFfdDevice(device);
    expect_all(2e-4, device);
  }
}

TEST_F(Stream, FloatsAndDoublesAndPrimitives) {
  const std::vector<GLfloat> floats(stream_.begin(), stream_.end());
  const std::vector<Seen> strip =
      glapi::seen([&] { glFFD(GL_LINE_STRIP, kVertices, GL_FLOAT, floats.data()); });
  ASSERT_EQ(strip.size(), std::size_t{2 * (kVertices - 1)});
  for (int v = 0; v + 1 < kVertices; ++v) {
    EXPECT_LT((strip[2 * v].position - expected(v)).norm(), 2e-6) << v;
    EXPECT_LT((strip[2 * v + 1].position - expected(v + 1)).norm(), 2e-6) << v;
  }
}

TEST_F(Stream, TheEnvironmentNamesTheDevice) {
  setenv("HWFFD_DEVICE", "model:basic:fx18", 1);
  glFfdDevice(nullptr);
  const std::vector<Seen> coarse =
      glapi::seen([&] { glFFD(GL_POINTS, kVertices, GL_DOUBLE, stream_.data()); });
  ASSERT_EQ(coarse.size(), std::size_t{kVertices});
  double largest = 0;
  for (int v = 0; v < kVertices; ++v) {
    largest = std::max(largest, (coarse[v].position - expected(v)).norm());
  }
  EXPECT_GT(largest, 1e-5);  // eighteen bits show
  EXPECT_LT(largest, 1e-3);
  setenv("HWFFD_DEVICE", "abacus", 1);
  EXPECT_EQ(error_of([] { glFfdDevice(nullptr); }), GLenum{GL_INVALID_VALUE});
}

TEST_F(Stream, ReadingStreamsGivesTheBitsOfResidentLattices) {
  // One cell: the lattice of the first vertex, with the places of all.
  std::vector<SupportedVertex> interleaved;
  std::vector<Embedded> resident;
  const Support support = Eigen::Map<const Support>(&stream_[3]);
  for (int v = 0; v < kVertices; ++v) {
    const Eigen::Vector3d local(&stream_[static_cast<std::size_t>(v * kNumbers)]);
    interleaved.push_back({local, support});
    resident.push_back({{0, 0, 0}, local, true});
  }
  const Lattice lattice({4, 4, 4}, Points(support));
  const Oracle::Coefficients bspline = Oracle::uniform_bspline();
  int compared = 0;
  for (const char* format : {"fp32", "fx18"}) {
    for (const char* kind : {"model", "rtl", "reference"}) {
      const auto device = make_device({kind, "basic", format});
      const Points a = device->evaluate(interleaved, {bspline, bspline, bspline});
      const Points b = device->evaluate(lattice, resident);
      EXPECT_EQ(a, b) << kind << " " << format;
      compared += static_cast<int>(a.rows());
    }
  }
  EXPECT_EQ(compared, 6 * kVertices);
}

TEST_F(Stream, NumbersThatAreNotFiniteAreRefused) {
  stream_[100] = HUGE_VAL;
  EXPECT_EQ(error_of([&] { glFFD(GL_POINTS, kVertices, GL_DOUBLE, stream_.data()); }),
            GLenum{GL_INVALID_OPERATION});
}

}  // namespace
}  // namespace hwffd::gltest
