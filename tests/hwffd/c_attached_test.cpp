// The C API's views of points and points that stay attached: what they give, and what is refused.

#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <cstring>
#include <limits>
#include <memory>
#include <string>
#include <vector>

#include "hwffd/hwffd.h"

namespace {

struct Free {
  void operator()(hwffd_lattice* lattice) const { hwffd_lattice_free(lattice); }
  void operator()(hwffd_attached* attached) const { hwffd_attached_free(attached); }
};
using Lattice = std::unique_ptr<hwffd_lattice, Free>;
using Attached = std::unique_ptr<hwffd_attached, Free>;

const double kCorners[6] = {-1, -1, -1, 1, 1, 1};
const std::vector<double> kPoints{0.25, 0.5, 0.125, -0.5, 0, 0.75, 0, -0.9, 0, 4, 0, 0};
constexpr std::size_t kCount = 4;
const double kNan = std::numeric_limits<double>::quiet_NaN();

hwffd_view view_of(const std::vector<double>& numbers) {
  return hwffd_packed(HWFFD_FLOAT64, numbers.data(), numbers.size() / 3);
}

/// A twisted lattice around the corners, and points in it but for the last.
class CAttached : public ::testing::Test {
 protected:
  CAttached()
      : lattice_(hwffd_lattice_around("sphere", nullptr, kCorners, 2)),
        points_(view_of(kPoints)),
        attached_(hwffd_attach(lattice_.get(), &points_)) {
    hwffd_lattice_deform(lattice_.get(), "twist:50");
  }

  std::vector<double> deformed() {
    std::vector<double> out(3 * kCount);
    const hwffd_view view = view_of(out);
    EXPECT_EQ(hwffd_attached_deform(attached_.get(), lattice_.get(), &view), HWFFD_OK)
        << hwffd_error();
    return out;
  }

  Lattice lattice_;
  hwffd_view points_;
  Attached attached_;
};

void expect_error(const std::string& text) { EXPECT_EQ(hwffd_error(), text); }

TEST_F(CAttached, DeformGivesTheBitsOfDeform) {
  ASSERT_TRUE(attached_) << hwffd_error();
  std::vector<double> expected(3 * kCount);
  for (const char* deformation : {"none", "bend:40"}) {
    ASSERT_EQ(hwffd_lattice_deform(lattice_.get(), deformation), HWFFD_OK);
    ASSERT_EQ(hwffd_deform(lattice_.get(), kPoints.data(), kCount, expected.data()), HWFFD_OK);
    EXPECT_EQ(deformed(), expected);
  }
  EXPECT_EQ(hwffd_outside(lattice_.get()), 1u);
  hwffd_counts counts;
  ASSERT_EQ(hwffd_attached_counts(attached_.get(), &counts), HWFFD_OK);
  EXPECT_EQ(counts.points, kCount);
  EXPECT_EQ(counts.inside, 3u);
  EXPECT_EQ(counts.outside, 1u);
  EXPECT_LT(counts.worst_residual, 1e-12);
}

TEST_F(CAttached, ViewsOfAnyStepAndType) {
  const std::vector<double> expected = deformed();
  // From the last point to the first, floats, each coordinate in an array of its own, unaligned.
  std::vector<char> bytes(1 + 3 * kCount * sizeof(float));
  const auto at = [&](std::size_t point, std::size_t c) {
    return bytes.data() + 1 + (c * kCount + kCount - 1 - point) * sizeof(float);
  };
  for (std::size_t i = 0; i < 3 * kCount; ++i) {
    const auto number = static_cast<float>(kPoints[i]);
    std::memcpy(at(i / 3, i % 3), &number, sizeof number);
  }
  const hwffd_view view{at(0, 0), kCount, HWFFD_FLOAT32, -static_cast<ptrdiff_t>(sizeof(float)),
                        kCount * sizeof(float)};
  ASSERT_EQ(hwffd_deform_view(lattice_.get(), &view, &view), HWFFD_OK) << hwffd_error();
  for (std::size_t i = 0; i < 3 * kCount; ++i) {
    float number = 0;
    std::memcpy(&number, at(i / 3, i % 3), sizeof number);
    EXPECT_NEAR(number, expected[i], 1e-6) << i;
  }
  EXPECT_EQ(bytes[0], 0);
}

TEST_F(CAttached, FamiliesAreChosenByName) {
  const int dims[3] = {4, 4, 4};
  const Lattice lattice(hwffd_lattice_around("box", dims, kCorners, 2));
  ASSERT_EQ(hwffd_lattice_family(lattice.get(), "bernstein"), HWFFD_OK) << hwffd_error();
  const hwffd_view corner = hwffd_packed(HWFFD_FLOAT64, kCorners + 3, 1);
  const Attached attached(hwffd_attach(lattice.get(), &corner));
  double points[3 * 64];
  ASSERT_EQ(hwffd_lattice_points(lattice.get(), points), HWFFD_OK);
  // The B-spline's lattice reaches from -3 to 3, the Bezier volume has its last point there.
  EXPECT_NEAR(points[3 * 63], 3, 1e-5);
  const hwffd_view far = hwffd_packed(HWFFD_FLOAT64, points + 3 * 63, 1);
  double out[3];
  const hwffd_view to = hwffd_packed_out(HWFFD_FLOAT64, out, 1);
  const Attached at_end(hwffd_attach(lattice.get(), &far));
  std::vector<double> weights(64);
  std::vector<int32_t> columns(64);
  int64_t starts[2];
  ASSERT_EQ(hwffd_attached_weight_count(at_end.get()), 64u);
  ASSERT_EQ(hwffd_attached_weights(at_end.get(), starts, columns.data(), weights.data()), HWFFD_OK);
  EXPECT_NEAR(weights[63], 1, 1e-12);
  ASSERT_EQ(hwffd_attached_deform(at_end.get(), lattice.get(), &to), HWFFD_OK);
  EXPECT_NEAR(out[2], points[3 * 63 + 2], 1e-5);
  EXPECT_EQ(hwffd_lattice_family(lattice.get(), "bezier"), HWFFD_USAGE);
  const Lattice other(hwffd_lattice_around("sphere", nullptr, kCorners, 2));
  EXPECT_EQ(hwffd_attached_deform(at_end.get(), other.get(), &to), HWFFD_ERROR);
  expect_error("these points are attached to another lattice at rest; attach them to this one");
}

TEST_F(CAttached, WeightsMakeThePointsAndPullBackTheirGradient) {
  const std::vector<double> expected = deformed();
  const std::size_t count = hwffd_attached_weight_count(attached_.get());
  ASSERT_EQ(count, 3u * 64u);
  std::vector<int64_t> starts(kCount + 1);
  std::vector<int32_t> columns(count);
  std::vector<double> values(count);
  ASSERT_EQ(hwffd_attached_weights(attached_.get(), starts.data(), columns.data(), values.data()),
            HWFFD_OK);
  EXPECT_EQ(starts.back(), static_cast<int64_t>(count));
  EXPECT_EQ(starts[3], starts[4]) << "a point that stays has none";
  int dims[3];
  ASSERT_EQ(hwffd_lattice_dims(lattice_.get(), dims), HWFFD_OK);
  const auto controls = static_cast<std::size_t>(dims[0]) * dims[1] * dims[2];
  std::vector<double> control(3 * controls), transpose(3 * controls), pulled(3 * controls);
  ASSERT_EQ(hwffd_lattice_points(lattice_.get(), control.data()), HWFFD_OK);
  std::vector<double> sum(3 * kCount);
  const hwffd_view to = view_of(sum);
  ASSERT_EQ(hwffd_attached_unmoved(attached_.get(), &to), HWFFD_OK);
  EXPECT_EQ(sum[9], 4);
  EXPECT_EQ(sum[0], 0);
  for (std::size_t i = 0; i < kCount; ++i) {
    for (auto w = static_cast<std::size_t>(starts[i]); w < static_cast<std::size_t>(starts[i + 1]);
         ++w) {
      for (std::size_t c = 0; c < 3; ++c) {
        const std::size_t from = 3 * static_cast<std::size_t>(columns[w]) + c;
        sum[3 * i + c] += values[w] * control[from];
        transpose[from] += values[w] * kPoints[3 * i + c];
      }
    }
  }
  for (std::size_t i = 0; i < sum.size(); ++i) EXPECT_NEAR(sum[i], expected[i], 1e-5);
  ASSERT_EQ(hwffd_attached_pull_back(attached_.get(), &points_, pulled.data()), HWFFD_OK);
  for (std::size_t i = 0; i < pulled.size(); ++i) EXPECT_NEAR(pulled[i], transpose[i], 1e-14);
}

TEST_F(CAttached, GradientsDeterminantsAndNormalsAgree) {
  double gradients[9 * kCount], determinants[kCount];
  const hwffd_attached* attached = attached_.get();
  ASSERT_EQ(hwffd_lattice_deform(lattice_.get(), "scale:2,3,0.5"), HWFFD_OK);
  ASSERT_EQ(hwffd_attached_gradients(attached, lattice_.get(), gradients), HWFFD_OK);
  ASSERT_EQ(hwffd_attached_determinants(attached, lattice_.get(), determinants), HWFFD_OK);
  for (std::size_t i = 0; i < 2; ++i) {
    const double* g = gradients + 9 * i;
    const double determinant = g[0] * (g[4] * g[8] - g[5] * g[7]) -
                               g[1] * (g[3] * g[8] - g[5] * g[6]) +
                               g[2] * (g[3] * g[7] - g[4] * g[6]);
    EXPECT_NEAR(determinants[i], determinant, 1e-12);
    EXPECT_GT(determinants[i], 1);
    // A normal is orthogonal to the images of vectors that were orthogonal to it.
    std::vector<double> normals(3 * kCount), out(3 * kCount);
    for (std::size_t n = 0; n < kCount; ++n) normals[3 * n + 1] = 7;
    const hwffd_view from = view_of(normals);
    const hwffd_view to = view_of(out);
    ASSERT_EQ(hwffd_attached_normals(attached, lattice_.get(), &from, &to), HWFFD_OK);
    const double* n = out.data() + 3 * i;
    EXPECT_NEAR(std::hypot(n[0], n[1], n[2]), 1, 1e-14);
    EXPECT_NEAR(g[0] * n[0] + g[3] * n[1] + g[6] * n[2], 0, 1e-13);
    EXPECT_NEAR(g[2] * n[0] + g[5] * n[1] + g[8] * n[2], 0, 1e-13);
    EXPECT_GT(g[1] * n[0] + g[4] * n[1] + g[7] * n[2], 0.1);
  }
  EXPECT_EQ(determinants[3], 1) << "a point that stays";
}

TEST_F(CAttached, ViewsThatAreNoneAreRefused) {
  std::vector<double> out(3 * kCount, 7);
  const hwffd_view to = view_of(out);
  const auto refused = [&](const hwffd_view* points, const hwffd_view* result,
                           const std::string& text) {
    EXPECT_EQ(hwffd_deform_view(lattice_.get(), points, result), HWFFD_USAGE);
    expect_error(text);
    EXPECT_EQ(out, std::vector<double>(3 * kCount, 7));
  };
  refused(nullptr, &to, "points is NULL; give it");
  refused(&points_, nullptr, "out is NULL; give it");
  hwffd_view view = points_;
  view.data = nullptr;
  refused(&view, &to, "points: data is NULL; give it");
  view = points_;
  view.type = 5;
  refused(&view, &to, "points: type 5 is unknown; give HWFFD_FLOAT32 or HWFFD_FLOAT64");
  view.type = HWFFD_FLOAT64;
  view.count = std::numeric_limits<std::size_t>::max();
  refused(&view, &to, "points: 18446744073709551615 points; give at most 72057594037927936");
  view = to;
  view.count = 3;
  refused(&points_, &view, "out: 3 points; give room for 4");
  view = to;
  view.point_bytes = 0;
  refused(&points_, &view, "out: numbers 0 and 8 bytes apart lie on each other; give at least 8");
}

TEST_F(CAttached, NumbersOfTwoPointsInOnePlaceAreRefused) {
  const auto status = [&](std::size_t count, ptrdiff_t point_bytes, ptrdiff_t coordinate_bytes) {
    std::vector<char> bytes(2000);
    const hwffd_view points = hwffd_packed(HWFFD_FLOAT64, kPoints.data(), count);
    const hwffd_view out{bytes.data() + 1000, count, HWFFD_FLOAT64, point_bytes, coordinate_bytes};
    return hwffd_deform_view(lattice_.get(), &points, &out);
  };
  for (std::size_t count = 1; count <= kCount; ++count) {
    for (ptrdiff_t point = -100; point <= 100; point += 4) {
      for (ptrdiff_t coordinate = -48; coordinate <= 48; coordinate += 4) {
        bool apart = true;
        for (std::size_t a = 0; a < 3 * count; ++a) {
          for (std::size_t b = 0; b < a; ++b) {
            const auto place = [&](std::size_t n) {
              return static_cast<ptrdiff_t>(n / 3) * point +
                     static_cast<ptrdiff_t>(n % 3) * coordinate;
            };
            apart = apart && std::abs(place(a) - place(b)) >= 8;
          }
        }
        ASSERT_EQ(status(count, point, coordinate), apart ? HWFFD_OK : HWFFD_USAGE)
            << count << " " << point << " " << coordinate;
      }
    }
  }
}

TEST_F(CAttached, NumbersThatAreNoneAreRefused) {
  std::vector<double> points = kPoints;
  points[7] = kNan;
  const hwffd_view bad = view_of(points);
  EXPECT_EQ(hwffd_attach(lattice_.get(), &bad), nullptr);
  expect_error("point 2 is not finite; give finite coordinates");
  std::vector<double> out(192 * 3, 7);
  const hwffd_view to = hwffd_packed_out(HWFFD_FLOAT64, out.data(), kCount);
  EXPECT_EQ(hwffd_attached_normals(attached_.get(), lattice_.get(), &bad, &to), HWFFD_ERROR);
  expect_error("normals 2 is not finite; give finite coordinates");
  EXPECT_EQ(hwffd_attached_pull_back(attached_.get(), &bad, out.data()), HWFFD_ERROR);
  const hwffd_view few = hwffd_packed(HWFFD_FLOAT64, points.data(), 2);
  EXPECT_EQ(hwffd_attached_pull_back(attached_.get(), &few, out.data()), HWFFD_USAGE);
  expect_error("gradient: 2 vectors; give 4, one for each attached point");
  const double far[3] = {1e40, 0, 0};
  const hwffd_view far_view = hwffd_packed(HWFFD_FLOAT64, far, 1);
  float small[3] = {7, 7, 7};
  const hwffd_view floats = hwffd_packed_out(HWFFD_FLOAT32, small, 1);
  EXPECT_EQ(hwffd_deform_view(lattice_.get(), &far_view, &floats), HWFFD_ERROR);
  expect_error("out: point 0 is beyond what float holds; give HWFFD_FLOAT64");
  EXPECT_EQ(small[0], 7);
}

TEST_F(CAttached, NullIsRefusedEverywhere) {
  double out[9 * kCount];
  const hwffd_view to = hwffd_packed_out(HWFFD_FLOAT64, out, kCount);
  const hwffd_lattice* lattice = lattice_.get();
  const hwffd_attached* attached = attached_.get();
  hwffd_counts counts;
  int64_t starts[5];
  int dims[3];
  EXPECT_EQ(hwffd_attach(nullptr, &to), nullptr);
  expect_error("lattice is NULL; give it");
  hwffd_attached_free(nullptr);
  EXPECT_EQ(hwffd_attached_weight_count(nullptr), 0u);
  EXPECT_EQ(hwffd_attached_counts(nullptr, &counts), HWFFD_USAGE);
  EXPECT_EQ(hwffd_attached_counts(attached, nullptr), HWFFD_USAGE);
  EXPECT_EQ(hwffd_attached_deform(nullptr, lattice_.get(), &to), HWFFD_USAGE);
  EXPECT_EQ(hwffd_attached_deform(attached, nullptr, &to), HWFFD_USAGE);
  EXPECT_EQ(hwffd_attached_deform(attached, lattice_.get(), nullptr), HWFFD_USAGE);
  EXPECT_EQ(hwffd_attached_gradients(attached, lattice, nullptr), HWFFD_USAGE);
  EXPECT_EQ(hwffd_attached_determinants(nullptr, lattice, out), HWFFD_USAGE);
  EXPECT_EQ(hwffd_attached_normals(attached, lattice, nullptr, &to), HWFFD_USAGE);
  EXPECT_EQ(hwffd_attached_weights(attached, starts, nullptr, out), HWFFD_USAGE);
  expect_error("columns is NULL; give it");
  EXPECT_EQ(hwffd_attached_unmoved(attached, nullptr), HWFFD_USAGE);
  EXPECT_EQ(hwffd_attached_pull_back(attached, &to, nullptr), HWFFD_USAGE);
  EXPECT_EQ(hwffd_lattice_dims(nullptr, dims), HWFFD_USAGE);
  EXPECT_EQ(hwffd_lattice_dims(lattice, nullptr), HWFFD_USAGE);
  EXPECT_EQ(hwffd_lattice_points(lattice, nullptr), HWFFD_USAGE);
  EXPECT_EQ(hwffd_lattice_family(nullptr, "linear"), HWFFD_USAGE);
  EXPECT_EQ(hwffd_lattice_family(lattice_.get(), nullptr), HWFFD_USAGE);
  EXPECT_EQ(hwffd_deform_view(nullptr, &to, &to), HWFFD_USAGE);
}

TEST_F(CAttached, NoPointsAreFew) {
  const hwffd_view none = hwffd_packed(HWFFD_FLOAT32, nullptr, 0);
  EXPECT_EQ(hwffd_deform_view(lattice_.get(), &none, &none), HWFFD_OK) << hwffd_error();
  const Attached attached(hwffd_attach(lattice_.get(), &none));
  ASSERT_TRUE(attached) << hwffd_error();
  EXPECT_EQ(hwffd_attached_deform(attached.get(), lattice_.get(), &none), HWFFD_OK);
  int64_t start = 7;
  EXPECT_EQ(hwffd_attached_weights(attached.get(), &start, nullptr, nullptr), HWFFD_OK);
  EXPECT_EQ(start, 0);
}

}  // namespace
