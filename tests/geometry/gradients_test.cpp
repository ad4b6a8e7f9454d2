// Derivatives of the map of points attached to a lattice, inside and outside its cells.

#include <gtest/gtest.h>

#include <array>
#include <random>
#include <string>
#include <vector>

#include "errors.hpp"
#include "hwffd/lattice/attachment.hpp"
#include "hwffd/lattice/box.hpp"
#include "hwffd/lattice/deformation.hpp"
#include "hwffd/lattice/outside.hpp"
#include "hwffd/oracle/oracle.hpp"
#include "named.hpp"
#include "sample_lattices.hpp"
#include "uniform.hpp"

namespace hwffd {
namespace {

const Eigen::Matrix3d kUnitGradient = Eigen::Matrix3d::Identity();

Lattice unit_box() { return Box(Point::Zero(), kUnitGradient).lattice({5, 4, 4}); }

/// The points when the lattice they are attached to is deformed.
Points followed(const Attachment& attachment, const Lattice& deformed) {
  return attachment.follow(test::points_at(Embedder(deformed), attachment.places()));
}

Attachment attached(const Lattice& rest, const Points& points, const std::string& outside) {
  return Attachment(rest, points, Outside::parse(outside));
}

/// Two inside, two outside at distance 1 and 0.25 of the unit box.
Points four_points() {
  Points points(4, 3);
  points << 0.5, 0.5, 0.5, 2.0, 0.25, 0.75, 0.25, 1.25, 0.5, 0.0, 1.0, 0.0;
  return points;
}

class GradientsKind : public testing::TestWithParam<std::string> {};

TEST_P(GradientsKind, InsideAgainstCentralDifferences) {
  const Lattice rest = test::sample_lattice(GetParam(), test::corners());
  const Lattice deformed = Deformation::parse("bend:50").apply(rest);
  const Embedder embedder(rest);
  const double step = 1e-5 * embedder.size();
  const Points points = test::points_at(embedder, test::known_places(rest, 300, 9));
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
    const Embedding embedding = attachment.embedding(i);
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

/// Where points outside follow, too; there the cells that are compared with end.
TEST_P(GradientsKind, OutsideAgainstCentralDifferences) {
  const Lattice rest = test::sample_lattice(GetParam(), test::corners());
  const Lattice deformed = Deformation::parse("bend:50").apply(rest);
  const Embedder embedder(rest);
  const double size = embedder.size();
  const Eigen::RowVector3d low = rest.points().colwise().minCoeff();
  const Eigen::RowVector3d extent = rest.points().colwise().maxCoeff() - low;
  std::mt19937_64 engine(5);
  Points points(200, 3);
  for (Eigen::Index i = 0; i < points.rows(); ++i) {
    for (Eigen::Index c = 0; c < 3; ++c) {
      points(i, c) = low[c] + extent[c] * (1.2 * unit(engine) - 0.1);
    }
  }
  for (const std::string outside : {"clamp", "fade:3"}) {
    const std::vector<Eigen::Matrix3d> gradients =
        attached(rest, points, outside).gradients(deformed);
    const double step = 1e-5 * size;
    std::array<Points, 6> shifted;
    for (int d = 0; d < 6; ++d) {
      const Points at =
          points.rowwise() + (d % 2 == 0 ? step : -step) * Eigen::RowVector3d::Unit(d / 2);
      shifted[static_cast<std::size_t>(d)] = followed(attached(rest, at, outside), deformed);
    }
    int compared = 0;
    int apart = 0;
    for (Eigen::Index i = 0; i < points.rows(); ++i) {
      const Eigen::Matrix3d& gradient = gradients[static_cast<std::size_t>(i)];
      if (embedder.embed(Point(points.row(i))).status != EmbeddingStatus::kOutside) continue;
      ASSERT_TRUE(gradient.allFinite()) << outside << " " << i;
      Eigen::Matrix3d difference;
      for (std::size_t a = 0; a < 3; ++a) {
        difference.col(static_cast<Eigen::Index>(a)) =
            (shifted[2 * a].row(i) - shifted[2 * a + 1].row(i)) / (2 * step);
      }
      ++compared;
      // Few lie where the nearest place turns from one face into another.
      if ((gradient - difference).norm() > 1e-3 * (1 + difference.norm())) ++apart;
    }
    EXPECT_GT(compared, 40) << outside;
    EXPECT_LE(apart, compared / 20) << outside;
  }
}

INSTANTIATE_TEST_SUITE_P(, GradientsKind, testing::ValuesIn(test::lattice_kinds()), test::by_name);

TEST(Gradients, OfPointsOutside) {
  const Points points = four_points();
  const Lattice deformed = Deformation::parse("twist:30").apply(unit_box());
  const auto keep_gradients = attached(unit_box(), points, "keep").gradients(deformed);
  EXPECT_EQ(keep_gradients[1], kUnitGradient);
  EXPECT_EQ(keep_gradients[2], kUnitGradient);
  EXPECT_TRUE(keep_gradients[0].allFinite() && keep_gradients[3].allFinite());
  EXPECT_NE(keep_gradients[0], kUnitGradient);
  const auto fade_gradients = attached(unit_box(), points, "fade:0.5").gradients(deformed);
  EXPECT_EQ(fade_gradients[1], kUnitGradient);
  EXPECT_TRUE(fade_gradients[2].allFinite());
  EXPECT_NE(fade_gradients[2], kUnitGradient);
}

TEST(Gradients, FromDerivativesOfAnother) {
  const Points points = four_points();
  const Lattice deformed = Deformation::parse("twist:30").apply(unit_box());
  for (const char* outside : {"keep", "clamp"}) {
    const Attachment attachment = attached(unit_box(), points, outside);
    const auto count = static_cast<Eigen::Index>(attachment.places().size());
    std::vector<Eigen::Matrix3d> jacobians;
    Points evaluated(count, 3);
    for (const Embedded& at : attachment.places()) {
      const Oracle::Jet jet = Oracle().jet(deformed.support(at.cell), at.local);
      evaluated.row(static_cast<Eigen::Index>(jacobians.size())) = jet.value;
      jacobians.push_back(jet.jacobian);
    }
    EXPECT_EQ(attachment.gradients(jacobians, evaluated), attachment.gradients(deformed));
    EXPECT_ERROR(
        attachment.gradients(jacobians, Points::Zero(1, 3)),
        "1 evaluated places given; give " + std::to_string(count) + ", one for each of places()");
    jacobians.pop_back();
    EXPECT_ERROR(attachment.gradients(jacobians, evaluated),
                 std::to_string(count - 1) + " derivatives for " + std::to_string(count) +
                     " places; give one for each place");
  }
}

}  // namespace
}  // namespace hwffd
