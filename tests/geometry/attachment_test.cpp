// Points attached to lattices: inside, outside, and to one lattice after the other.

#include "hwffd/lattice/attachment.hpp"

#include <gtest/gtest.h>

#include <Eigen/LU>
#include <cmath>
#include <limits>

#include "errors.hpp"
#include "hwffd/lattice/box.hpp"
#include "hwffd/lattice/closure.hpp"
#include "hwffd/lattice/cylinder.hpp"
#include "hwffd/lattice/deformation.hpp"
#include "hwffd/lattice/inverse.hpp"
#include "hwffd/lattice/lattice_evaluator.hpp"
#include "hwffd/lattice/outside.hpp"
#include "hwffd/oracle/oracle.hpp"
#include "named.hpp"
#include "same_bits.hpp"
#include "sample_lattices.hpp"

namespace hwffd {
namespace {

TEST(Outside, WeightsOfKeepAndClamp) {
  for (const double distance : {0.0, 1e-9, 1.0, 1e9}) {
    EXPECT_EQ(Outside::parse("keep").weight(distance), 0.0);
    EXPECT_EQ(Outside::parse("clamp").weight(distance), 1.0);
  }
  EXPECT_EQ(Outside::parse("keep").kind(), Outside::Kind::kKeep);
  EXPECT_EQ(Outside::parse("clamp").kind(), Outside::Kind::kClamp);
  EXPECT_EQ(Outside::parse("clamp").width(), 0.0);
}

TEST(Outside, FadeFallsSmoothlyFromOneToZero) {
  const Outside fade = Outside::parse("fade:2.5");
  EXPECT_EQ(fade.kind(), Outside::Kind::kFade);
  EXPECT_EQ(fade.width(), 2.5);
  EXPECT_EQ(fade.weight(0.0), 1.0);
  EXPECT_EQ(fade.weight(1.25), 0.5);
  EXPECT_EQ(fade.weight(2.5), 0.0);
  EXPECT_EQ(fade.weight(3.0), 0.0);
  double steepest = 0.0;
  for (int i = 0; i < 1000; ++i) {
    const double drop = fade.weight(i * 0.0025) - fade.weight((i + 1) * 0.0025);
    EXPECT_GT(drop, 0.0) << i;
    steepest = std::max(steepest, drop / 0.0025);
  }
  EXPECT_NEAR(steepest, 1.5 / 2.5, 1e-5);
  // The slope is zero at both ends: C1 with the constant weights beyond.
  EXPECT_LT((1.0 - fade.weight(1e-6)) / 1e-6, 1e-5);
  EXPECT_LT(fade.weight(2.5 - 1e-6) / 1e-6, 1e-5);
  for (const double distance : {0.3, 1.25, 2.4, 2.6}) {
    const double difference = fade.weight(distance + 1e-6) - fade.weight(distance - 1e-6);
    EXPECT_NEAR(fade.slope(distance), difference / 2e-6, 1e-8);
  }
  EXPECT_EQ(fade.slope(0.0), 0.0);
  EXPECT_EQ(Outside::parse("clamp").slope(1.0), 0.0);
}

TEST(Outside, RefusesTheRest) {
  const std::string accepted = "; accepted are keep, clamp and fade:WIDTH";
  for (const std::string text : {"", "fade", "Keep", "keep:1", "clamp:", "drop"}) {
    EXPECT_USAGE_ERROR(
        Outside::parse(text),
        std::string("outside '").append(text).append("' is unknown").append(accepted));
  }
  for (const std::string width : {"", "0", "-1", "nan", "inf", "1e999", "x", "1 ", "0x1"}) {
    const std::string message = message_of<UsageError>([&] { Outside::parse("fade:" + width); });
    expect_part(message, "outside 'fade:" + width + "': ");
    const std::string what = "' is not a finite number above 0";
    expect_part(message, std::string("'").append(width).append(what).append(accepted));
  }
}

const Eigen::Matrix3d kUnit = Eigen::Matrix3d::Identity();

Lattice unit_box() { return Box(Point::Zero(), kUnit).lattice({5, 4, 4}); }

/// The points when the lattice they are attached to is deformed.
Points followed(const Attachment& attachment, const Lattice& deformed) {
  return attachment.follow(test::points_at(Embedder(deformed), attachment.places()));
}

Attachment attached(const Lattice& rest, const Points& points, const char* outside) {
  return Attachment(rest, points, Outside::parse(outside));
}

/// Two inside, two outside at distance 1 and 0.25 of the unit box.
Points four_points() {
  Points points(4, 3);
  points << 0.5, 0.5, 0.5, 2.0, 0.25, 0.75, 0.25, 1.25, 0.5, 0.0, 1.0, 0.0;
  return points;
}

TEST(Attachment, InsideIsEvaluatedAndKeptIsKept) {
  const Points points = four_points();
  const Attachment keep = attached(unit_box(), points, "keep");
  ASSERT_EQ(keep.places().size(), 2u);
  EXPECT_EQ(keep.summary().inside, 2u);
  EXPECT_EQ(keep.summary().outside, 2u);
  EXPECT_EQ(keep.size(), 4);
  Points evaluated(2, 3);
  evaluated << 0.1, 0.2, 0.3, 7, 8, 9;
  const Points result = keep.follow(evaluated);
  EXPECT_EQ(result.row(0), evaluated.row(0));
  EXPECT_EQ(result.row(1), points.row(1));
  EXPECT_EQ(result.row(2), points.row(2));
  EXPECT_EQ(result.row(3), evaluated.row(1));
}

TEST(Attachment, OutsideFollowsTheNearestPlace) {
  const Points points = four_points();
  const Lattice moved(unit_box().dims(),
                      unit_box().points().rowwise() + Eigen::RowVector3d(1, 2, 3));
  const Points clamped = followed(attached(unit_box(), points, "clamp"), moved);
  EXPECT_LT((clamped - (points.rowwise() + Eigen::RowVector3d(1, 2, 3))).norm(), 1e-14);
  const Attachment fade = attached(unit_box(), points, "fade:0.5");
  EXPECT_EQ(fade.places().size(), 3u);
  const Points faded = followed(fade, moved);
  EXPECT_EQ(faded.row(1), points.row(1));  // beyond the width
  EXPECT_LT((faded.row(2) - points.row(2) - 0.5 * Eigen::RowVector3d(1, 2, 3)).norm(), 1e-14);
  EXPECT_LT((faded.row(3) - points.row(3) - Eigen::RowVector3d(1, 2, 3)).norm(), 1e-14);
  for (const Embedded& place : fade.places()) {
    EXPECT_TRUE((place.local.array() >= 0).all() && (place.local.array() <= 1).all());
  }
}

TEST(Attachment, RefusesWhatItCannotPlace) {
  Points points = four_points();
  const Attachment keep = attached(unit_box(), points, "keep");
  EXPECT_ERROR(keep.follow(Points::Zero(3, 3)),
               "3 evaluated places given; give 2, one for each of places()");
  const Lattice other = Box(Point::Zero(), kUnit).lattice({4, 4, 4});
  EXPECT_ERROR(keep.gradients(other), "deformed lattice has 4 x 4 x 4 points; give 5 x 4 x 4");
  points(2, 1) = std::numeric_limits<double>::infinity();
  EXPECT_ERROR(attached(unit_box(), points, "clamp"),
               "point 2 is not finite; give finite coordinates");
}

/// Points a hair inside and outside the faces where a lattice ends.
struct AcrossFaces {
  AcrossFaces(const Lattice& lattice, double step) {
    const Embedder embedder(lattice);
    const Closure closure(lattice);
    const Index3 cells = lattice.cells();
    std::vector<Point> in;
    std::vector<Point> out;
    for (Embedded at : test::known_places(lattice, 600, 4)) {
      for (std::size_t f = 0; f < 6; ++f) {
        const std::size_t axis = f / 2;
        const int end = static_cast<int>(f % 2);
        if (at.cell[axis] != end * (cells[axis] - 1) || !ends(closure, axis, end)) continue;
        at.local[static_cast<Eigen::Index>(axis)] = end;
        const Eigen::Matrix3d jacobian = Oracle().jet(lattice.support(at.cell), at.local).jacobian;
        if (std::abs(jacobian.determinant()) < 1e-6 * std::pow(jacobian.norm(), 3)) continue;
        Point normal = jacobian.inverse().row(static_cast<Eigen::Index>(axis));
        normal *= (end == 0 ? -step : step) / normal.norm();
        in.push_back(embedder.point(at) - normal);
        out.push_back(embedder.point(at) + normal);
        break;
      }
    }
    inside = rows(in);
    outside = rows(out);
  }

  static bool ends(const Closure& closure, std::size_t axis, int end) {
    for (const Closure::Collapsed& face : closure.collapsed()) {
      if (face.axis == static_cast<int>(axis) && face.end == end) return false;
    }
    return !closure.closed(static_cast<int>(axis));
  }

  static Points rows(const std::vector<Point>& list) {
    Points points(static_cast<Eigen::Index>(list.size()), 3);
    for (std::size_t i = 0; i < list.size(); ++i) {
      points.row(static_cast<Eigen::Index>(i)) = list[i];
    }
    return points;
  }

  Points inside, outside;
};

class AttachmentKind : public testing::TestWithParam<std::string> {};

/// The displacement is continuous across the faces with clamp and fade; with keep it jumps.
TEST_P(AttachmentKind, DisplacementIsContinuousAcrossFaces) {
  const Lattice rest = test::sample_lattice(GetParam(), test::corners());
  const Lattice deformed = Deformation::parse("bend:50").apply(rest);
  const double size = Embedder(rest).size();
  const AcrossFaces pairs(rest, 1e-7 * size);
  ASSERT_GT(pairs.inside.rows(), 50);
  for (const char* const how : {"clamp", "fade:3", "keep"}) {
    const Attachment in = attached(rest, pairs.inside, how);
    const Attachment out = attached(rest, pairs.outside, how);
    // At edges where faces meet at an angle, a step along one normal can stay inside or leave.
    EXPECT_GT(in.summary().inside, in.summary().points * 9 / 10);
    EXPECT_GT(out.summary().outside, out.summary().points * 9 / 10);
    const Points jump =
        (followed(in, deformed) - pairs.inside) - (followed(out, deformed) - pairs.outside);
    const double worst = jump.rowwise().norm().maxCoeff();
    if (how == std::string("keep")) {
      EXPECT_GT(worst, 1e-2 * size);
    } else {
      EXPECT_LE(worst, 1e-6 * size) << how;
    }
  }
}

INSTANTIATE_TEST_SUITE_P(, AttachmentKind, testing::ValuesIn(test::lattice_kinds()), test::by_name);

TEST(Attachment, TornEdgesAreCountedOnce) {
  Points points(5, 3);
  points << 0.5, 0.5, 0.5,  // inside
      0.9, 0.5, 0.5,        // inside
      2, 0, 0, 2, 1, 0, 2, 1, 1;
  // Edges in: 0-1. Torn: 0-2, 1-2, 1-3, 0-3. Out: 2-3, 3-4, 2-4.
  const std::vector<std::array<std::uint32_t, 3>> triangles{
      {0, 1, 2}, {2, 1, 3}, {1, 0, 3}, {2, 3, 4}, {0, 2, 3}};
  EXPECT_EQ(attached(unit_box(), points, "keep").torn_edges(triangles), 4u);
  EXPECT_EQ(attached(unit_box(), points, "clamp").torn_edges(triangles), 0u);
  EXPECT_EQ(attached(unit_box(), points, "fade:0.1").torn_edges(triangles), 0u);
}

struct Stage {
  Lattice rest;
  Lattice deformed;
};

Stage stage(const Lattice& rest, const std::string& deformation) {
  return {rest, Deformation::parse(deformation).apply(rest)};
}

/// A tall box around everything, twisted; in its middle a thin can, which swells.
const Eigen::Matrix3d kBox = Eigen::Vector3d(4, 6, 4).asDiagonal();
const Eigen::Matrix3d kCan = Eigen::Vector3d(1, 2, 1).asDiagonal();
Stage global_stage() { return stage(Box(Point(-2, 0, -2), kBox).lattice({6, 7, 6}), "twist:80"); }
Stage local_stage() {
  return stage(Cylinder(Point(0, 2, 0), kCan).lattice({4, 6, 11}), "scale:1.3,1,1.2");
}

Points after(const Stage& stage, const Points& points) {
  return followed(attached(stage.rest, points, "keep"), stage.deformed);
}

/// A grid in the box, most of it outside the can.
Points grid() {
  Points points(9 * 13 * 9, 3);
  Eigen::Index row = 0;
  for (const auto& [i, j, k] : places({9, 13, 9})) {
    points.row(row++) = Point(-1.6, 0.5, -1.6) + 0.4 * Point(i, j, k);
  }
  return points;
}

/// One point at a time, without Attachment: where the stage takes it.
Point by_hand(const Stage& stage, const Point& point) {
  const Embedding embedding = Embedder(stage.rest).embed(point);
  if (embedding.status != EmbeddingStatus::kInside) return point;
  return Embedder(stage.deformed).point(embedding.at);
}

TEST(Hierarchy, StagesComposeAndTheRestFollowsTheGlobalOneAlone) {
  const Stage local = local_stage();
  const Stage global = global_stage();
  const Points points = grid();
  const Points both = after(global, after(local, points));
  const Points global_only = after(global, points);
  const Embedder can(local.rest);
  int inside = 0;
  int outside = 0;
  for (Eigen::Index i = 0; i < points.rows(); ++i) {
    const Point point = points.row(i);
    const Point result = both.row(i);
    if (can.embed(point).status == EmbeddingStatus::kOutside) {
      EXPECT_TRUE(same_bits(result, Point(global_only.row(i)))) << i;
      ++outside;
      continue;
    }
    EXPECT_TRUE(same_bits(result, by_hand(global, by_hand(local, point)))) << i;
    if (point[0] != 0.0 && point[2] != 0.0) {
      EXPECT_GT((result - Point(global_only.row(i))).norm(), 1e-3) << i;
    }
    ++inside;
  }
  EXPECT_GT(inside, 80);
  EXPECT_GT(outside, 800);
}

// Nearest places turn corners, on whose two sides derivatives are others.
TEST(Inverse, FindsNearlyEveryPointThatFollows) {
  constexpr Eigen::Index kPoints = 300;
  const Lattice rest = Cylinder(Point(0, -1, 0), 1.4 * kUnit).lattice({4, 5, 10});
  const Lattice deformed =
      Deformation::parse("bend:15").apply(Deformation::parse("twist:20").apply(rest));
  const Embedder embedder(rest);
  const Points points = 2.5 * Points::Random(kPoints, 3);
  for (const std::string text : {"clamp", "fade:5"}) {
    const Outside outside = Outside::parse(text);
    const auto moved = [&](const Points& from) {
      const Attachment at(embedder, from, outside);
      const Oracle::Coefficients bspline = Oracle::uniform_bspline();
      return at.follow(evaluate_in(deformed, at.places(), {bspline, bspline, bspline}));
    };
    const Points targets = moved(points);
    Points found = inverse_of(embedder, deformed, outside, targets);
    Eigen::Index lost = 0;
    for (Eigen::Index i = 0; i < kPoints; ++i) {
      if (found.row(i).allFinite()) continue;
      found.row(i) = points.row(i);
      ++lost;
    }
    EXPECT_LE(lost, 3 * kPoints / 100) << text;
    EXPECT_LT((moved(found) - targets).rowwise().norm().maxCoeff(), 1e-11) << text;
  }
}

/// In the other order the local lattice would stay where the object was.
TEST(Hierarchy, OrderMatters) {
  const Points points = grid();
  const Points right = after(global_stage(), after(local_stage(), points));
  const Points wrong = after(local_stage(), after(global_stage(), points));
  EXPECT_GT((right - wrong).rowwise().norm().maxCoeff(), 0.1);
}

}  // namespace
}  // namespace hwffd
