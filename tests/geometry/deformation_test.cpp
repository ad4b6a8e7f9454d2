#include "hwffd/lattice/deformation.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "errors.hpp"
#include "hwffd/lattice/box.hpp"
#include "hwffd/oracle/oracle.hpp"

namespace hwffd {
namespace {

using Kind = Deformation::Kind;

constexpr double kDeformationTiny = 1e-13;
constexpr double kDegreesPerRadian = 57.29577951308232;

/// 4 x 4 x 4 points from (0, 0, 0) to (3, 3, 3): the cell is [1, 2]^3.
Lattice plain_cube() { return Box(Point(1, 1, 1), Eigen::Matrix3d::Identity()).lattice({4, 4, 4}); }

Lattice deformed_by(const std::string& text, const Lattice& lattice) {
  return Deformation::parse(text).apply(lattice);
}

void expect_point(const Point& got, const Point& expected) {
  EXPECT_LT((got - expected).norm(), kDeformationTiny)
      << got.transpose() << " instead of " << expected.transpose();
}

/// How a message about this text begins.
std::string start_of(const std::string& text) { return "deformation '" + text + "'"; }

TEST(Deformation, ParsesDefaultsAndArguments) {
  EXPECT_EQ(Deformation::parse("none").kind(), Kind::kNone);
  EXPECT_EQ(Deformation::parse("twist").kind(), Kind::kTwist);
  EXPECT_EQ(Deformation::parse("twist").amount(), 90.0);
  EXPECT_EQ(Deformation::parse("twist:-12.5").amount(), -12.5);
  EXPECT_EQ(Deformation::parse("helix").kind(), Kind::kHelix);
  EXPECT_EQ(Deformation::parse("helix").amount(), 90.0);
  EXPECT_EQ(Deformation::parse("shear").kind(), Kind::kShear);
  EXPECT_EQ(Deformation::parse("shear").amount(), 0.5);
  EXPECT_EQ(Deformation::parse("shear:1e-1").amount(), 0.1);
  EXPECT_EQ(Deformation::parse("bend").kind(), Kind::kBend);
  EXPECT_EQ(Deformation::parse("bend").amount(), 90.0);
  EXPECT_EQ(Deformation::parse("random").kind(), Kind::kRandom);
  EXPECT_EQ(Deformation::parse("random").seed(), 1u);
  EXPECT_EQ(Deformation::parse("random:18446744073709551615").seed(), UINT64_MAX);
  EXPECT_EQ(Deformation::parse("taper").kind(), Kind::kTaper);
  EXPECT_EQ(Deformation::parse("taper").amount(), 0.5);
  EXPECT_EQ(Deformation::parse("scale").arguments().vector, Point(1.5, 1.5, 1.5));
  EXPECT_EQ(Deformation::parse("scale:2").arguments().vector, Point(2, 2, 2));
  EXPECT_EQ(Deformation::parse("scale:2,-3,0.5").arguments().vector, Point(2, -3, 0.5));
  const Deformation move = Deformation::parse("move:1,2,13:-1,0.5,1e2");
  EXPECT_EQ(move.kind(), Kind::kMove);
  EXPECT_EQ(move.arguments().place, (Index3{1, 2, 13}));
  EXPECT_EQ(move.arguments().vector, Point(-1, 0.5, 100));
  EXPECT_EQ(Deformation::parse("to:a:b.json").kind(), Kind::kTo);
  EXPECT_EQ(Deformation::parse("to:a:b.json").arguments().file, "a:b.json");
}

TEST(Deformation, ParsesAxes) {
  for (const std::string kind : {"twist", "helix", "bend", "taper"}) {
    for (int axis = 0; axis < 3; ++axis) {
      const Deformation deformation = Deformation::parse(kind + ":-3.5:" + "xyz"[axis]);
      EXPECT_EQ(deformation.amount(), -3.5) << kind;
      EXPECT_EQ(deformation.arguments().axis, axis) << kind;
    }
    EXPECT_EQ(Deformation::parse(kind).arguments().axis, 1);
    EXPECT_EQ(Deformation::parse(kind + ":1").arguments().axis, 1);
  }
  EXPECT_EQ(Deformation::parse("bend:1").arguments().towards, 0);
  EXPECT_EQ(Deformation::parse("bend:1:x").arguments().towards, 2);
  EXPECT_EQ(Deformation::parse("bend:1:yz").arguments().axis, 1);
  EXPECT_EQ(Deformation::parse("bend:1:yz").arguments().towards, 2);
  for (const std::string text :
       {"twist:90:", "twist:90:w", "twist:90:yz", "twist::y", "twist:y", "twist:90:x:y",
        "helix:90:Y", "taper:1:xy", "bend:90:yy", "bend:90:xyz", "bend:90:y,", "shear:1:x"}) {
    EXPECT_USAGE_ERROR_PART(Deformation::parse(text), "' is not ");
  }
}

/// Angles whose own rounding would show, and factors that leave no volume.
TEST(Deformation, RefusesWhatCannotBeMeant) {
  for (const std::string kind : {"twist:", "helix:", "bend:"}) {
    EXPECT_EQ(Deformation::parse(kind + "-1e6").amount(), -1e6);
    for (const std::string degrees : {"1e308", "-1.1e6"}) {
      EXPECT_USAGE_ERROR_PART(Deformation::parse(kind + degrees),
                              "'" + degrees + "' is not DEGREES, up to 1e6, or DEGREES:AX");
    }
  }
  for (const std::string factors : {"0", "-0.0", "1,0,1"}) {
    EXPECT_USAGE_ERROR(Deformation::parse("scale:" + factors),
                       start_of("scale:" + factors) + ": '" + factors +
                           "' is not one finite number other than 0, or three");
  }
}

TEST(Deformation, MessagesAreShort) {
  for (const std::string name :
       {"", "twist:", "helix:", "shear:", "bend:", "taper:", "scale:", "random:", "move:"}) {
    const std::string text = name + std::string(300, '?');
    EXPECT_LT(message_of<UsageError>([&] { Deformation::parse(text); }).size(), 200u) << name;
  }
}

TEST(Deformation, UnknownNamesListWhatIsAccepted) {
  const std::string accepted =
      "one of none, twist, helix, shear, bend, taper, scale, random, move, to";
  for (const std::string text : {"", "wobble", "twister:3", "Twist", " twist", ":90"}) {
    EXPECT_USAGE_ERROR(Deformation::parse(text), start_of(text) + " is unknown; " + accepted);
  }
  EXPECT_USAGE_ERROR(Deformation::parse("none:1"), "deformation 'none:1': none takes no argument");
}

TEST(Deformation, ArgumentsMustBeNumbers) {
  for (const std::string argument : {"", "ninety", "90deg", "1,5", "nan", "inf", "1e999", " 1"}) {
    const std::string text = "twist:" + argument;
    EXPECT_USAGE_ERROR_PART(
        Deformation::parse(text),
        start_of(text).append(": '").append(argument) + "' is not DEGREES, up to 1e6, or ");
  }
  for (const std::string argument : {"", "1.5", "-1", "x", "18446744073709551616"}) {
    EXPECT_USAGE_ERROR_PART(Deformation::parse("random:" + argument),
                            "'" + argument + "' is not an integer from 0 to 2^64 - 1");
  }
  for (const std::string argument : {"", "1,2", "1,2,3,4", "1,,3", "x", "1,2,inf"}) {
    EXPECT_USAGE_ERROR_PART(Deformation::parse("scale:" + argument),
                            "'" + argument + "' is not one finite number other than 0, or three");
  }
  for (const std::string argument : {"", "0,0,0", "0,0:1,1,1", "0,0,-1:1,1,1", "0,0,0:1,1",
                                     "0,0,0.5:1,1,1", "0,0,0:1,1,nan", "0,0,0:1,1,1:2"}) {
    EXPECT_USAGE_ERROR_PART(
        Deformation::parse("move:" + argument),
        "'" + argument + "' is not I,J,K:DX,DY,DZ, a point and three finite numbers");
  }
  for (const std::string text : {"move", "to", "to:"}) {
    EXPECT_USAGE_ERROR_PART(Deformation::parse(text), start_of(text) + ": '' is not ");
  }
}

TEST(Deformation, UsageErrorsEndWithStatusTwo) {
  EXPECT_EQ(Error("x").exit_status(), 1);
  EXPECT_EQ(UsageError("x").exit_status(), 2);
  try {
    Deformation::parse("wobble");
    ADD_FAILURE() << "no exception";
  } catch (const Error& error) {
    EXPECT_EQ(error.exit_status(), 2);
  }
}

/// Section 6 of the paper: the top 4 corners turn by 90 degrees about the y axis through the
/// centre, the other points are interpolated from the 8 corners.
TEST(Deformation, TwistTurnsTheTopCorners) {
  const Lattice twisted = deformed_by("twist:90", plain_cube());
  expect_point(twisted.point(0, 3, 0), Point(0, 3, 3));
  expect_point(twisted.point(3, 3, 0), Point(0, 3, 0));
  expect_point(twisted.point(3, 3, 3), Point(3, 3, 0));
  expect_point(twisted.point(0, 3, 3), Point(3, 3, 3));
  for (int i = 0; i < 4; ++i) {
    for (int k = 0; k < 4; ++k) expect_point(twisted.point(i, 0, k), Point(i, 0, k));
  }
  // A third of the way up: two thirds of (3, 0) and one third of (0, 0) in x and z.
  expect_point(twisted.point(3, 1, 0), Point(2, 1, 0));
  // Inside the top layer: bilinear between its corners, (1, 2) turned about (1.5, 1.5).
  expect_point(twisted.point(1, 3, 2), Point(2, 3, 2));
}

/// All points, in a lattice with three different sizes, against the interpolation of the corners'
/// positions written out.
TEST(Deformation, TwistInterpolatesTheCorners) {
  const Index3 dims{4, 6, 5};
  const Lattice start = Box(Point(-2, 0.5, 3), Eigen::Vector3d(2, 3, 5).asDiagonal()).lattice(dims);
  const Lattice twisted = deformed_by("twist:50", start);
  for (const auto& [i, j, k] : places(dims)) {
    Point expected = Point::Zero();
    for (const auto& [x, y, z] : places({2, 2, 2})) {
      const double a = x != 0 ? i / 3.0 : 1.0 - i / 3.0;
      const double b = y != 0 ? j / 5.0 : 1.0 - j / 5.0;
      const double d = z != 0 ? k / 4.0 : 1.0 - k / 4.0;
      expected += a * b * d * twisted.point(3 * x, 5 * y, 4 * z);
    }
    expect_point(twisted.point(i, j, k), expected);
  }
  const Point corner = start.point(3, 5, 0) - Point(-1, 0, 5.5);
  const double angle = 50.0 / kDegreesPerRadian;
  expect_point(twisted.point(3, 5, 0) - Point(-1, 0, 5.5),
               Point(std::cos(angle) * corner.x() + std::sin(angle) * corner.z(), corner.y(),
                     -std::sin(angle) * corner.x() + std::cos(angle) * corner.z()));
}

/// Interpolation moves a point along the chord from its place p to its turned place Rp, not along
/// the arc: at the fraction v of the height it stands at (1 - v)p + v Rp, which for 90 degrees has
/// the angle atan(v / (1 - v)) and the radius sqrt((1 - v)^2 + v^2). The model sits in the central
/// third, v from 1/3 to 2/3, and sees atan(2) - atan(1/2) = 36.87 of the 90 degrees. Uniform
/// B-splines reproduce linear data, so the deformed points lie on the same chords.
TEST(Deformation, CentralThirdSees36Point9Degrees) {
  const Lattice twisted = deformed_by("twist:90", plain_cube());
  const Support support = twisted.support({0, 0, 0});
  const auto arm = [&](double t) {
    const Point q = Oracle().evaluate(support, 1.0, t, 0.5);  // at rest on the line x = 2, z = 1.5
    return Eigen::Vector2d(q.x() - 1.5, -(q.z() - 1.5));
  };
  const auto degrees = [&](double t) {
    return std::atan2(arm(t)[1], arm(t)[0]) * kDegreesPerRadian;
  };
  EXPECT_NEAR(degrees(0.0), 26.565051177, 1e-8);
  EXPECT_NEAR(degrees(0.5), 45.0, 1e-10);
  EXPECT_NEAR(degrees(1.0), 63.434948823, 1e-8);
  EXPECT_NEAR(degrees(1.0) - degrees(0.0), 36.9, 0.05);
  EXPECT_NEAR(arm(0.0).norm(), 0.5 * std::sqrt(5.0) / 3.0, kDeformationTiny);
  EXPECT_NEAR(arm(0.5).norm(), 0.5 * std::sqrt(0.5), kDeformationTiny);
}

/// What the cells hold turns by the whole angle from their bottom to their top. Layers h apart draw
/// it towards the axis by (2 + cos h) / 3.
TEST(Deformation, HelixTurnsWhatTheCellsHold) {
  for (const int layers : {4, 5, 9, 16}) {
    const Lattice start =
        Box(Point(1, 5, 1), Eigen::Vector3d(1, 3, 1).asDiagonal()).lattice({4, layers, 4});
    for (const double degrees : {90.0, -40.0, 300.0}) {
      const Lattice turned = deformed_by("helix:" + std::to_string(degrees), start);
      const double step = degrees / (layers - 3) / kDegreesPerRadian;
      const double radius = 0.5 * (2.0 + std::cos(step)) / 3.0;
      for (int face = 0; face < layers - 2; ++face) {
        const int cell = std::min(face, layers - 4);
        // At rest on the line x = 2, z = 1.5, half a unit from the axis.
        const Point q = Oracle().evaluate(turned.support({0, cell, 0}), 1.0, face - cell, 0.5);
        const Point expected(1.5 + radius * std::cos(step * face), 5.0 + 3.0 * face / (layers - 3),
                             1.5 - radius * std::sin(step * face));
        expect_point(q, expected);
      }
    }
  }
}

TEST(Deformation, ShearLowersLeftAndLiftsRight) {
  const Lattice sheared = deformed_by("shear:0.5", plain_cube());
  for (const auto& [i, j, k] : places({4, 4, 4})) {
    const double lift = 1.5 * (2.0 * i / 3.0 - 1.0) * (1.0 - j / 3.0);
    expect_point(sheared.point(i, j, k), Point(i, j + lift, k));
  }
  EXPECT_LT(sheared.point(0, 0, 0).y(), 0.0);
  EXPECT_GT(sheared.point(3, 0, 0).y(), 0.0);
}

TEST(Deformation, BendMakesAnArc) {
  const Lattice bent = deformed_by("bend:90", plain_cube());
  const double radius = 3.0 / (90.0 / kDegreesPerRadian);
  for (int i = 0; i < 4; ++i) {
    for (int k = 0; k < 4; ++k) expect_point(bent.point(i, 0, k), Point(i, 0, k));
  }
  // The top layer has turned by 90 degrees towards +x: its points lie on a vertical line.
  expect_point(bent.point(0, 3, 1), Point(1.5 + radius, radius + 1.5, 1));
  expect_point(bent.point(3, 3, 1), Point(1.5 + radius, radius - 1.5, 1));
  const Lattice back = deformed_by("bend:-90", plain_cube());
  expect_point(back.point(3, 3, 1), Point(1.5 - radius, radius + 1.5, 1));
}

TEST(Deformation, RandomMovesEveryPointAlongItsOwnSpacing) {
  const Lattice start =
      Box(Point(0, 0, 0), Eigen::Vector3d(1, 10, 400).asDiagonal()).lattice({4, 5, 7});
  const Points moved = deformed_by("random:7", start).points() - start.points();
  const Eigen::RowVector3d spacing(1, 5, 100);
  const Points relative = moved.array().rowwise() / spacing.array();
  EXPECT_LE(relative.cwiseAbs().maxCoeff(), 0.3);
  for (int a = 0; a < 3; ++a) {
    EXPECT_GT(relative.col(a).maxCoeff(), 0.27);
    EXPECT_LT(relative.col(a).minCoeff(), -0.27);
    EXPECT_NEAR(relative.col(a).mean(), 0.0, 0.06);
    EXPECT_GT(relative.col(a).cwiseAbs().minCoeff(), 0.0);
  }
  EXPECT_GT((relative.col(0) - relative.col(1)).norm(), 1.0);
  EXPECT_EQ(relative.rows(), 140);
}

TEST(Deformation, RandomRepeatsItsSeed) {
  const Lattice start = plain_cube();
  EXPECT_EQ(deformed_by("random:7", start).points(), deformed_by("random:7", start).points());
  EXPECT_NE(deformed_by("random:7", start).points(), deformed_by("random:8", start).points());
  EXPECT_EQ(deformed_by("random", start).points(), deformed_by("random:1", start).points());
  // mt19937_64 with its default seed 5489 first gives 14514284786278117030 (C++ standard's engine).
  const double unit = static_cast<double>(14514284786278117030ull >> 11) * 0x1p-53;
  EXPECT_NEAR(deformed_by("random:5489", start).point(0, 0, 0).x(), 0.3 * (2.0 * unit - 1.0),
              kDeformationTiny);
}

}  // namespace
}  // namespace hwffd
