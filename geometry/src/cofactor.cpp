#include "cofactor.hpp"

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <cmath>

namespace hwffd {
namespace {

constexpr double kSingular = 1e-9;  // of the volume that the columns could span

}  // namespace

Eigen::Matrix3d known(const Eigen::Matrix3d& gradient) {
  const double largest = gradient.allFinite() ? gradient.cwiseAbs().maxCoeff() : 0.0;
  if (largest == 0.0) return Eigen::Matrix3d::Zero();
  Eigen::Matrix3d scaled = gradient / largest;
  const double volume = scaled.colwise().norm().prod();
  if (!(std::abs(scaled.determinant()) > kSingular * volume)) return Eigen::Matrix3d::Zero();
  return scaled;
}

Eigen::Matrix3d cofactor(const Eigen::Matrix3d& g) {
  Eigen::Matrix3d result;
  for (int c = 0; c < 3; ++c) result.col(c) = g.col((c + 1) % 3).cross(g.col((c + 2) % 3));
  return result;
}

}  // namespace hwffd
