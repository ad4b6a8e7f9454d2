#include "follower_gradient.hpp"

#include <Eigen/LU>
#include <cmath>
#include <limits>
#include <vector>

#include "newton.hpp"

namespace hwffd {
namespace {

constexpr double kHeld = 1e-6;       // cosine of the angle to a face, beyond which it holds
constexpr double kFlatPivot = 1e-9;  // of the largest pivot

/// Local coordinates that stay as they are when the point moves: at a face, with the point beyond.
bool is_held(double local, const Eigen::Vector3d& tangent, const Eigen::Vector3d& arm) {
  const double along = tangent.dot(arm);
  const double least = kHeld * tangent.norm() * arm.norm();
  return (local <= 0.0 && along < -least) || (local >= 1.0 && along > least);
}

}  // namespace

Eigen::Matrix3d follower_gradient(const Following& following, const Outside& outside) {
  const Oracle::Jet at = Oracle().jet(following.rest, following.local);
  const Eigen::Vector3d arm = following.point - at.value;
  std::vector<int> free;
  for (int a = 0; a < 3; ++a) {
    if (!is_held(following.local[a], at.jacobian.col(a), arm)) free.push_back(a);
  }
  // How the place's coordinates follow the point: where it is nearest, J^T (p - x) = 0.
  Eigen::Matrix3d moves = Eigen::Matrix3d::Zero();
  if (!free.empty()) {
    const Eigen::Matrix3d square =
        at.jacobian.transpose() * at.jacobian + curvature(following.rest, following.local, -arm);
    const Eigen::MatrixXd normal = square(free, free);
    Eigen::FullPivLU<Eigen::MatrixXd> decomposition(normal);
    decomposition.setThreshold(kFlatPivot);
    if (!decomposition.isInvertible()) {
      return Eigen::Matrix3d::Constant(std::numeric_limits<double>::quiet_NaN());
    }
    const Eigen::MatrixXd tangents = at.jacobian(Eigen::all, free);
    const Eigen::MatrixXd solved = decomposition.solve(tangents.transpose());
    for (std::size_t i = 0; i < free.size(); ++i) {
      moves.row(free[i]) = solved.row(static_cast<Eigen::Index>(i));
    }
  }
  const double distance = arm.norm();
  Eigen::Matrix3d gradient =
      Eigen::Matrix3d::Identity() +
      outside.weight(distance) * (following.deformed.jacobian - at.jacobian) * moves;
  if (distance > 0.0) {
    gradient += outside.slope(distance) / distance *
                ((following.deformed.value - at.value) * arm.transpose());
  }
  return gradient;
}

}  // namespace hwffd
