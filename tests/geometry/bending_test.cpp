#include "hwffd/lattice/bending.hpp"

#include <gtest/gtest.h>

#include "errors.hpp"
#include "hwffd/lattice/attachment.hpp"
#include "hwffd/lattice/box.hpp"
#include "hwffd/lattice/deformation.hpp"
#include "hwffd/lattice/embedder.hpp"
#include "hwffd/lattice/inverse.hpp"
#include "hwffd/lattice/sphere.hpp"

namespace hwffd {
namespace {

const Eigen::Matrix3d kEdges = (Eigen::Matrix3d() << 1, 0.25, 0, 0, 2, 0, 0.5, 0, 3).finished();

/// An oblique box of cells, whose control points move along y by a quadratic function of their
/// place, x^T H x / 2: so does space, but for a constant.
TEST(Bending, OfQuadraticFunctionsIsTheirSecondDerivatives) {
  const Lattice rest = Box(Point(1, 2, 3), kEdges).lattice({6, 5, 7});
  Eigen::Matrix3d second;
  second << 1, 0.5, -2, 0.5, 3, 0.25, -2, 0.25, -1;
  Points moved = rest.points();
  for (Eigen::Index i = 0; i < moved.rows(); ++i) {
    const Point at = rest.points().row(i);
    moved(i, 1) += at.dot(second * at) / 2;
  }
  const Lattice deformed(rest.dims(), moved);
  EXPECT_NEAR(bending_energy(rest, deformed), second.squaredNorm(), 1e-9);
}

TEST(Bending, OfAffineMapsIsNone) {
  const Lattice rest = Box(Point(1, 2, 3), kEdges).lattice({4, 5, 7});
  const Lattice turned(rest.dims(), rest.points() * kEdges);
  EXPECT_NEAR(bending_energy(rest, turned), 0.0, 1e-20);
  const Family clamped(Family::Kind::kClamped);
  EXPECT_NEAR(bending_energy(clamped.from_bspline(rest), clamped.from_bspline(turned), clamped),
              0.0, 1e-20);
}

TEST(Bending, RefusesWhatIsNoBox) {
  const Lattice ball = Sphere(Point::Zero(), Eigen::Matrix3d::Identity()).lattice({4, 6, 9});
  EXPECT_ERROR(bending_energy(ball, ball),
               "bending energy: the lattice at rest is no box of even cells; give one, as around "
               "'box' makes it");
  const Lattice box = Box(Point::Zero(), kEdges).lattice({4, 5, 7});
  EXPECT_ERROR(bending_energy(box, ball), "deformed lattice has 4 x 6 x 9 points; give 4 x 5 x 7");
}

TEST(Inverse, ComesBackInsideAndOutside) {
  const Lattice rest = Box(Point::Zero(), Eigen::Matrix3d::Identity()).lattice({5, 5, 5});
  const Lattice deformed = Deformation::parse("bend:30").apply(rest);
  const Embedder embedder(rest);
  Points points(3, 3);
  points << 0.5, 0.25, 0.75, 1.5, 0.5, 0.5, -0.25, 0.5, 1.25;
  for (const char* how : {"clamp", "fade:4"}) {
    const Outside outside = Outside::parse(how);
    const Attachment attachment(embedder, points, outside);
    Points evaluated(3, 3);
    for (int i = 0; i < 3; ++i) {
      const Embedded& at = attachment.places()[static_cast<std::size_t>(i)];
      evaluated.row(i) = Oracle().jet(deformed.support(at.cell), at.local).value;
    }
    const Points back = inverse_of(embedder, deformed, outside, attachment.follow(evaluated));
    EXPECT_LT((back - points).cwiseAbs().maxCoeff(), 1e-11) << how;
  }
}

/// What stays outside comes from where it is, but where the cells at rest have moved away nothing
/// is left.
TEST(Inverse, PointsThatStay) {
  const Lattice rest = Box(Point::Zero(), Eigen::Matrix3d::Identity()).lattice({5, 5, 5});
  const Eigen::RowVector3d away(10, 0, 0);
  const Lattice deformed(rest.dims(), rest.points().rowwise() + away);
  const Embedder embedder(rest);
  const Outside keep = Outside::parse("keep");
  Points points(3, 3);
  points << 10.5, 0.25, 0.75, 3, -2, 0.5, 0.5, 0.5, 0.5;
  const Points back = inverse_of(embedder, deformed, keep, points);
  EXPECT_LT((back.row(0) - (points.row(0) - away)).norm(), 1e-12);
  EXPECT_EQ(Point(back.row(1)), Point(points.row(1)));
  EXPECT_TRUE(back.row(2).array().isNaN().all());
  for (const char* how : {"keep", "clamp", "fade:2"}) {
    const Outside outside = Outside::parse(how);
    EXPECT_LT((inverse_of(embedder, deformed, outside, points.topRows(1)) - back.topRows(1)).norm(),
              1e-15)
        << how;
    EXPECT_EQ(inverse_of(embedder, deformed, outside, Points(0, 3)).rows(), 0) << how;
  }
  EXPECT_EQ(inverse_of(embedder, deformed, keep, points.middleRows(1, 1)), points.middleRows(1, 1));
}

}  // namespace
}  // namespace hwffd
