// Weights of control points, their transpose product, and normals that a deformation carries.

#include "hwffd/lattice/weights.hpp"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <cmath>

#include "cube.hpp"
#include "errors.hpp"
#include "hwffd/lattice/around.hpp"
#include "hwffd/lattice/carried_normals.hpp"
#include "hwffd/lattice/deformation.hpp"
#include "hwffd/lattice/lattice_evaluator.hpp"

namespace hwffd {
namespace {

/// Points in and around a ball, attached with a family.
struct Scene {
  explicit Scene(const std::string& name, const std::string& outside = "fade:0.7")
      : family(Family::parse(name)),
        rest(
            family.from_bspline(lattice_around("sphere", cube(), family.bspline_dims({7, 7, 10})))),
        points(1.6 * Points::Random(300, 3)),
        attachment(rest, points, Outside::parse(outside), family) {}

  Points follow(const Lattice& deformed) const {
    const Family::Evaluable evaluable = family.evaluable(deformed);
    std::vector<Embedded> places;
    for (const Embedded& place : attachment.places()) places.push_back(evaluable.at(place));
    return attachment.follow(evaluate_in(evaluable.lattice, places, evaluable.blending));
  }

  Family family;
  Lattice rest;
  Points points;
  Attachment attachment;
};

Points product(const SparseRows& w, const Points& control) {
  Points result = Points::Zero(static_cast<Eigen::Index>(w.starts.size()) - 1, 3);
  for (std::size_t row = 0; row + 1 < w.starts.size(); ++row) {
    for (auto i = static_cast<std::size_t>(w.starts[row]);
         i < static_cast<std::size_t>(w.starts[row + 1]); ++i) {
      result.row(static_cast<Eigen::Index>(row)) += w.values[i] * control.row(w.columns[i]);
    }
  }
  return result;
}

TEST(Weights, TimesControlPointsAreThePointsThatFollow) {
  for (const std::string& name : Family::names()) {
    for (const std::string outside : {"keep", "clamp", "fade:0.7"}) {
      const Scene scene(name, outside);
      ASSERT_GT(scene.attachment.summary().outside, 20u);
      ASSERT_GT(scene.attachment.summary().inside, 20u);
      const Lattice deformed = Deformation::parse("random:5").apply(scene.rest);
      const SparseRows weights = weights_of(scene.attachment);
      const Points linear = product(weights, deformed.points()) + unmoved_part(scene.attachment);
      EXPECT_LT((linear - scene.follow(deformed)).cwiseAbs().maxCoeff(), 1e-12)
          << name << " " << outside;
    }
  }
}

TEST(Weights, RowsAreSortedAndStayingPointsHaveNone) {
  const Scene scene("bspline", "keep");
  const SparseRows weights = weights_of(scene.attachment);
  ASSERT_EQ(weights.starts.size(), 301u);
  for (std::size_t row = 0; row < 300; ++row) {
    const auto first = static_cast<std::size_t>(weights.starts[row]);
    const auto end = static_cast<std::size_t>(weights.starts[row + 1]);
    EXPECT_EQ(end - first, scene.attachment.is_inside(static_cast<Eigen::Index>(row)) ? 64u : 0u);
    for (std::size_t i = first + 1; i < end; ++i) {
      EXPECT_LT(weights.columns[i - 1], weights.columns[i]);
    }
  }
  EXPECT_EQ(weights.values.size(), weights.columns.size());
  EXPECT_EQ(weights.values.size(), static_cast<std::size_t>(weights.starts.back()));
}

// The number is the sum of squares of the points' distances from where they were.
TEST(Weights, PullBackIsTheGradientOfFiniteDifferences) {
  for (const std::string& name : Family::names()) {
    const Scene scene(name);
    const Lattice deformed = Deformation::parse("random:5").apply(scene.rest);
    const Points gradient =
        pull_back(scene.attachment, 2 * (scene.follow(deformed) - scene.points));
    ASSERT_EQ(gradient.rows(), deformed.points().rows());
    constexpr double kStep = 1e-4;
    for (const Eigen::Index row : {0, 17, 111, 230, 480}) {
      for (Eigen::Index c = 0; c < 3; ++c) {
        const auto cost = [&](double step) {
          Points points = deformed.points();
          points(row, c) += step;
          return (scene.follow(Lattice(deformed.dims(), points)) - scene.points).squaredNorm();
        };
        // Exact for a quadratic number, but for rounding.
        const double slope = (cost(kStep) - cost(-kStep)) / (2 * kStep);
        EXPECT_NEAR(gradient(row, c), slope, 1e-8) << name << " " << row;
      }
    }
    EXPECT_GT(gradient.norm(), 0.1);
  }
  EXPECT_ERROR(pull_back(Scene("bspline").attachment, Points::Zero(7, 3)),
               "gradient of 7 points for 300 that are attached; give a row for each");
}

TEST(Weights, OfNoPoints) {
  const Lattice rest = lattice_around("box", cube(), {4, 4, 4});
  const Attachment none(rest, Points(0, 3), Outside::parse("keep"));
  EXPECT_EQ(weights_of(none).starts, std::vector<std::int64_t>{0});
  EXPECT_TRUE(pull_back(none, Points(0, 3)).isZero());
}

TEST(CarriedNormals, FollowTheSurface) {
  Eigen::Matrix3d shear = Eigen::Matrix3d::Identity();
  shear(0, 1) = 2;
  const Eigen::Matrix3d mirror = Eigen::Vector3d(1, -1, 1).asDiagonal();
  const Eigen::Matrix3d unknown = Eigen::Matrix3d::Constant(std::nan(""));
  const Points normals = (Points(5, 3) << 1, 0, 0, 0, 3, 0, 0, 1, 0, 1, 2, 3, 0, 0, 0).finished();
  const Points got =
      carried_normals({shear, shear, mirror, unknown, Eigen::Matrix3d::Identity()}, normals);
  const double side = std::sqrt(5.0);
  EXPECT_LT((got.row(0) - Eigen::RowVector3d(1, -2, 0) / side).norm(), 1e-15);
  EXPECT_LT((got.row(1) - Eigen::RowVector3d(0, 1, 0)).norm(), 1e-15);
  EXPECT_LT((got.row(2) - Eigen::RowVector3d(0, -1, 0)).norm(), 1e-15);
  EXPECT_TRUE(got.row(3).array().isNaN().all());
  EXPECT_TRUE(got.row(4).array().isNaN().all());
  EXPECT_ERROR(carried_normals({shear}, normals),
               "5 normals for 1 points; give a row for each point");
}

}  // namespace
}  // namespace hwffd
