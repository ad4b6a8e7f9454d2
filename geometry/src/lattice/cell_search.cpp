#include "cell_search.hpp"

#include <Eigen/LU>
#include <cmath>
#include <vector>

namespace hwffd {
namespace {

constexpr int kMaxDepth = 40;
constexpr int kMaxSubcells = 4000;

/// A subcell: low corner and width in local coordinates.
struct Subcell {
  BezierVolume hull;  ///< relative to the point
  Eigen::Vector3d low;
  double width;
  int depth;
};

using Coefficients = BezierVolume::Coefficients;

/// Whether all of x lies further than tolerance (one for each column) from 0 on one side.
bool excludes_zero(const Coefficients& x, const Eigen::RowVector3d& tolerance) {
  return (x.colwise().minCoeff().array() > tolerance.array()).any() ||
         (x.colwise().maxCoeff().array() < -tolerance.array()).any();
}

/// Whether a subcell cannot have the point: its coefficients lie on one side of it along x, y or z,
/// or along s, t or u as they run on average through the subcell.
bool excluded(const BezierVolume& hull, double tolerance) {
  const Coefficients& x = hull.coefficients();
  if (excludes_zero(x, Eigen::RowVector3d::Constant(tolerance))) return true;
  Eigen::Matrix3d slopes;
  for (int a = 0; a < 3; ++a) slopes.col(a) = hull.derivative(a).integral().transpose();
  const Eigen::Matrix3d inverse = slopes.inverse();
  if (!inverse.allFinite()) return false;
  const Eigen::RowVector3d reach = tolerance * inverse.rowwise().norm().transpose();
  // Rounding of the products, generously.
  const double noise = 1e-14 * x.cwiseAbs().maxCoeff();
  const Eigen::RowVector3d blur = noise * inverse.rowwise().norm().transpose();
  return excludes_zero(x * inverse.transpose(), reach + blur);
}

}  // namespace

CellSearch search_cell(const Oracle& oracle, const Support& support, const BezierVolume& hull,
                       const Point& point, double done, double tolerance) {
  CellSearch result;
  Coefficients relative = hull.coefficients();
  relative.rowwise() -= point.transpose();
  std::vector<Subcell> subcells{{{hull.degree(), relative}, Eigen::Vector3d::Zero(), 1.0, 0}};
  bool undecided = false;
  for (int visited = 0; !subcells.empty(); ++visited) {
    const Subcell subcell = std::move(subcells.back());
    subcells.pop_back();
    if (excluded(subcell.hull, tolerance)) continue;
    const Eigen::Vector3d middle = subcell.low.array() + subcell.width / 2;
    const Attempt attempt = newton(oracle, support, point, middle, done);
    result.iterations += attempt.iterations;
    if (attempt.residual <= tolerance) {
      result.outcome = CellSearch::Outcome::kFound;
      result.attempt = attempt;
      return result;
    }
    if (subcell.depth == kMaxDepth || visited >= kMaxSubcells) {
      undecided = true;
      if (visited >= kMaxSubcells) break;
      continue;
    }
    const auto octants = subcell.hull.octants();
    for (int o = 0; o < 8; ++o) {
      const Eigen::Vector3d corner(o >> 2 & 1, o >> 1 & 1, o & 1);
      subcells.push_back({octants[static_cast<std::size_t>(o)],
                          subcell.low + corner * subcell.width / 2, subcell.width / 2,
                          subcell.depth + 1});
    }
  }
  if (undecided) result.outcome = CellSearch::Outcome::kUndecided;
  return result;
}

}  // namespace hwffd
