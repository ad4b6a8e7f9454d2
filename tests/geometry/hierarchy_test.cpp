// Lattices in order, a local one before a global one (paper, section 2: FFDs "can be applied
// hierarchically to perform both local and global space deformations").
#include <gtest/gtest.h>

#include "embed/samples.hpp"
#include "hwffd/lattice/attachment.hpp"
#include "hwffd/lattice/cylinder.hpp"
#include "hwffd/lattice/deformation.hpp"
#include "same_bits.hpp"

namespace hwffd {
namespace {

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
  const Attachment attachment(stage.rest, points, Outside::parse("keep"));
  return attachment.follow(embed::points_at(Embedder(stage.deformed), attachment.places()));
}

/// A grid in the box, most of it outside the can.
Points grid() {
  Points points(9 * 13 * 9, 3);
  for (int n = 0; n < points.rows(); ++n) {
    const Eigen::RowVector3i step(n / 117, n / 9 % 13, n % 9);
    points.row(n) = Eigen::RowVector3d(-1.6, 0.5, -1.6) + 0.4 * step.cast<double>();
  }
  return points;
}

/// One point at a time, without Attachment: where the stage takes it.
Point by_hand(const Stage& stage, const Point& point) {
  const Embedding found = Embedder(stage.rest).embed(point);
  if (found.status != EmbeddingStatus::kInside) return point;
  return Embedder(stage.deformed).point(found.at);
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

/// In the other order the local lattice would stay where the object was.
TEST(Hierarchy, OrderMatters) {
  const Points points = grid();
  const Points right = after(global_stage(), after(local_stage(), points));
  const Points wrong = after(local_stage(), after(global_stage(), points));
  EXPECT_GT((right - wrong).rowwise().norm().maxCoeff(), 0.1);
}

}  // namespace
}  // namespace hwffd
