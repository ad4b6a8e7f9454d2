#include "hwffd/registration/pyramid.hpp"

#include <gtest/gtest.h>

#include "errors.hpp"

namespace hwffd {
namespace {

/// f(i, j, k) at all voxels.
template <class F>
std::vector<float> voxels(const Index3& counts, const F& f) {
  std::vector<float> result;
  for (int k = 0; k < counts[2]; ++k) {
    for (int j = 0; j < counts[1]; ++j) {
      for (int i = 0; i < counts[0]; ++i) result.push_back(static_cast<float>(f(i, j, k)));
    }
  }
  return result;
}

/// Smoothing by symmetric weights that sum to one keeps linear functions, but at the ends, which
/// repeat.
TEST(Pyramid, HalvedKeepsLinearFunctions) {
  const auto ramp = [](int i, int j, int k) { return 4 * i + 16 * j - 64 * k + 1; };
  const Index3 counts{17, 16, 21};
  AffineMap map;
  map.linear = {{{2, 0, 0}, {0, 3, 0}, {0, 1, 4}}};
  map.offset = {5, 6, 7};
  const Volume half =
      halved(Volume("fixed image", counts, voxels(counts, ramp), map), {true, true, false});
  ASSERT_EQ(half.counts(), (Index3{9, 8, 21}));
  int compared = 0;
  for (int k = 0; k < 21; ++k) {
    for (int j = 1; j < 7; ++j) {
      for (int i = 1; i < 8; ++i, ++compared) {
        ASSERT_EQ(half.values()[(k * 8 + j) * 9 + i], ramp(2 * i, 2 * j, k)) << i << ' ' << j;
      }
    }
  }
  EXPECT_EQ(compared, 21 * 6 * 7);
  EXPECT_EQ(half.to_point()({3, 2, 1}), map({6, 4, 1}));
}

TEST(Pyramid, SmoothedWeightsAreBinomialToo) {
  const Index3 counts{5, 4, 3};
  std::vector<float> values(60, 1.0F);
  values[(1 * 4 + 2) * 5 + 2] = 65;
  values[0] = 28;  // which stands for the voxels beyond it, too
  const Volume smooth = smoothed(Volume("fixed image", counts, values, {}));
  const std::array<double, 3> weights{1, 2, 1};
  const std::array<double, 2> corner{3, 1};
  for (int k = 0; k < 3; ++k) {
    for (int j = 0; j < 4; ++j) {
      for (int i = 0; i < 5; ++i) {
        double expected = 1.0;
        if (j >= 1 && i >= 1 && i <= 3) expected += weights[k] * weights[j - 1] * weights[i - 1];
        if (i < 2 && j < 2 && k < 2) expected += corner[i] * corner[j] * corner[k] * 27 / 64;
        EXPECT_EQ(smooth.values()[(k * 4 + j) * 5 + i], static_cast<float>(expected));
      }
    }
  }
  // What does not count leaves no trace in what does.
  std::vector<std::uint8_t> mask(60, 1);
  mask[0] = 0;
  mask[(1 * 4 + 2) * 5 + 2] = 0;
  const Volume masked = smoothed(Volume("fixed image", counts, values, {}, mask));
  for (std::size_t at = 0; at < 60; ++at) {
    if (mask[at] != 0) {
      EXPECT_EQ(masked.values()[at], 1.0F) << at;
    }
    EXPECT_EQ(masked.mask()[at], mask[at]);
  }
}

TEST(Pyramid, WeightsAreBinomial) {
  for (std::size_t axis = 0; axis < 3; ++axis) {
    Index3 counts{1, 1, 1};
    counts[axis] = 16;
    std::array<bool, 3> axes{};
    axes[axis] = true;
    std::vector<float> values(16, 0.0F);
    values[0] = 16;
    values[5] = 160;
    const Volume half = halved(Volume("fixed image", counts, values, {}), axes);
    // Voxel 0 stands for two beyond it, too; 5 is a neighbour of 4 and 6.
    const std::vector<float> wanted{6 + 4 + 1, 1, 40, 40, 0, 0, 0, 0};
    EXPECT_EQ(std::vector<float>(half.values(), half.values() + 8), wanted) << axis;
  }
}

TEST(Pyramid, MaskIsThatOfTheVoxel) {
  const Index3 counts{16, 16, 1};
  std::vector<std::uint8_t> mask(256, 0);
  mask[16 * 6 + 4] = 1;
  mask[16 * 7 + 4] = 1;
  const Volume half = halved(
      Volume("fixed image", counts, voxels(counts, [](int i, int, int) { return i; }), {}, mask),
      {true, true, false});
  for (int at = 0; at < 64; ++at) EXPECT_EQ(half.mask()[at], at == 3 * 8 + 2 ? 1 : 0);
  std::vector<std::uint8_t> odd(256, 0);
  odd[1] = 1;
  EXPECT_ERROR(halved(Volume("fixed image", counts, std::vector<float>(256, 1), {}, odd),
                      {true, false, false}),
               "mask of the fixed image: nothing of it is left at half the resolution; give fewer "
               "levels");
}

/// Whatever masked voxels have, others are smoothed among themselves.
TEST(Pyramid, MaskedVoxelsAreNotSmoothedInto) {
  const Index3 counts{20, 18, 17};
  std::vector<float> values = voxels(counts, [](int, int, int) { return 5; });
  std::vector<std::uint8_t> mask(values.size(), 1);
  for (std::size_t n = 0; n < values.size(); ++n) {
    if (n % 7 != 3 && n % 20 < 12) continue;
    mask[n] = 0;
    values[n] = 1e6F;
  }
  const Volume half =
      halved(Volume("fixed image", counts, std::move(values), {}, mask), {true, true, true});
  int counted = 0;
  for (std::size_t n = 0; n < half.size(); ++n) {
    if (half.mask()[n] == 0) continue;
    EXPECT_FLOAT_EQ(half.values()[n], 5.0F);
    ++counted;
  }
  EXPECT_GT(counted, 200);
}

TEST(Pyramid, StaysWhereAxesAreShort) {
  const Index3 counts{64, 20, 1};
  const Volume volume("moving image", counts,
                      voxels(counts, [](int i, int j, int) { return i + j; }), {});
  EXPECT_EQ(most_levels(counts), 4);
  const std::vector<PyramidLevel> levels = pyramid(volume, 4);
  EXPECT_EQ(levels[3].volume.values(), volume.values());
  EXPECT_EQ(levels[2].volume.counts(), (Index3{32, 10, 1}));
  EXPECT_EQ(levels[1].volume.counts(), (Index3{16, 10, 1}));
  EXPECT_EQ(levels[0].volume.counts(), (Index3{8, 10, 1}));
  EXPECT_EQ(levels[0].halvings, (std::array<int, 3>{3, 1, 0}));
  EXPECT_ERROR(pyramid(volume, 5),
               "levels 5: the moving image of 64 x 20 x 1 voxels has 1 to 4; give one of these");
  EXPECT_ERROR(pyramid(volume, 0),
               "levels 0: the moving image of 64 x 20 x 1 voxels has 1 to 4; give one of these");
}

}  // namespace
}  // namespace hwffd
