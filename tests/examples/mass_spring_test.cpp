#include "mass_spring/mass_spring.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "errors.hpp"
#include "hwffd/lattice/box.hpp"
#include "hwffd/lattice/deformation.hpp"
#include "hwffd/lattice/fold.hpp"
#include "mass_spring/scenario.hpp"

namespace hwffd::mass_spring {
namespace {

constexpr double kStep = 1.0 / (24 * 64);

Lattice box() { return Box(Point(-1, 0, 2), Point(3, 2, 2.5).asDiagonal()).lattice({6, 5, 5}); }

/// A body at rest in `box`, each of its points then put elsewhere.
MassSpring disturbed(const Material& material) {
  MassSpring body(box(), material);
  const Lattice moved = Deformation::parse("random:3").apply(box());
  for (Eigen::Index p = 0; p < moved.points().rows(); ++p) {
    body.hold(p, moved.points().row(p));
    body.let_go(p);
  }
  return body;
}

TEST(MassSpring, AtRestNothingMoves) {
  MassSpring body(box());
  EXPECT_EQ(body.energy(), 0.0);
  for (int i = 0; i < 100; ++i) body.step(kStep);
  EXPECT_EQ(body.lattice().points(), box().points());
}

TEST(MassSpring, EnergyIsThatOfTheSprings) {
  MassSpring body(box(), {100.0, 0.0});
  const Point moved = box().point(0, 0, 0) - Point(0.5, 0, 0);
  body.hold(box().index(0, 0, 0), moved);
  double expected = 0.0;
  for (int n = 1; n < 8; ++n) {  // the neighbours of a corner, those of diagonals included
    const Point to = box().point(n >> 2 & 1, n >> 1 & 1, n & 1);
    const double longer = (to - moved).norm() - (to - box().point(0, 0, 0)).norm();
    expected += 100.0 * longer * longer / 2;
  }
  EXPECT_NEAR(body.elastic_energy(), expected, 1e-12 * expected);
  EXPECT_EQ(body.kinetic_energy(), 0.0);
}

TEST(MassSpring, WithoutDampingEnergyStays) {
  MassSpring body = disturbed({1200.0, 0.0});
  const double before = body.energy();
  double most_kinetic = 0.0;
  for (int i = 0; i < 2000; ++i) {
    body.step(kStep);
    most_kinetic = std::max(most_kinetic, body.kinetic_energy());
    ASSERT_NEAR(body.energy(), before, 0.02 * before) << i;
  }
  EXPECT_GT(most_kinetic, 0.3 * before);
}

TEST(MassSpring, WithDampingEnergyOnlyFallsAndMomentumStaysZero) {
  MassSpring body = disturbed({});
  const double before = body.energy();
  double energy = before;
  double fastest = 0.0;
  for (int i = 0; i < 1000; ++i) {
    body.step(kStep);
    ASSERT_LE(body.energy(), energy) << i;
    energy = body.energy();
    fastest = std::max(fastest, body.kinetic_energy());
    ASSERT_LE(body.momentum().norm(), 1e-9) << i;
    ASSERT_LE(body.angular_momentum().norm(), 1e-9) << i;
  }
  EXPECT_LT(energy, 0.01 * before);
  EXPECT_GT(fastest, 0.1 * before) << "it did move";
}

TEST(MassSpring, HeldPointsStayAndTakeUpMomentum) {
  MassSpring body = disturbed({});
  const Eigen::Index corner = box().index(5, 4, 4);
  const Point at = box().point(5, 4, 4) + Point(1, 1, 1);
  body.hold(corner, at);
  for (int i = 0; i < 20; ++i) body.step(kStep);
  EXPECT_EQ(Point(body.lattice().points().row(corner)), at);
  EXPECT_GT(body.momentum().norm(), 1.0);
}

class PullAndRelease : public testing::Test {
 protected:
  std::vector<Frame> film_ = pull_and_release(box(), 24);
};

TEST_F(PullAndRelease, BeginsAtRest) {
  ASSERT_EQ(film_.size(), 24u);
  EXPECT_EQ(film_[0].lattice.points(), box().points());
  EXPECT_EQ(film_[0].energy(), 0.0);
}

TEST_F(PullAndRelease, EnergyRisesWhilePulledAndFallsAfterwards) {
  int pulled = 0;
  int free = 0;
  for (std::size_t f = 1; f < film_.size(); ++f) {
    if (film_[f].released) {
      EXPECT_LT(film_[f].energy(), film_[f - 1].energy()) << f;
      ++free;
    } else {
      EXPECT_GT(film_[f].energy(), film_[f - 1].energy()) << f;
      ++pulled;
    }
  }
  EXPECT_EQ(pulled, 6);
  EXPECT_EQ(free, 17);
  EXPECT_LT(film_.back().energy(), 0.1 * film_[6].energy());
}

TEST_F(PullAndRelease, NothingFoldsAndTheFeetStay) {
  int checked = 0;
  for (const Frame& frame : film_) {
    EXPECT_TRUE(frame.lattice.points().allFinite());
    EXPECT_EQ(check_folds(frame.lattice).text(), "proved") << checked;
    for (int i = 0; i < 6; ++i) {
      for (const int j : {0, 1}) EXPECT_EQ(frame.lattice.point(i, j, 2), box().point(i, j, 2));
    }
    ++checked;
  }
  EXPECT_EQ(checked, 24);
}

TEST_F(PullAndRelease, TheTopIsPulledAsideAndSwingsBeyondItsPlace) {
  const auto aside = [&](const Frame& frame) {
    return (frame.lattice.points() - box().points()).col(0).mean();
  };
  double least = 0.0;
  for (const Frame& frame : film_) least = std::min(least, aside(frame));
  EXPECT_GT(aside(film_[6]), 0.3);
  EXPECT_LT(least, -0.02);
}

TEST(PullAndReleaseErrors, TooLittleIsRefused) {
  const Lattice low = Box(Point(0, 0, 0), Point(1, 1, 1).asDiagonal()).lattice({5, 4, 5});
  EXPECT_ERROR_PART(pull_and_release(low, 24), "5 points along t");
  EXPECT_ERROR_PART(pull_and_release(box(), 3), "4 frames");
}

}  // namespace
}  // namespace hwffd::mass_spring
