#include "hwffd/registration/sampling.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "random_numbers.hpp"

namespace hwffd {
namespace {

struct Sampled {
  std::vector<float> values;
  std::vector<std::uint8_t> inside;
  std::vector<double> gradients[3];
  std::size_t count = 0;
};

Sampled sampled(const Volume& volume, const std::vector<double>& x, const std::vector<double>& y,
                const std::vector<double>& z) {
  Sampled result;
  const std::size_t n = x.size();
  result.values.resize(n);
  result.inside.resize(n);
  for (auto& g : result.gradients) g.resize(n);
  result.count = LinearSampler(volume).gradients(
      n, x.data(), y.data(), z.data(), result.values.data(), result.inside.data(),
      result.gradients[0].data(), result.gradients[1].data(), result.gradients[2].data());
  return result;
}

Volume random_volume(const Index3& counts, std::uint64_t seed,
                     std::vector<std::uint8_t> mask = {}) {
  RandomNumbers random(seed);
  std::vector<float> values(static_cast<std::size_t>(counts[0] * counts[1] * counts[2]));
  for (float& v : values) v = static_cast<float>(random(-100, 100));
  return {"moving image", counts, std::move(values), {}, std::move(mask)};
}

/// What sampling.hpp says, written out for one place in double.
struct Expected {
  double value, gradient[3];
};
Expected expected(const Volume& volume, const double (&at)[3]) {
  int cell[3];
  double local[3];
  bool within[3];
  for (std::size_t a = 0; a < 3; ++a) {
    const int n = volume.counts()[a];
    const double clamped = std::min(std::max(at[a], 0.0), n - 1.0);
    within[a] = clamped == at[a] && n > 1;
    cell[a] = std::max(0, std::min(static_cast<int>(std::floor(clamped)), n - 2));
    local[a] = clamped - cell[a];
  }
  Expected result{};
  for (int corner = 0; corner < 8; ++corner) {
    double weight[3];
    double slope[3];
    int index[3];
    for (int a = 0; a < 3; ++a) {
      const int upper = corner >> a & 1;
      index[a] = std::min(cell[a] + upper, volume.counts()[static_cast<std::size_t>(a)] - 1);
      weight[a] = upper != 0 ? local[a] : 1 - local[a];
      slope[a] = within[a] ? (upper != 0 ? 1 : -1) : 0;
    }
    const Index3& n = volume.counts();
    const double v =
        static_cast<double>(volume.values()[(index[2] * n[1] + index[1]) * n[0] + index[0]]);
    result.value += v * weight[0] * weight[1] * weight[2];
    result.gradient[0] += v * slope[0] * weight[1] * weight[2];
    result.gradient[1] += v * weight[0] * slope[1] * weight[2];
    result.gradient[2] += v * weight[0] * weight[1] * slope[2];
  }
  return result;
}

TEST(LinearSampler, IsTrilinear) {
  for (const Index3& counts :
       {Index3{7, 5, 6}, Index3{9, 1, 4}, Index3{1, 6, 1}, Index3{2, 2, 2}}) {
    const Volume volume = random_volume(counts, 1);
    RandomNumbers random(2);
    std::vector<double> at[3];
    for (std::size_t a = 0; a < 3; ++a) {
      for (int i = 0; i < 300; ++i) {
        const double x = random(-0.9, counts[a] - 0.1);
        at[a].push_back(i % 5 == 0 ? std::round(2 * x) / 2 : x);
      }
    }
    const Sampled got = sampled(volume, at[0], at[1], at[2]);
    std::size_t inside = 0;
    for (std::size_t i = 0; i < 300; ++i) {
      bool is_inside = true;
      for (std::size_t a = 0; a < 3; ++a) {
        is_inside = is_inside && at[a][i] >= -0.5 && at[a][i] < counts[a] - 0.5;
      }
      ASSERT_EQ(got.inside[i], is_inside ? 1 : 0);
      inside += is_inside ? 1 : 0;
      Expected wanted = expected(volume, {at[0][i], at[1][i], at[2][i]});
      if (!is_inside) wanted = {};
      ASSERT_NEAR(static_cast<double>(got.values[i]), wanted.value, 1e-4);
      for (std::size_t a = 0; a < 3; ++a) {
        ASSERT_NEAR(got.gradients[a][i], wanted.gradient[a], 2e-4) << i << " axis " << a;
      }
    }
    EXPECT_EQ(got.count, inside);
    EXPECT_GT(inside, 50U);
    EXPECT_LT(inside, 300U);
  }
}

TEST(LinearSampler, VoxelsAreThemselves) {
  const Volume volume = random_volume({5, 4, 3}, 3);
  std::vector<double> at[3];
  for (int n = 0; n < 60; ++n) {
    at[0].push_back(n % 5);
    const int row = n / 5;
    at[1].push_back(row % 4);
    const int slice = n / 20;
    at[2].push_back(slice);
  }
  const Sampled got = sampled(volume, at[0], at[1], at[2]);
  EXPECT_EQ(got.count, 60U);
  for (std::size_t n = 0; n < 60; ++n) {
    // The last along an axis are the upper ends of a cell, where sums round.
    const bool last = n % 5 == 4 || n / 5 % 4 == 3 || n / 20 == 2;
    EXPECT_NEAR(got.values[n], volume.values()[n], last ? 2e-5 : 0.0) << n;
  }
}

/// No place depends on where it stands among others, or on whether gradients are wanted.
TEST(LinearSampler, PlacesAreAlone) {
  const Volume volume = random_volume({20, 20, 20}, 4);
  RandomNumbers random(5);
  std::vector<double> at[3];
  for (auto& along : at) {
    for (int i = 0; i < 200; ++i) along.push_back(random(-2, 22));
  }
  const Sampled all = sampled(volume, at[0], at[1], at[2]);
  const LinearSampler sampler(volume);
  for (std::size_t i = 0; i < 200; ++i) {
    const Sampled single = sampled(volume, {at[0][i]}, {at[1][i]}, {at[2][i]});
    float value = 0;
    std::uint8_t inside = 2;
    sampler.values(1, &at[0][i], &at[1][i], &at[2][i], &value, &inside);
    ASSERT_EQ(single.values[0], all.values[i]);
    ASSERT_EQ(value, all.values[i]);
    ASSERT_EQ(inside, all.inside[i]);
    for (std::size_t a = 0; a < 3; ++a) ASSERT_EQ(single.gradients[a][0], all.gradients[a][i]);
  }
}

TEST(LinearSampler, MaskOfTheNearestVoxelCounts) {
  std::vector<std::uint8_t> mask(27, 1);
  mask[13] = 0;
  const Volume volume = random_volume({3, 3, 3}, 6, mask);
  const Sampled got =
      sampled(volume, {1.0, 0.5, 0.499, 1.499, 1.5}, {1, 1, 1, 1, 1}, {1, 1, 1, 1, 1});
  EXPECT_EQ(got.inside, (std::vector<std::uint8_t>{0, 0, 1, 0, 1}));
  EXPECT_EQ(got.values[0], 0.0F);
  EXPECT_EQ(got.gradients[0][1], 0.0);
  EXPECT_EQ(got.count, 2U);
}

/// Just below the upper face of one voxel, where half a voxel more rounds to the next.
TEST(LinearSampler, MaskOfOneVoxel) {
  const double below = std::nextafter(0.5, 0.0);
  const Volume volume("moving image", {2, 1, 1}, {5, 5}, {}, {1, 0});
  const Sampled got = sampled(volume, {0, 1, 0}, {below, below, 0.5}, {below, below, 0});
  EXPECT_EQ(got.inside, (std::vector<std::uint8_t>{1, 0, 0}));
}

TEST(LinearSampler, PlacesFarAwayAndNaNAreOutside) {
  const Volume volume = random_volume({3, 3, 3}, 7);
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const Sampled got = sampled(volume, {nan, 1e300, -1e300, 1}, {1, 1, 1, nan}, {1, 1, 1, 1});
  EXPECT_EQ(got.count, 0U);
  for (std::size_t i = 0; i < 4; ++i) {
    EXPECT_EQ(got.values[i], 0.0F);
    for (const auto& g : got.gradients) EXPECT_EQ(g[i], 0.0);
  }
}

}  // namespace
}  // namespace hwffd
