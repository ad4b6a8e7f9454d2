#include "newton.hpp"

#include <Eigen/Dense>
#include <array>

namespace hwffd {
namespace {

constexpr int kSteps = 40;
constexpr int kHalvings = 6;
constexpr double kMargin = 0.5;  // how far beyond the cell steps may go, in cells
constexpr double kFirstDamping = 1e-3;
constexpr double kLastDamping = 1e9;
constexpr double kLeastStep = 1e-8;  // in cells

Eigen::Vector3d clamped(const Eigen::Vector3d& local, double margin) {
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

/// A damped step towards the nearest point; coordinates that push against a face stay on it.
Eigen::Vector3d step_within(const State& now, const Eigen::Matrix3d& curvature, double damping) {
  const Eigen::Vector3d slope = now.jet.jacobian.transpose() * now.difference;
  const Eigen::Matrix3d square = now.jet.jacobian.transpose() * now.jet.jacobian;
  Eigen::Matrix3d normal = square + curvature;
  normal.diagonal().array() += damping * (square.trace() + 1e-300);
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
  return normal.ldlt().solve(right);
}

}  // namespace

Eigen::Matrix<double, 4, 3> uniform_functions(double x) {
  Eigen::Matrix<double, 4, 3> powers;
  powers << 1, 0, 0, x, 1, 0, x * x, 2 * x, 2, x * x * x, 3 * x * x, 6 * x;
  return Oracle::uniform_bspline() * powers;
}

Eigen::Matrix3d curvature(const Support& support, const Eigen::Vector3d& local,
                          const Eigen::Vector3d& difference) {
  std::array<Eigen::Matrix<double, 4, 3>, 3> b;  // of an axis: the functions and two derivatives
  for (int a = 0; a < 3; ++a) b[static_cast<std::size_t>(a)] = uniform_functions(local[a]);
  const Eigen::Matrix<double, 64, 1> along = support * difference;
  const auto derivative = [&](const Index3& order) {
    double sum = 0.0;
    for (int l = 0; l < 4; ++l) {
      for (int m = 0; m < 4; ++m) {
        const double row = along.segment<4>(16 * l + 4 * m).dot(b[2].col(order[2]));
        sum += b[0](l, order[0]) * b[1](m, order[1]) * row;
      }
    }
    return sum;
  };
  const double st = derivative({1, 1, 0});
  const double su = derivative({1, 0, 1});
  const double tu = derivative({0, 1, 1});
  Eigen::Matrix3d result;
  result << derivative({2, 0, 0}), st, su, st, derivative({0, 2, 0}), tu, su, tu,
      derivative({0, 0, 2});
  return result;
}

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
      const State next = at(clamped(now.local + part * step, kMargin));
      better = next.residual < now.residual;
      if (better) now = next;
    }
    if (!better) break;
  }
  const Eigen::Vector3d inside = clamped(now.local, 0.0);
  const double residual = inside == now.local ? now.residual : at(inside).residual;
  return {inside, residual, iterations};
}

Attempt nearest(const Oracle& oracle, const Support& support, const Point& point,
                const Eigen::Vector3d& start) {
  State now(oracle, support, point, start);
  double damping = kFirstDamping;
  int iterations = 0;
  while (iterations < kSteps && damping < kLastDamping) {
    ++iterations;
    const Eigen::Vector3d step =
        step_within(now, curvature(support, now.local, now.difference), damping);
    const Eigen::Vector3d target = clamped(now.local + step, 0.0);
    const double length = (target - now.local).cwiseAbs().maxCoeff();
    const State next(oracle, support, point, target);
    const bool better = next.residual < now.residual;
    if (better) now = next;
    // Shorter steps change the distance by less than its rounding.
    if (length < kLeastStep) break;
    damping *= better ? 0.1 : 8.0;
  }
  return {now.local, now.residual, iterations};
}

}  // namespace hwffd
