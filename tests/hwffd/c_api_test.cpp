// The C API: what it computes, and that no call of it ends the program.

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <fstream>
#include <limits>
#include <memory>
#include <string>
#include <vector>

#include "hwffd/hwffd.h"
#include "hwffd/registers.h"

namespace {

struct Free {
  void operator()(hwffd_lattice* lattice) const { hwffd_lattice_free(lattice); }
};
using Lattice = std::unique_ptr<hwffd_lattice, Free>;

const double kCorners[6] = {-1, -1, -1, 1, 1, 1};
const double kPoints[9] = {0.25, 0.5, 0.125, -0.5, 0, 0.75, 0, -0.9, 0};

Lattice ball() { return Lattice(hwffd_lattice_around("sphere", nullptr, kCorners, 2)); }

std::vector<std::uint64_t> bits(const double* numbers, std::size_t count) {
  std::vector<std::uint64_t> words(count);
  std::memcpy(words.data(), numbers, count * sizeof(double));
  return words;
}

bool says(const char* word) { return std::strstr(hwffd_error(), word) != nullptr; }

TEST(CApi, RestIsTheIdentity) {
  for (const char* shape : {"box", "cylinder", "sphere"}) {
    const Lattice lattice(hwffd_lattice_around(shape, nullptr, kCorners, 2));
    ASSERT_TRUE(lattice) << hwffd_error();
    double out[9];
    ASSERT_EQ(hwffd_deform(lattice.get(), kPoints, 3, out), HWFFD_OK) << hwffd_error();
    for (int i = 0; i < 9; ++i) EXPECT_NEAR(out[i], kPoints[i], 1e-6) << shape;
  }
}

TEST(CApi, EmbeddingAndEvaluationMakeADeformation) {
  const Lattice lattice = ball();
  ASSERT_EQ(hwffd_lattice_deform(lattice.get(), "twist:90"), HWFFD_OK);
  hwffd_embedding where[3];
  ASSERT_EQ(hwffd_embed(lattice.get(), kPoints, 3, where), HWFFD_OK);
  for (const hwffd_embedding& e : where) {
    EXPECT_EQ(e.status, HWFFD_INSIDE);
    EXPECT_LT(e.residual, 1e-12);
  }
  double evaluated[9], deformed_points[9];
  ASSERT_EQ(hwffd_evaluate(lattice.get(), where, 3, evaluated), HWFFD_OK);
  ASSERT_EQ(hwffd_deform(lattice.get(), kPoints, 3, deformed_points), HWFFD_OK);
  EXPECT_EQ(bits(evaluated, 9), bits(deformed_points, 9));
  double moved = 0;
  for (int i = 0; i < 9; ++i) moved = std::max(moved, std::abs(evaluated[i] - kPoints[i]));
  EXPECT_GT(moved, 0.1);
  // In place.
  std::vector<double> same(kPoints, kPoints + 9);
  ASSERT_EQ(hwffd_deform(lattice.get(), same.data(), 3, same.data()), HWFFD_OK);
  EXPECT_EQ(bits(same.data(), 9), bits(deformed_points, 9));
}

TEST(CApi, ControlPointsMove) {
  const int dims[3] = {4, 5, 6};
  std::vector<double> points;
  for (int i = 0; i < 4; ++i) {
    for (int j = 0; j < 5; ++j) {
      for (int k = 0; k < 6; ++k) points.insert(points.end(), {i - 1.0, j - 1.0, k - 1.0});
    }
  }
  const Lattice lattice(hwffd_lattice_new(dims, points.data()));
  ASSERT_TRUE(lattice) << hwffd_error();
  int got[3];
  hwffd_lattice_dims(lattice.get(), got);
  EXPECT_TRUE(std::equal(got, got + 3, dims));
  for (std::size_t i = 0; i < points.size(); i += 3) points[i] += 10;
  ASSERT_EQ(hwffd_lattice_move(lattice.get(), points.data()), HWFFD_OK);
  std::vector<double> copy(points.size());
  hwffd_lattice_points(lattice.get(), copy.data());
  EXPECT_EQ(copy, points);
  const double point[3] = {0.5, 0.5, 0.5};
  double out[3];
  ASSERT_EQ(hwffd_deform(lattice.get(), point, 1, out), HWFFD_OK);
  EXPECT_NEAR(out[0], 10.5, 1e-5);
  EXPECT_NEAR(out[1], 0.5, 1e-5);
}

TEST(CApi, DevicesAgree) {
  const Lattice lattice = ball();
  ASSERT_EQ(hwffd_lattice_deform(lattice.get(), "bend:45"), HWFFD_OK);
  double unnamed[9], model[9], rtl[9], reference[9];
  ASSERT_EQ(hwffd_deform(lattice.get(), kPoints, 3, unnamed), HWFFD_OK);
  ASSERT_EQ(hwffd_lattice_device(lattice.get(), "model", nullptr, nullptr), HWFFD_OK);
  ASSERT_EQ(hwffd_deform(lattice.get(), kPoints, 3, model), HWFFD_OK);
  ASSERT_EQ(hwffd_lattice_device(lattice.get(), "rtl", nullptr, nullptr), HWFFD_OK)
      << hwffd_error();
  ASSERT_EQ(hwffd_deform(lattice.get(), kPoints, 3, rtl), HWFFD_OK);
  ASSERT_EQ(hwffd_lattice_device(lattice.get(), "reference", nullptr, nullptr), HWFFD_OK);
  ASSERT_EQ(hwffd_deform(lattice.get(), kPoints, 3, reference), HWFFD_OK);
  EXPECT_EQ(bits(unnamed, 9), bits(reference, 9));
  EXPECT_EQ(bits(model, 9), bits(rtl, 9));
  for (int i = 0; i < 9; ++i) EXPECT_NEAR(model[i], reference[i], 1e-6);
}

TEST(CApi, ADeviceIsNamedWithItsOrganizationAndFormat) {
  const Lattice lattice = ball();
  ASSERT_EQ(hwffd_lattice_deform(lattice.get(), "bend:45"), HWFFD_OK);
  double exact[9], coarse[9];
  ASSERT_EQ(hwffd_deform(lattice.get(), kPoints, 3, exact), HWFFD_OK);
  ASSERT_EQ(hwffd_lattice_device(lattice.get(), "model", "factored/3", "fx18"), HWFFD_OK)
      << hwffd_error();
  ASSERT_EQ(hwffd_deform(lattice.get(), kPoints, 3, coarse), HWFFD_OK);
  double most = 0;
  for (int i = 0; i < 9; ++i) most = std::max(most, std::abs(coarse[i] - exact[i]));
  EXPECT_GT(most, 1e-6);
  EXPECT_LT(most, 1e-3);
  EXPECT_EQ(hwffd_lattice_device(lattice.get(), "model", "cg9", nullptr), HWFFD_USAGE);
  EXPECT_TRUE(says("no organization 'cg9' here")) << hwffd_error();
  EXPECT_EQ(hwffd_lattice_device(lattice.get(), "model", nullptr, "fx99"), HWFFD_USAGE);
  EXPECT_TRUE(says("no 'basic' in format 'fx99' here")) << hwffd_error();
  double same[9];
  ASSERT_EQ(hwffd_deform(lattice.get(), kPoints, 3, same), HWFFD_OK);
  EXPECT_EQ(bits(same, 9), bits(coarse, 9)) << "a device that is refused leaves the one before";
}

TEST(CApi, BitsDoNotDependOnThreads) {
  const Lattice lattice = ball();
  ASSERT_EQ(hwffd_lattice_deform(lattice.get(), "twist:90"), HWFFD_OK);
  constexpr std::size_t kCount = 17'000;
  std::vector<double> points(3 * kCount);
  for (std::size_t i = 0; i < points.size(); ++i) {
    points[i] = static_cast<double>(i * 7919 % 1000) / 1000 - 0.5;
  }
  std::vector<double> one(points.size()), three(points.size());
  hwffd_set_threads(1);
  ASSERT_EQ(hwffd_deform(lattice.get(), points.data(), kCount, one.data()), HWFFD_OK);
  hwffd_set_threads(3);
  ASSERT_EQ(hwffd_deform(lattice.get(), points.data(), kCount, three.data()), HWFFD_OK);
  hwffd_set_threads(0);
  EXPECT_EQ(bits(one.data(), one.size()), bits(three.data(), three.size()));
}

// <evaluate(P), g> = <P, pull_back(g)>, in double and nearly so in fixed point.
TEST(CApi, PullBackIsTheTransposeOfEvaluate) {
  const Lattice lattice = ball();
  ASSERT_EQ(hwffd_lattice_deform(lattice.get(), "twist:40"), HWFFD_OK);
  hwffd_embedding where[3];
  ASSERT_EQ(hwffd_embed(lattice.get(), kPoints, 3, where), HWFFD_OK);
  const double gradient[9] = {1, -2, 0.5, 0.25, 3, 0, -1, 0.125, 2};
  double moved[9];
  ASSERT_EQ(hwffd_evaluate(lattice.get(), where, 3, moved), HWFFD_OK);
  double forward = 0;
  for (int i = 0; i < 9; ++i) forward += moved[i] * gradient[i];
  int dims[3];
  ASSERT_EQ(hwffd_lattice_dims(lattice.get(), dims), HWFFD_OK);
  const auto size = 3 * static_cast<std::size_t>(dims[0]) * static_cast<std::size_t>(dims[1]) *
                    static_cast<std::size_t>(dims[2]);
  std::vector<double> points(size);
  std::vector<double> pulled(size);
  ASSERT_EQ(hwffd_lattice_points(lattice.get(), points.data()), HWFFD_OK);
  for (const char* device : {static_cast<const char*>(nullptr), "reference", "model", "rtl"}) {
    ASSERT_EQ(hwffd_pull_back(lattice.get(), device, where, 3, gradient, pulled.data()), HWFFD_OK)
        << hwffd_error();
    double back = 0;
    for (std::size_t i = 0; i < size; ++i) back += points[i] * pulled[i];
    const bool in_double = device == nullptr || device == std::string("reference");
    EXPECT_NEAR(back, forward, in_double ? 1e-13 : 1e-3);
  }
  EXPECT_EQ(hwffd_pull_back(lattice.get(), nullptr, where, 3, nullptr, pulled.data()), HWFFD_USAGE);
  EXPECT_EQ(hwffd_pull_back(nullptr, nullptr, where, 3, gradient, pulled.data()), HWFFD_USAGE);
  EXPECT_EQ(hwffd_pull_back(lattice.get(), nullptr, nullptr, 0, nullptr, pulled.data()), HWFFD_OK);
  EXPECT_EQ(pulled[0], 0);
}

TEST(CApi, PointsOutside) {
  const Lattice lattice = ball();
  ASSERT_EQ(hwffd_lattice_deform(lattice.get(), "scale:2"), HWFFD_OK);
  const double far[3] = {10, 0, 0};
  double out[3];
  ASSERT_EQ(hwffd_deform(lattice.get(), far, 1, out), HWFFD_OK);
  EXPECT_EQ(bits(out, 3), bits(far, 3));
  ASSERT_EQ(hwffd_lattice_outside(lattice.get(), "clamp"), HWFFD_OK);
  ASSERT_EQ(hwffd_deform(lattice.get(), far, 1, out), HWFFD_OK);
  EXPECT_GT(out[0], 10.5);
  hwffd_embedding where;
  ASSERT_EQ(hwffd_embed(lattice.get(), far, 1, &where), HWFFD_OK);
  EXPECT_EQ(where.status, HWFFD_OUTSIDE);
}

TEST(CApi, PointsOutsideAreCounted) {
  const Lattice lattice = ball();
  EXPECT_EQ(hwffd_outside(lattice.get()), 0u) << "before any point was deformed";
  const double points[9] = {10, 0, 0, 0.1, 0.2, 0.3, 0, -5, 0};
  double out[9];
  for (const char* outside : {"keep", "clamp"}) {
    ASSERT_EQ(hwffd_lattice_outside(lattice.get(), outside), HWFFD_OK);
    ASSERT_EQ(hwffd_deform(lattice.get(), points, 3, out), HWFFD_OK);
    EXPECT_EQ(hwffd_outside(lattice.get()), 2u) << outside;
  }
  ASSERT_EQ(hwffd_deform(lattice.get(), kPoints, 3, out), HWFFD_OK);
  EXPECT_EQ(hwffd_outside(lattice.get()), 0u);
  EXPECT_EQ(hwffd_outside(nullptr), 0u);
}

TEST(CApi, NumbersThatAreNoResultsAreFailures) {
  const int dims[3] = {4, 4, 4};
  std::vector<double> points;
  for (int k = 0; k < 4; ++k) {
    for (int j = 0; j < 4; ++j) {
      for (int i = 0; i < 4; ++i) points.insert(points.end(), {k * 1e39, j * 1e39, 0});
    }
  }
  EXPECT_EQ(hwffd_lattice_new(dims, points.data()), nullptr);
  EXPECT_TRUE(says("volume")) << hwffd_error();
  for (std::size_t n = 0; n < 64; ++n) points[3 * n + 2] = static_cast<double>(n % 4) * 1e39;
  const Lattice lattice(hwffd_lattice_new(dims, points.data()));
  ASSERT_TRUE(lattice) << hwffd_error();
  ASSERT_EQ(hwffd_lattice_device(lattice.get(), "model", nullptr, nullptr), HWFFD_OK);
  const double point[3] = {1.5e39, 1.5e39, 1.5e39};
  double out[3] = {7, 7, 7};
  EXPECT_EQ(hwffd_deform(lattice.get(), point, 1, out), HWFFD_ERROR);
  EXPECT_TRUE(says("not finite")) << hwffd_error();
  EXPECT_EQ(out[0], 7);
  const double nowhere[3] = {0, std::numeric_limits<double>::quiet_NaN(), 0};
  hwffd_embedding where;
  for (const char* shape : {"box", "sphere"}) {
    const Lattice lattice(hwffd_lattice_around(shape, nullptr, kCorners, 2));
    ASSERT_EQ(hwffd_embed(lattice.get(), nowhere, 1, &where), HWFFD_OK);
    EXPECT_EQ(where.status, HWFFD_OUTSIDE) << shape;
    EXPECT_EQ(where.cell[1], 0) << shape;
    EXPECT_EQ(where.residual, HUGE_VAL) << shape;
  }
  const double far[3] = {1e160, 0, 0};
  const Lattice round = ball();
  ASSERT_EQ(hwffd_lattice_outside(round.get(), "clamp"), HWFFD_OK);
  EXPECT_EQ(hwffd_deform(round.get(), far, 1, out), HWFFD_ERROR);
}

TEST(CApi, AFileOfALatticeBringsItsFamilyAndItsDeformation) {
  const std::string path = testing::TempDir() + "c_api_lattice.json";
  std::string rest, points;
  for (int n = 0; n < 64; ++n) {
    const std::string tail = std::to_string(n / 4 % 4) + "," + std::to_string(n % 4) + "]";
    rest += (n == 0 ? "[" : ",[") + std::to_string(n / 16) + "," + tail;
    points += (n == 0 ? "[" : ",[") + std::to_string(n / 16 + 1) + "," + tail;
  }
  std::ofstream(path) << R"({"hwffd_lattice":1,"dims":[4,4,4],"family":"bernstein","rest":[)"
                      << rest << R"(],"points":[)" << points << "]}";
  const Lattice lattice(hwffd_lattice_read(path.c_str()));
  ASSERT_NE(lattice, nullptr) << hwffd_error();
  const double corner[3] = {0.25, 0.5, 2.75};  // outside of the one cell of B-splines
  double moved[3] = {0, 0, 0};
  ASSERT_EQ(hwffd_deform(lattice.get(), corner, 1, moved), HWFFD_OK) << hwffd_error();
  EXPECT_NEAR(moved[0], 1.25, 1e-12);
  EXPECT_NEAR(moved[1], 0.5, 1e-12);
  EXPECT_NEAR(moved[2], 2.75, 1e-12);
  // Without `rest` the points are those at rest.
  std::ofstream(path) << R"({"hwffd_lattice":1,"dims":[4,4,4],"family":"bernstein","points":[)"
                      << rest << "]}";
  const Lattice still(hwffd_lattice_read(path.c_str()));
  ASSERT_NE(still, nullptr) << hwffd_error();
  ASSERT_EQ(hwffd_deform(still.get(), corner, 1, moved), HWFFD_OK) << hwffd_error();
  for (int axis = 0; axis < 3; ++axis) EXPECT_NEAR(moved[axis], corner[axis], 1e-12);
}

TEST(CApi, FailuresSayWhy) {
  const int bad_dims[3] = {4, 3, 4};
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(hwffd_lattice_new(nullptr, kPoints), nullptr);
  EXPECT_TRUE(says("dims"));
  EXPECT_EQ(hwffd_lattice_new(bad_dims, kPoints), nullptr);
  EXPECT_TRUE(says("3"));
  EXPECT_EQ(hwffd_lattice_read("no-such-file.json"), nullptr);
  EXPECT_TRUE(says("no-such-file.json"));
  EXPECT_EQ(hwffd_lattice_around("cube", nullptr, kCorners, 2), nullptr);
  EXPECT_TRUE(says("sphere"));
  EXPECT_EQ(hwffd_lattice_around("box", nullptr, kCorners, 0), nullptr);
  hwffd_lattice_free(nullptr);

  const Lattice lattice = ball();
  double out[3] = {7, 7, 7};
  const double point[3] = {0, nan, 0};
  EXPECT_EQ(hwffd_deform(lattice.get(), point, 1, out), HWFFD_ERROR);
  EXPECT_EQ(out[0], 7);
  EXPECT_EQ(hwffd_deform(nullptr, point, 1, out), HWFFD_USAGE);
  EXPECT_EQ(hwffd_deform(lattice.get(), nullptr, 1, out), HWFFD_USAGE);
  EXPECT_EQ(hwffd_deform(lattice.get(), nullptr, 0, nullptr), HWFFD_OK);
  constexpr std::size_t kMost = std::size_t{1} << 56;
  EXPECT_EQ(hwffd_deform(lattice.get(), point, kMost + 1, out), HWFFD_USAGE);
  EXPECT_TRUE(says("n: 72057594037927937 points; give at most 72057594037927936"));
  EXPECT_EQ(hwffd_deform(lattice.get(), point, kMost, out), HWFFD_ERROR);
  EXPECT_STREQ(hwffd_error(), "there is not enough memory; give fewer points");
  EXPECT_EQ(hwffd_lattice_around("box", nullptr, kCorners, kMost), nullptr);
  EXPECT_STREQ(hwffd_error(), "there is not enough memory; give fewer points");
  EXPECT_EQ(hwffd_lattice_deform(lattice.get(), "twirl:3"), HWFFD_USAGE);
  EXPECT_TRUE(says("twirl"));
  EXPECT_EQ(hwffd_lattice_device(lattice.get(), "fpga", nullptr, nullptr), HWFFD_USAGE);
  EXPECT_EQ(hwffd_lattice_outside(lattice.get(), "fade:-1"), HWFFD_USAGE);
  EXPECT_EQ(hwffd_lattice_move(lattice.get(), nullptr), HWFFD_USAGE);
  hwffd_embedding where = {{0, 99, 0}, HWFFD_INSIDE, {0, 0, 0}, 0};
  EXPECT_EQ(hwffd_evaluate(lattice.get(), &where, 1, out), HWFFD_ERROR);
  where = {{0, 0, 0}, HWFFD_INSIDE, {0, nan, 0}, 0};
  EXPECT_EQ(hwffd_evaluate(lattice.get(), &where, 1, out), HWFFD_ERROR);
}

TEST(CApi, VersionOfLibraryHeadersRegistersAndProjectIsOne) {
  const std::string headers = std::to_string(HWFFD_VERSION_MAJOR) + "." +
                              std::to_string(HWFFD_VERSION_MINOR) + "." +
                              std::to_string(HWFFD_VERSION_PATCH);
  const std::string registers = std::to_string(HWFFD_VERSION_MAJOR_RESET) + "." +
                                std::to_string(HWFFD_VERSION_MINOR_RESET) + "." +
                                std::to_string(HWFFD_VERSION_PATCH_RESET);
  EXPECT_EQ(headers, HWFFD_VERSION);
  EXPECT_EQ(registers, HWFFD_VERSION);
  EXPECT_STREQ(hwffd_version(), HWFFD_VERSION);
  EXPECT_STREQ(hwffd_version(), PROJECT_VERSION);
  static_assert(HWFFD_VERSION_AT_LEAST(HWFFD_VERSION_MAJOR, HWFFD_VERSION_MINOR, 0), "as #if says");
  static_assert(!HWFFD_VERSION_AT_LEAST(HWFFD_VERSION_MAJOR, HWFFD_VERSION_MINOR + 1, 0), "newer");
}

}  // namespace
