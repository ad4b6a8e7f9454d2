#include "view/controls.hpp"

#include <gtest/gtest.h>

#include "hwffd/lattice/around.hpp"

namespace hwffd::view {
namespace {

constexpr int kWidth = 800;
constexpr int kHeight = 600;

class ControlsOfABox : public testing::Test {
 protected:
  /// Where the user sees a point of the lattice.
  Pixels seen(Eigen::Index row) const {
    return Screen(controls_.camera(), kWidth, kHeight)
        .project(controls_.lattice().points().row(row))
        ->place;
  }
  bool at_rest() const { return controls_.lattice().points() == box_.points(); }

  Lattice box_ = lattice_around("box", (Points(2, 3) << -1, -1, -1, 1, 1, 1).finished(), {4, 4, 4});
  std::vector<Points> saved_;
  Controls controls_{LatticeDrag(box_, Family()),
                     Orbit(box_.points(), Point(0.35, 0.3, 1), 4.0 / 3.0), kWidth, kHeight,
                     [this](const Lattice& lattice) { saved_.push_back(lattice.points()); }};
};

TEST_F(ControlsOfABox, AllPointsAreInTheWindowAtFirst) {
  for (Eigen::Index row = 0; row < 64; ++row) {
    EXPECT_GT(seen(row).minCoeff(), 0);
    EXPECT_LT(seen(row).x(), kWidth);
    EXPECT_LT(seen(row).y(), kHeight);
  }
  EXPECT_TRUE(controls_.take_changed());
  EXPECT_TRUE(controls_.take_lattice_moved());
  EXPECT_FALSE(controls_.take_changed());
  EXPECT_FALSE(controls_.take_lattice_moved());
}

TEST_F(ControlsOfABox, TheFirstButtonDragsAPoint) {
  const Pixels mouse = seen(0);
  controls_.take_lattice_moved();
  controls_.move(mouse);  // no button is down
  EXPECT_FALSE(controls_.take_lattice_moved());
  controls_.press(Button::kFirst, mouse);
  controls_.move(mouse + Pixels(30, 20));
  EXPECT_TRUE(controls_.take_lattice_moved());
  controls_.wheel(3);  // is not heard during a drag
  controls_.release(Button::kFirst);
  EXPECT_LT((seen(0) - mouse - Pixels(30, 20)).norm(), 1e-6);
  controls_.move(mouse);
  EXPECT_FALSE(controls_.take_lattice_moved());
}

TEST_F(ControlsOfABox, TheOtherButtonTurnsTheView) {
  const Pixels before = seen(0);
  const Point eye = controls_.camera().eye;
  controls_.take_changed();
  controls_.press(Button::kOther, before);
  controls_.move(before + Pixels(50, 0));
  EXPECT_TRUE(controls_.take_changed());
  controls_.release(Button::kOther);
  const Point turned = controls_.camera().eye;
  EXPECT_GT((turned - eye).norm(), 1);
  EXPECT_NEAR(turned.y(), eye.y(), 1e-9);
  EXPECT_LT(turned.x(), eye.x()) << "what is in front goes to the right";
  controls_.move(before);
  EXPECT_FALSE(controls_.take_changed());
  EXPECT_TRUE(at_rest());
}

TEST_F(ControlsOfABox, TurningStopsBelowTheZenith) {
  controls_.press(Button::kOther, Pixels(0, 0));
  controls_.move(Pixels(0, 10000));
  const picture::Camera camera = controls_.camera();
  const Point back = (camera.eye - camera.target).normalized();
  EXPECT_GT(back.y(), 0.99);
  EXPECT_LT(back.y(), 1 - 1e-4);
}

TEST_F(ControlsOfABox, TheWheelZoomsWithinLimits) {
  const auto distance = [&] { return (controls_.camera().eye - controls_.camera().target).norm(); };
  const double before = distance();
  controls_.wheel(1);
  EXPECT_NEAR(distance(), before / 1.1, 1e-9);
  controls_.wheel(-1);
  EXPECT_NEAR(distance(), before, 1e-9);
  controls_.wheel(1000);
  EXPECT_GT(distance(), 0.1);
  EXPECT_GT(controls_.camera().nearest, 0);
  controls_.wheel(-1000);
  EXPECT_LT(distance(), 1000);
  EXPECT_GT(controls_.camera().farthest, distance());
}

TEST_F(ControlsOfABox, KeysSaveAndReset) {
  const Pixels mouse = seen(5);
  controls_.press(Button::kFirst, mouse);
  controls_.move(mouse + Pixels(30, 20));
  controls_.release(Button::kFirst);
  controls_.key(Key::kSave);
  ASSERT_EQ(saved_.size(), 1u);
  EXPECT_EQ(saved_[0], controls_.lattice().points());
  EXPECT_NE(saved_[0], box_.points());
  controls_.take_lattice_moved();
  controls_.key(Key::kReset);
  EXPECT_TRUE(controls_.take_lattice_moved());
  EXPECT_TRUE(at_rest());
}

TEST_F(ControlsOfABox, PointsAreFoundWhereAResizedWindowShowsThem) {
  controls_.resize(0, 0);  // minimized
  controls_.resize(400, 900);
  const Pixels mouse = Screen(controls_.camera(), 400, 900).project(box_.point(0, 0, 0))->place;
  controls_.press(Button::kFirst, mouse);
  controls_.move(mouse + Pixels(9, 0));
  EXPECT_FALSE(at_rest());
}

}  // namespace
}  // namespace hwffd::view
