#include "hwffd/lattice/attachment.hpp"

#include <gtest/gtest.h>

#include <Eigen/LU>
#include <cmath>
#include <limits>

#include "embed/samples.hpp"
#include "errors.hpp"
#include "hwffd/lattice/box.hpp"
#include "hwffd/lattice/closure.hpp"
#include "hwffd/lattice/deformation.hpp"
#include "hwffd/oracle/oracle.hpp"
#include "named.hpp"

namespace hwffd {
namespace {

const Eigen::Matrix3d kUnit = Eigen::Matrix3d::Identity();

Lattice unit_box() { return Box(Point::Zero(), kUnit).lattice({5, 4, 4}); }

Points evaluate(const Lattice& lattice, const std::vector<Embedded>& places) {
  return embed::points_at(Embedder(lattice), places);
}

/// The points when the lattice they are attached to is deformed.
Points followed(const Attachment& attachment, const Lattice& deformed) {
  return attachment.follow(evaluate(deformed, attachment.places()));
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
  EXPECT_EQ(keep.embeddings().size(), 4u);
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
    for (Embedded at : embed::known_places(lattice, 600, 4)) {
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
  const Lattice rest = embed::sample_lattice(GetParam(), embed::corners());
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

TEST_P(AttachmentKind, GradientsAgainstCentralDifferences) {
  const Lattice rest = embed::sample_lattice(GetParam(), embed::corners());
  const Lattice deformed = Deformation::parse("bend:50").apply(rest);
  const Embedder embedder(rest);
  const double step = 1e-5 * embedder.size();
  const Points points = embed::points_at(embedder, embed::known_places(rest, 300, 9));
  const Attachment attachment = attached(rest, points, "clamp");
  const std::vector<Eigen::Matrix3d> gradients = attachment.gradients(deformed);
  std::array<Points, 6> shifted;
  for (int d = 0; d < 6; ++d) {
    const Points at =
        points.rowwise() + (d % 2 == 0 ? step : -step) * Eigen::RowVector3d::Unit(d / 2);
    shifted[static_cast<std::size_t>(d)] = followed(attached(rest, at, "clamp"), deformed);
  }
  int compared = 0;
  int unknown = 0;
  for (Eigen::Index i = 0; i < points.rows(); ++i) {
    const Eigen::Matrix3d& gradient = gradients[static_cast<std::size_t>(i)];
    const Embedding& embedding = attachment.embeddings()[static_cast<std::size_t>(i)];
    if (!gradient.allFinite()) {
      EXPECT_TRUE(gradient.array().isNaN().all());
      ++unknown;
      continue;
    }
    // Away from faces, beyond which the differences see another map.
    if ((embedding.at.local.array() < 1e-3).any() || (embedding.at.local.array() > 0.999).any()) {
      continue;
    }
    Eigen::Matrix3d difference;
    for (std::size_t a = 0; a < 3; ++a) {
      difference.col(static_cast<Eigen::Index>(a)) =
          (shifted[2 * a].row(i) - shifted[2 * a + 1].row(i)) / (2 * step);
    }
    EXPECT_LT((gradient - difference).norm(), 1e-5) << i;
    ++compared;
  }
  EXPECT_GT(compared, 100);
  if (GetParam() == "cylinder" || GetParam() == "sphere") {
    EXPECT_GT(unknown, 0);
  } else {
    EXPECT_EQ(unknown, 0);
  }
}

INSTANTIATE_TEST_SUITE_P(, AttachmentKind, testing::ValuesIn(embed::lattice_kinds()),
                         test::by_name);

TEST(Attachment, GradientsOutside) {
  const Points points = four_points();
  const Lattice deformed = Deformation::parse("twist:30").apply(unit_box());
  const auto kept = attached(unit_box(), points, "keep").gradients(deformed);
  EXPECT_EQ(kept[1], kUnit);
  EXPECT_EQ(kept[2], kUnit);
  EXPECT_TRUE(kept[0].allFinite() && kept[3].allFinite());
  EXPECT_NE(kept[0], kUnit);
  const auto faded = attached(unit_box(), points, "fade:0.5").gradients(deformed);
  EXPECT_EQ(faded[1], kUnit);
  EXPECT_TRUE(faded[2].array().isNaN().all());
}

TEST(Attachment, GradientsFromDerivativesOfAnother) {
  const Points points = four_points();
  const Attachment attachment = attached(unit_box(), points, "keep");
  const Lattice deformed = Deformation::parse("twist:30").apply(unit_box());
  std::vector<Eigen::Matrix3d> jacobians;
  for (const Embedded& at : attachment.places()) {
    jacobians.push_back(Oracle().jet(deformed.support(at.cell), at.local).jacobian);
  }
  EXPECT_EQ(attachment.gradients(jacobians), attachment.gradients(deformed));
  jacobians.pop_back();
  EXPECT_ERROR(attachment.gradients(jacobians),
               "1 derivatives for 2 places; give one for each place");
}

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

}  // namespace
}  // namespace hwffd
