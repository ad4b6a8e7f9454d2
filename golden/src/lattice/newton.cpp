#include "newton.hpp"

#include <Eigen/Dense>

namespace hwffd {
namespace {

constexpr int kSteps = 40;
constexpr int kHalvings = 6;
constexpr double kMargin = 0.5;  // how far beyond the cell steps may go, in cells

Eigen::Vector3d kept(const Eigen::Vector3d& local, double margin) {
  return local.cwiseMax(-margin).cwiseMin(1.0 + margin);
}

/// A place in the cell, and the eq. (2) there.
struct State {
  State(const Oracle& oracle, const Support& support, const Point& point,
        const Eigen::Vector3d& where)
      : local(where), jet(oracle.jet(support, where)), difference(jet.value - point) {
    residual = difference.norm();
  }
  Eigen::Vector3d local;
  Oracle::Jet jet;
  Eigen::Vector3d difference;
  double residual;
};

}  // namespace

Attempt newton(const Oracle& oracle, const Support& support, const Point& point,
               const Eigen::Vector3d& start, double tolerance) {
  const auto at = [&](const Eigen::Vector3d& local) {
    return State(oracle, support, point, local);
  };
  State now = at(start);
  int iterations = 0;
  while (now.residual > tolerance && iterations < kSteps) {
    ++iterations;
    const Eigen::Vector3d step = now.jet.jacobian.partialPivLu().solve(-now.difference);
    if (!step.allFinite()) break;
    bool better = false;
    double part = 1.0;
    for (int h = 0; h < kHalvings && !better; ++h, part /= 2) {
      const State next = at(kept(now.local + part * step, kMargin));
      better = next.residual < now.residual;
      if (better) now = next;
    }
    if (!better) break;
  }
  const Eigen::Vector3d inside = kept(now.local, 0.0);
  const double residual = inside == now.local ? now.residual : at(inside).residual;
  return {inside, residual, iterations};
}

Attempt nearest(const Oracle& oracle, const Support& support, const Point& point) {
  const auto at = [&](const Eigen::Vector3d& local) {
    return State(oracle, support, point, local);
  };
  State now = at(Eigen::Vector3d::Constant(0.5));
  double damping = 1e-3;
  int iterations = 0;
  for (; iterations < kSteps && damping < 1e9; ++iterations) {
    const Eigen::Vector3d slope = now.jet.jacobian.transpose() * now.difference;
    Eigen::Matrix3d normal = now.jet.jacobian.transpose() * now.jet.jacobian;
    normal.diagonal().array() += damping * (normal.trace() + 1e-300);
    // Coordinates that push against a face stay on it.
    Eigen::Vector3d right = -slope;
    for (int a = 0; a < 3; ++a) {
      const bool held =
          (now.local[a] <= 0.0 && slope[a] > 0.0) || (now.local[a] >= 1.0 && slope[a] < 0.0);
      if (!held) continue;
      normal.row(a).setZero();
      normal.col(a).setZero();
      normal(a, a) = 1.0;
      right[a] = 0.0;
    }
    const State next = at(kept(now.local + normal.ldlt().solve(right), 0.0));
    const bool better = next.residual < now.residual;
    const bool done = better && now.residual - next.residual < 1e-9 * now.residual;
    if (better) now = next;
    damping *= better ? 0.2 : 8.0;
    if (done) break;
  }
  return {now.local, now.residual, iterations};
}

}  // namespace hwffd
