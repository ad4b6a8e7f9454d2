#include <gtest/gtest.h>

#include <cmath>
#include <functional>

#include "errors.hpp"
#include "hwffd/registration/registration.hpp"
#include "phantom.hpp"

namespace hwffd {
namespace {

const Volume& fixed() {
  static const Volume volume = Phantom({32, 24, 20}, 1.0).fixed();
  return volume;
}
const Volume& moving() {
  static const Volume volume = Phantom({32, 24, 20}, 1.0).moving();
  return volume;
}

RegistrationOptions spacing(double i, double j, double k) {
  RegistrationOptions options;
  options.spacing = {i, j, k};
  return options;
}

TEST(CellCounts, FollowFromSpacingAndLevels) {
  // 4, 3 and 2.5 cells, halved twice, once and once.
  EXPECT_EQ(cell_counts(fixed(), spacing(8, 8, 8), 2), (Index3{4, 4, 2}));
  EXPECT_EQ(cell_counts(fixed(), spacing(8, 8, 8), 1), (Index3{2, 2, 1}));
  EXPECT_EQ(cell_counts(fixed(), spacing(8, 8, 8), 0), (Index3{1, 2, 1}));
  RegistrationOptions options = spacing(5, 6, 20);
  options.levels = 2;
  EXPECT_EQ(cell_counts(fixed(), options, 1), (Index3{6, 4, 1}));
  EXPECT_EQ(cell_counts(fixed(), options, 0), (Index3{3, 2, 1}));
  options.levels = 1;
  EXPECT_EQ(cell_counts(fixed(), options, 0), (Index3{6, 4, 1}));
  EXPECT_ERROR(cell_counts(fixed(), options, 1), "level 1: give 0 to 0");
  // In units of length, along axes of 2, 0.5 and 1.
  AffineMap map;
  map.linear = {{{0, 0, 1}, {2, 0, 0}, {0, 0.5, 0}}};
  const Volume scan("fixed image", fixed().counts(),
                    std::vector<float>(fixed().values(), fixed().values() + fixed().size()), map);
  options = spacing(16, 3, 10);
  options.spacing_in_voxels = false;
  options.levels = 2;
  EXPECT_EQ(cell_counts(scan, options, 1), (Index3{4, 4, 2}));
  const Volume slice = Phantom({64, 48, 1}, 1.0).fixed();
  EXPECT_EQ(cell_counts(slice, spacing(8, 8, 8), 2), (Index3{8, 8, 1}));
  EXPECT_EQ(cell_counts(slice, spacing(8, 8, 8), 0), (Index3{2, 2, 1}));
}

TEST(RegistrationRefusals, Spacing) {
  EXPECT_ERROR(register_volumes(fixed(), moving(), spacing(8, 25, 8)),
               "spacing 25 voxels along j: larger than the fixed image of 24 voxels; give at most "
               "that");
  EXPECT_ERROR(register_volumes(fixed(), moving(), spacing(8, 8, 0)),
               "spacing 0 along k: give a number above 0");
  EXPECT_ERROR(register_volumes(fixed(), moving(), spacing(std::nan(""), 8, 8)),
               "spacing nan along i: give a number above 0");
  const Volume large = Phantom({100, 8, 8}, 1.0).fixed();
  RegistrationOptions options = spacing(1.5, 4, 4);
  options.levels = 1;
  EXPECT_ERROR(register_volumes(large, large, options),
               "spacing 1.5 voxels along i: 70 control points, more than 64 an axis; give 1.64 or "
               "more");
  options.spacing[0] = 1.64;
  EXPECT_EQ(cell_counts(large, options, 0)[0], 61);
  AffineMap micrometres;
  for (std::size_t a = 0; a < 3; ++a) micrometres.linear[a][a] = 1e-6;
  const Volume small = Phantom({100, 8, 8}, 1.0, micrometres).fixed();
  options.spacing = {1.5e-6, 4e-6, 4e-6};
  options.spacing_in_voxels = false;
  EXPECT_ERROR(register_volumes(small, small, options),
               "spacing 1.5e-06 along i: 70 control points, more than 64 an axis; give 1.64e-06 or "
               "more");
  options.spacing[0] = 1.64e-6;
  EXPECT_EQ(cell_counts(small, options, 0)[0], 61);
}

TEST(RegistrationRefusals, Levels) {
  RegistrationOptions options = spacing(8, 8, 8);
  options.levels = 4;
  EXPECT_ERROR(register_volumes(fixed(), moving(), options),
               "levels 4: the fixed image of 32 x 24 x 20 voxels can have 3; give 1 to 3, or 0 to "
               "leave it open");
  options.levels = -1;
  EXPECT_ERROR(register_volumes(fixed(), moving(), options),
               "levels -1: the fixed image of 32 x 24 x 20 voxels can have 3; give 1 to 3, or 0 to "
               "leave it open");
}

TEST(RegistrationRefusals, Images) {
  const Volume flat("moving image", {8, 8, 8}, std::vector<float>(512, 4), {});
  EXPECT_ERROR(register_volumes(fixed(), flat, spacing(8, 8, 8)),
               "moving image: all voxels are 4; give one with contrast");
  AffineMap far;
  far.offset = {100, 0, 0};
  const Volume elsewhere("moving image", moving().counts(),
                         std::vector<float>(moving().values(), moving().values() + moving().size()),
                         far);
  EXPECT_ERROR(register_volumes(fixed(), elsewhere, spacing(8, 8, 8)),
               "fixed image and moving image do not overlap: no voxel that counts comes to lie in "
               "the other; give a start that aligns them roughly, or check their origins, "
               "directions and masks");
}

TEST(RegistrationRefusals, Numbers) {
  const auto refusal = [](const std::function<void(RegistrationOptions&)>& change) {
    RegistrationOptions options = spacing(8, 8, 8);
    change(options);
    return message_of<UsageError>([&] { register_volumes(fixed(), moving(), options); });
  };
  EXPECT_EQ(refusal([](auto& o) { o.bending_weight = -1; }), "bending weight -1: give 0 or more");
  EXPECT_EQ(refusal([](auto& o) { o.barrier_weight = std::nan(""); }),
            "barrier weight nan: give 0 or more");
  EXPECT_EQ(refusal([](auto& o) { o.iterations = -3; }), "iterations -3: give 0 to 1000000");
  EXPECT_EQ(refusal([](auto& o) { o.tolerance = -1e-3; }), "tolerance -0.001: give 0 or more");
  EXPECT_EQ(refusal([](auto& o) { o.overlap = 1.5; }), "overlap 1.5: give 0 to 1");
  EXPECT_EQ(refusal([](auto& o) {
              o.start = AffineMap();
              o.start_lattice = rest_lattice(fixed(), {2, 2, 2});
            }),
            "start: an affine map and a lattice; give one of them");
}

TEST(RegistrationRefusals, Starts) {
  RegistrationOptions options = spacing(8, 8, 8);
  options.start_lattice = rest_lattice(fixed(), {4, 4, 4});
  EXPECT_ERROR(register_volumes(fixed(), moving(), options),
               "start lattice: 7 x 7 x 7 control points; give 4 x 5 x 4 or 5 x 5 x 4 or 7 x 7 x 5 "
               "for this spacing");
  Lattice folded = rest_lattice(fixed(), cell_counts(fixed(), options, 2));
  Points points = folded.points();
  points.row(folded.index(2, 2, 2)) += Eigen::RowVector3d(-40, 0, 0);
  options.start_lattice = Lattice(folded.dims(), points);
  options.no_folds = true;
  const std::string text = message_of<Error>([&] { register_volumes(fixed(), moving(), options); });
  expect_part(text, "start without folds: the lattice is folded at (cell ");
  options = spacing(8, 8, 8);
  options.start = AffineMap();
  options.start->linear[1] = {0, 0, 0};
  EXPECT_ERROR(register_volumes(fixed(), moving(), options),
               "affine map: it is not invertible; give one whose columns span a volume");
}

/// Where they overlap the moving image is constant.
TEST(RegistrationRefusals, NoValueAtTheStart) {
  std::vector<float> values(512, 0.0F);
  values[511] = 1;
  AffineMap map;
  map.offset = {31 - 6.0, 0, 0};
  const Volume corner("moving image", {8, 8, 8}, values, map);
  RegistrationOptions options = spacing(8, 8, 8);
  options.metric = MetricKind::kCorrelation;
  EXPECT_ERROR(
      register_volumes(fixed(), corner, options),
      "the metric has no value at the start: an image is constant where they overlap; give "
      "a start that aligns them roughly");
}

}  // namespace
}  // namespace hwffd
