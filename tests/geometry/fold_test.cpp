// Cells in Bernstein form, and what their coefficients prove.

#include "hwffd/lattice/fold.hpp"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <cmath>
#include <random>
#include <set>

#include "hwffd/lattice/bezier_volume.hpp"
#include "hwffd/lattice/box.hpp"
#include "hwffd/lattice/closure.hpp"
#include "hwffd/lattice/cylinder.hpp"
#include "hwffd/lattice/deformation.hpp"
#include "hwffd/lattice/sphere.hpp"
#include "hwffd/on_threads.hpp"
#include "hwffd/oracle/oracle.hpp"
#include "uniform.hpp"

namespace hwffd {
namespace {

Support random_support(std::uint64_t seed) {
  std::mt19937_64 random(seed);
  Support support;
  for (Eigen::Index i = 0; i < support.size(); ++i) support.data()[i] = 2 * unit(random) - 1;
  return support;
}

double bernstein(int n, int i, double x) {
  double value = std::pow(x, i) * std::pow(1 - x, n - i);
  for (int k = 1; k <= i; ++k) value = value * (n - k + 1) / k;
  return value;
}

/// The volume at a place, by the definition.
Eigen::RowVectorXd at(const BezierVolume& volume, const Eigen::Vector3d& x) {
  const Index3& n = volume.degree();
  Eigen::RowVectorXd sum = Eigen::RowVectorXd::Zero(volume.coefficients().cols());
  for (Eigen::Index row = 0; row < volume.coefficients().rows(); ++row) {
    const Index3 i = volume.place(row);
    sum += volume.coefficients().row(row) * bernstein(n[0], i[0], x[0]) *
           bernstein(n[1], i[1], x[1]) * bernstein(n[2], i[2], x[2]);
  }
  return sum;
}

TEST(BezierVolume, CellAndDeterminantAgainstTheOracle) {
  const Oracle oracle;
  for (std::uint64_t seed = 1; seed <= 5; ++seed) {
    const Support support = random_support(seed);
    const BezierVolume map = BezierVolume::of_cell(support);
    const BezierVolume determinant = jacobian_determinant(map);
    EXPECT_EQ(determinant.degree(), (Index3{8, 8, 8}));
    for (const Eigen::Vector3d& x :
         {Eigen::Vector3d(0, 0, 0), Eigen::Vector3d(1, 1, 0), Eigen::Vector3d(0.2, 0.9, 0.4)}) {
      const Oracle::Jet jet = oracle.jet(support, x);
      EXPECT_LT((at(map, x).transpose() - jet.value).norm(), 1e-14);
      EXPECT_NEAR(at(determinant, x)[0], jet.jacobian.determinant(), 1e-13);
    }
  }
}

TEST(BezierVolume, PartsAreTheWholeSeenCloser) {
  const BezierVolume map = BezierVolume::of_cell(random_support(7));
  const Eigen::Vector3d x(0.3, 0.8, 0.1);
  const auto octants = map.octants();
  for (int o = 0; o < 8; ++o) {
    const Eigen::Vector3d corner(o >> 2 & 1, o >> 1 & 1, o & 1);
    const Eigen::Vector3d whole = (corner + x) / 2;
    EXPECT_LT((at(octants[static_cast<std::size_t>(o)], x) - at(map, whole)).norm(), 1e-14);
  }
}

TEST(BezierVolume, IntegralIsTheMeanOfItsValues) {
  const BezierVolume determinant = jacobian_determinant(BezierVolume::of_cell(random_support(8)));
  // Gauss-Legendre of 5 points is exact to degree 9.
  const std::array<double, 5> nodes{-0.906179845938664, -0.5384693101056831, 0.0,
                                    0.5384693101056831, 0.906179845938664};
  const std::array<double, 5> weights{0.2369268850561891, 0.4786286704993665, 0.5688888888888889,
                                      0.4786286704993665, 0.2369268850561891};
  double sum = 0.0;
  for (std::size_t i = 0; i < 125; ++i) {
    const std::size_t a = i / 25;
    const std::size_t b = i / 5 % 5;
    const std::size_t c = i % 5;
    const Eigen::Vector3d x((1 + nodes[a]) / 2, (1 + nodes[b]) / 2, (1 + nodes[c]) / 2);
    sum += weights[a] * weights[b] * weights[c] / 8 * at(determinant, x)[0];
  }
  EXPECT_NEAR(determinant.integral()[0], sum, 1e-13);
}

/// (2 - s + t u) times s^2, (1 - t) or u, and the factor out again.
TEST(BezierVolume, FactorsDivideOut) {
  BezierVolume::Coefficients c(8, 1);
  for (int i = 0; i < 8; ++i) c(i, 0) = 2.0 - (i >> 2 & 1) + ((i & 3) == 3 ? 1 : 0);
  const BezierVolume plain({1, 1, 1}, c);
  const auto times = [&](const Index3& degree, const std::vector<double>& factor) {
    const Eigen::Map<const Eigen::VectorXd> column(factor.data(),
                                                   static_cast<Eigen::Index>(factor.size()));
    return product(plain, BezierVolume(degree, column));
  };
  const auto same = [&](const BezierVolume& other) {
    return other.degree() == plain.degree() &&
           (other.coefficients() - plain.coefficients()).norm() < 1e-15;
  };
  EXPECT_PRED1(same, times({2, 0, 0}, {0, 0, 1}).without_factor(0, 0, 2));
  EXPECT_PRED1(same, times({0, 1, 0}, {1, 0}).without_factor(1, 1, 1));
  EXPECT_PRED1(same, times({0, 0, 1}, {0, 1}).without_factor(2, 0, 1));
}

TEST(OracleJet, AgainstEvaluateAndDifferences) {
  const Oracle oracle(Oracle::uniform_bspline(), Oracle::bernstein(), Oracle::catmull_rom());
  const Support support = random_support(9);
  const Eigen::Vector3d x(0.15, 0.6, 0.95);
  const Oracle::Jet jet = oracle.jet(support, x);
  const auto value = [&](const Eigen::Vector3d& p) {
    return oracle.evaluate(support, p[0], p[1], p[2]);
  };
  EXPECT_LT((jet.value - value(x)).norm(), 1e-15);
  for (int a = 0; a < 3; ++a) {
    const Eigen::Vector3d step = 1e-5 * Eigen::Vector3d::Unit(a);
    const Eigen::Vector3d slope = (value(x + step) - value(x - step)) / 2e-5;
    EXPECT_LT((jet.jacobian.col(a) - slope).norm(), 1e-9);
  }
}

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

/// Proved at once and after many halvings, folded, undecided for their depth and for their number:
/// the answer is the same to the last bit on any number of threads.
TEST(Fold, AnswersAreTheSameFarFromTheOrigin) {
  const auto lattices = [](double far) {
    const Point origin(far, 1, -far);
    return std::vector<Lattice>{Cylinder(origin, kUnit).lattice({4, 5, 9}),
                                Sphere(origin, kUnit).lattice({5, 6, 9}),
                                Box(origin, kUnit).lattice({4, 5, 6})};
  };
  const std::vector<Lattice> near = lattices(0);
  std::set<Verdict> verdicts;
  for (const double far : {1e4, 1e6, 1e9}) {
    const std::vector<Lattice> there = lattices(far);
    for (std::size_t n = 0; n < near.size(); ++n) {
      for (const std::string how : {"none", "twist:30", "bend:60", "random:3", "scale:-1,1,2"}) {
        const FoldCheck wanted = check_folds(deformed(deformed(near[n], how), "taper:0.8"));
        const FoldCheck got = check_folds(deformed(deformed(there[n], how), "taper:0.8"));
        EXPECT_EQ(got.text(), wanted.text()) << n << " " << how << " " << far;
        EXPECT_NEAR(got.volume, wanted.volume, 1e-12 * far + 1e-9) << n << " " << how << " " << far;
        verdicts.insert(wanted.verdict);
      }
    }
  }
  EXPECT_EQ(verdicts, (std::set<Verdict>{Verdict::kProved, Verdict::kFolded}));
}

TEST(Fold, AnswersDoNotDependOnTheNumberOfThreads) {
  const Lattice ball = Sphere(Point::Zero(), kUnit).lattice({7, 9, 12});
  Points flat = box({14, 14, 14}).points();
  flat.col(1).setZero();
  const std::vector<Lattice> lattices{box({9, 8, 7}),
                                      deformed(box({7, 8, 9}), "random:1"),
                                      deformed(box({7, 8, 9}), "bend:300"),
                                      deformed(box({4, 7, 4}), "twist:180"),
                                      deformed(ball, "random:3"),
                                      deformed(ball, "taper:0.5"),
                                      Lattice({14, 14, 14}, flat)};
  std::set<Verdict> seen;
  for (std::size_t i = 0; i < lattices.size(); ++i) {
    set_thread_count(1);
    const FoldCheck serial = check_folds(lattices[i]);
    seen.insert(serial.verdict);
    for (const std::size_t threads : {2, 5}) {
      set_thread_count(threads);
      const FoldCheck parallel = check_folds(lattices[i]);
      EXPECT_EQ(parallel.text(), serial.text()) << i;
      EXPECT_EQ(parallel.depth, serial.depth) << i;
      EXPECT_EQ(parallel.volume, serial.volume) << i;
      EXPECT_EQ(parallel.local, serial.local) << i;
    }
  }
  set_thread_count(0);
  EXPECT_EQ(seen.size(), 3u);
}

}  // namespace
}  // namespace hwffd
