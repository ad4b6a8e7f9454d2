#include "hwffd/lattice/keyframe.hpp"

#include <gtest/gtest.h>

#include <limits>

#include "errors.hpp"
#include "hwffd/lattice/closure.hpp"
#include "hwffd/lattice/cylinder.hpp"
#include "hwffd/lattice/deformation.hpp"
#include "same_bits.hpp"

namespace hwffd {
namespace {

Lattice can() {
  return Cylinder(Point(0.1, 0.2, 0.3), Eigen::Matrix3d::Identity()).lattice({4, 5, 8});
}

TEST(Keyframe, EndsAreExact) {
  Points points = can().points();
  points(7, 1) = -0.0;
  const Lattice a(can().dims(), points);
  const Lattice b = Deformation::parse("bend:70").apply(a);
  EXPECT_TRUE(same_bits(between(a, b, 0.0).points(), a.points()));
  EXPECT_TRUE(same_bits(between(a, b, 1.0).points(), b.points()));
  EXPECT_FALSE(same_bits(between(a, b, 1e-3).points(), a.points()));
}

TEST(Keyframe, IsLinear) {
  const Lattice a = can();
  const Lattice b = Deformation::parse("twist:70").apply(a);
  for (const double fraction : {-0.5, 0.25, 0.5, 0.9, 2.0}) {
    const Lattice mixed = between(a, b, fraction);
    const Points expected = (1 - fraction) * a.points() + fraction * b.points();
    EXPECT_LT((mixed.points() - expected).norm(), 1e-13) << fraction;
    EXPECT_TRUE(Closure(mixed).closed(2));
  }
}

TEST(Keyframe, Refuses) {
  const Lattice other = Cylinder(Point::Zero(), Eigen::Matrix3d::Identity()).lattice({4, 5, 9});
  EXPECT_ERROR(between(can(), other, 0.5), "second keyframe has 4 x 5 x 9 points; give 4 x 5 x 8");
  const Lattice moved = Deformation::parse("move:0,0,0:1,0,0").apply(can());
  EXPECT_ERROR_PART(between(can(), moved, std::numeric_limits<double>::quiet_NaN()),
                    "is not finite");
}

}  // namespace
}  // namespace hwffd
