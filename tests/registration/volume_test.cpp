#include "hwffd/registration/volume.hpp"

#include <gtest/gtest.h>

#include <limits>

#include "errors.hpp"

namespace hwffd {
namespace {

constexpr float kNan = std::numeric_limits<float>::quiet_NaN();
constexpr float kInfinity = std::numeric_limits<float>::infinity();

AffineMap oblique() {
  AffineMap map;
  map.linear = {{{1, 0.25, 0}, {0, 2, -0.5}, {0.5, 0, 3}}};
  map.offset = {10, -20, 30};
  return map;
}

TEST(AffineMap, InverseComesBack) {
  const AffineMap map = oblique();
  EXPECT_DOUBLE_EQ(map.determinant(), 5.9375);
  const auto there = map({1, 2, 3});
  EXPECT_EQ(there, (std::array<double, 3>{11.5, -17.5, 39.5}));
  const auto back = map.inverse()(there);
  for (std::size_t c = 0; c < 3; ++c) EXPECT_NEAR(back[c], static_cast<double>(c + 1), 1e-14);
  const AffineMap both = composed(map.inverse(), map);
  for (std::size_t r = 0; r < 3; ++r) {
    for (std::size_t c = 0; c < 3; ++c) EXPECT_NEAR(both.linear[r][c], r == c ? 1 : 0, 1e-15);
    EXPECT_NEAR(both.offset[r], 0.0, 1e-14);
  }
}

TEST(AffineMap, OfAMatrix) {
  Eigen::Matrix4d matrix;
  matrix << 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 0, 0, 0, 1;
  const AffineMap map = AffineMap::of(matrix);
  EXPECT_EQ(map.linear[1], (std::array<double, 3>{5, 6, 7}));
  EXPECT_EQ(map.offset, (std::array<double, 3>{4, 8, 12}));
  EXPECT_ERROR(map.inverse(),
               "affine map: it is not invertible; give one whose columns span a volume");
  matrix(3, 0) = 1e-3;
  EXPECT_ERROR(AffineMap::of(matrix),
               "affine map: the last row of the matrix is not 0 0 0 1; give one that is affine");
  matrix(3, 0) = std::numeric_limits<double>::quiet_NaN();
  EXPECT_ERROR(AffineMap::of(matrix),
               "affine map: a number that is not finite; give a matrix of 4 x 4 numbers");
}

TEST(Volume, SaysWhatItHas) {
  const Volume volume("moving image", {3, 2, 1}, {1, 2, 3, 4, 5, 9}, oblique(), {1, 1, 0, 1, 1, 0});
  EXPECT_EQ(volume.size(), 6U);
  EXPECT_EQ(volume.values()[5], 9.0F);
  const Volume::Range range = volume.range();
  EXPECT_EQ(range.least, 1.0F);
  EXPECT_EQ(range.most, 5.0F);
  EXPECT_EQ(range.voxels, 4U);
  EXPECT_DOUBLE_EQ(range.variance, 2.5);
}

TEST(Volume, IsSharedNotCopied) {
  const auto values = std::make_shared<std::vector<float>>(std::vector<float>{1, 2});
  const Volume volume("fixed image", {2, 1, 1}, Volume::Values(values, values->data()), {});
  EXPECT_EQ(volume.values(), values->data());
  EXPECT_EQ(values.use_count(), 2);
}

TEST(Volume, Refuses) {
  const std::vector<float> eight{1, 2, 3, 4, 5, 6, 7, 8};
  EXPECT_ERROR(Volume("fixed image", {2, 0, 2}, std::vector<float>{}, {}),
               "fixed image: 2 x 0 x 2 voxels; give at least one along each axis");
  EXPECT_ERROR(Volume("fixed image", {2, 2, 3}, eight, {}),
               "fixed image: 8 numbers; give one for each of its 12 voxels");
  EXPECT_ERROR(Volume("fixed image", {2, 2, 2}, eight, {}, std::vector<std::uint8_t>(7, 1)),
               "mask of the fixed image: 7 numbers; give one for each of its 8 voxels");
  EXPECT_ERROR(Volume("fixed image", {2, 2, 2}, eight, {}, std::vector<std::uint8_t>(8, 0)),
               "mask of the fixed image: it is 0 everywhere; give one with voxels that count");
  AffineMap flat;
  flat.linear[2] = {0, 0, 0};
  EXPECT_ERROR(Volume("moving image", {2, 2, 2}, eight, flat),
               "moving image: its axes span no volume; give it a spacing and a direction that do");
  EXPECT_ERROR(
      Volume("moving image", {2, 2, 2}, {1, 2, 3, kNan, 5, 6, kInfinity, 8}, {}),
      "moving image: 2 of 8 voxels NaN or infinite, the first (1, 1, 0); replace them by numbers, "
      "and mask them out if they are to count for nothing");
  const auto some = std::make_shared<std::vector<float>>(eight);
  EXPECT_ERROR(Volume("fixed image", {2048, 2048, 2048}, Volume::Values(some, some->data()), {}),
               "fixed image: 2048 x 2048 x 2048 voxels; give fewer than 2^31");
}

TEST(Volume, ConstantIsRefused) {
  check_not_constant(Volume("fixed image", {2, 1, 1}, {1, 2}, {}));
  EXPECT_ERROR(check_not_constant(Volume("fixed image", {2, 1, 1}, {2.5, 2.5}, {})),
               "fixed image: all voxels are 2.5; give one with contrast");
  EXPECT_ERROR(check_not_constant(Volume("moving image", {3, 1, 1}, {1, 1, 2}, {}, {1, 1, 0})),
               "moving image: all voxels of its mask are 1; give one with contrast");
}

}  // namespace
}  // namespace hwffd
