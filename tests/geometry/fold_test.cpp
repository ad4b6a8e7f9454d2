#include "hwffd/lattice/fold.hpp"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>

#include "hwffd/lattice/box.hpp"
#include "hwffd/lattice/closure.hpp"
#include "hwffd/lattice/cylinder.hpp"
#include "hwffd/lattice/deformation.hpp"
#include "hwffd/lattice/sphere.hpp"
#include "hwffd/oracle/oracle.hpp"
#include "temp_folder.hpp"

namespace hwffd {
namespace {

using Verdict = FoldCheck::Verdict;

const Eigen::Matrix3d kUnit = Eigen::Matrix3d::Identity();

Lattice box(const Index3& dims) {
  return Box(Point(1, 2, 3), Point(2, 3, 4).asDiagonal()).lattice(dims);
}

Lattice deformed(const Lattice& lattice, const std::string& how) {
  return Deformation::parse(how).apply(lattice);
}

double determinant(const Lattice& lattice, const Index3& cell, const Eigen::Vector3d& local) {
  return Oracle().jet(lattice.support(cell), local).jacobian.determinant();
}

/// The smallest det J on a grid over all cells: an upper bound of the smallest there is.
double least_on_grid(const Lattice& lattice, int steps) {
  double least = 1e300;
  for (const Index3& cell : places(lattice.cells())) {
    for (const auto& [i, j, k] : places({steps + 1, steps + 1, steps + 1})) {
      least = std::min(least, determinant(lattice, cell, Eigen::Vector3d(i, j, k) / steps));
    }
  }
  return least;
}

TEST(Fold, UndeformedLatticesAreProved) {
  const FoldCheck plain = check_folds(box({5, 6, 7}));
  EXPECT_EQ(plain.text(), "proved");
  EXPECT_EQ(plain.depth, 0);
  EXPECT_NEAR(plain.volume, 24.0, 1e-12);
  for (const int n : {6, 9, 16}) {
    EXPECT_EQ(check_folds(Cylinder(Point::Ones(), kUnit, 0.1).lattice({4, 5, n})).text(), "proved");
    EXPECT_EQ(check_folds(Cylinder(Point::Ones(), kUnit).lattice({5, 4, n})).text(),
              "proved but on collapsed faces");
    EXPECT_EQ(check_folds(Sphere(Point::Ones(), kUnit).lattice({5, 5, n})).text(),
              "proved but on collapsed faces");
    EXPECT_EQ(check_folds(Sphere(Point::Ones(), kUnit, 0.5).lattice({4, 8, n})).text(),
              "proved but on collapsed faces");
  }
}

TEST(Fold, VolumesOfShapes) {
  const double pi = std::acos(-1.0);
  EXPECT_NEAR(check_folds(Cylinder(Point::Zero(), kUnit).lattice({4, 4, 16})).volume, pi, 1e-3);
  EXPECT_NEAR(check_folds(Sphere(Point::Zero(), kUnit).lattice({4, 16, 16})).volume, 4 * pi / 3,
              1e-3);
  EXPECT_NEAR(check_folds(Sphere(Point::Zero(), kUnit, 0.5).lattice({4, 16, 16})).volume,
              4 * pi / 3 * 7 / 8, 1e-3);
}

/// Before and after: a shear keeps the volume, a mirrored lattice is as good as any.
TEST(Fold, VolumesOfDeformedLattices) {
  EXPECT_NEAR(check_folds(deformed(box({5, 6, 7}), "shear:0.5")).volume, 24.0, 1e-11);
  const FoldCheck bent = check_folds(deformed(box({5, 6, 7}), "bend:60"));
  EXPECT_EQ(bent.text(), "proved");
  EXPECT_GT(std::abs(bent.volume - 24.0), 1e-3);
  const Lattice mirrored = Box(Point::Zero(), Point(1, 1, -1).asDiagonal()).lattice({4, 4, 5});
  EXPECT_EQ(check_folds(mirrored).text(), "proved");
  EXPECT_NEAR(check_folds(mirrored).volume, -1.0, 1e-13);
}

/// Lattices deformed more and more: what is proved has no fold on a fine grid, and what folds there
/// is not proved; the place reported is one.
TEST(Fold, AgreesWithAGrid) {
  int proved = 0;
  int folded = 0;
  for (std::uint64_t seed = 1; seed <= 40; ++seed) {
    const Lattice plain = box({5, 5, 5});
    const Points moved = deformed(plain, "random:" + std::to_string(seed)).points();
    const double amount = 1.0 + 0.2 * static_cast<double>(seed);
    const Lattice lattice({5, 5, 5}, plain.points() + amount * (moved - plain.points()));
    const FoldCheck check = check_folds(lattice);
    const double least = least_on_grid(lattice, 6);
    if (check.verdict == Verdict::kProved) {
      EXPECT_GT(least, 0.0) << seed;
      ++proved;
    }
    if (check.verdict == Verdict::kFolded) {
      EXPECT_LT(determinant(lattice, check.cell, check.local), 0.0) << seed;
      ++folded;
    }
    if (least < 0.0) {
      EXPECT_EQ(check.verdict, Verdict::kFolded) << seed;
    }
    EXPECT_NE(check.verdict, Verdict::kUndecided) << seed;
  }
  EXPECT_GT(proved, 5);
  EXPECT_GT(folded, 5);
}

TEST(Fold, NamesThePlace) {
  const Lattice plain = box({4, 4, 8});
  Points points = plain.points();
  for (Eigen::Index row = 0; row < points.rows(); ++row) {
    if (row % 8 == 6) points(row, 2) -= 5;  // the layer k = 6 goes back behind k = 4
  }
  const FoldCheck check = check_folds(Lattice({4, 4, 8}, points));
  EXPECT_EQ(check.verdict, Verdict::kFolded);
  EXPECT_GE(check.cell[2], 3);
  EXPECT_EQ(check.text().rfind("folded at (cell 0 0 ", 0), 0u) << check.text();
}

/// A twist by 180 degrees on chords pinches the middle to a line between two cells: no sign is
/// wrong, but nothing is proved.
TEST(Fold, PinchedIsUndecided) {
  const FoldCheck check = check_folds(deformed(box({4, 7, 4}), "twist:180"), 3);
  EXPECT_EQ(check.verdict, Verdict::kUndecided);
  EXPECT_FALSE(check.collapsed);
  EXPECT_EQ(check.text().rfind("undecided at depth 3 (cell 0 ", 0), 0u) << check.text();
}

/// A flat lattice has no volume at all.
TEST(Fold, FlatIsUndecided) {
  Points points = box({4, 4, 4}).points();
  points.col(1).setZero();
  EXPECT_EQ(check_folds(Lattice({4, 4, 4}, points), 2).verdict, Verdict::kUndecided);
}

/// Points of a ball moved one by one tear its centre and poles; closed again it is proved.
TEST(Fold, TornJointsFoldClosedOnesDoNot) {
  const Lattice ball = Sphere(Point::Zero(), kUnit).lattice({7, 9, 12});
  Points points = ball.points();
  for (Eigen::Index row = 0; row < points.rows(); ++row) {
    const Point p = points.row(row);
    points.row(row) += 0.05 * Point(std::sin(3 * p[1]), std::sin(2 * p[2]), p[0] * p[1]);
  }
  const Lattice moved({7, 9, 12}, points);
  const FoldCheck torn = check_folds(moved);
  EXPECT_NE(torn.text(), "proved but on collapsed faces");
  const FoldCheck closed = check_folds(Closure(ball).restore(moved));
  EXPECT_EQ(closed.text(), "proved but on collapsed faces");
  EXPECT_TRUE(closed.collapsed);
}

}  // namespace
}  // namespace hwffd
