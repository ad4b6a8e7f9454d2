#include "hwffd/oracle/oracle.hpp"

#include "hwffd/error.hpp"

namespace hwffd {

Oracle::Coefficients Oracle::uniform_bspline() {
  Coefficients c;
  c << 1, -3, 3, -1,  //
      4, 0, -6, 3,    //
      1, 3, 3, -3,    //
      0, 0, 0, 1;
  return c / 6.0;
}

Oracle::Coefficients Oracle::bernstein() {
  Coefficients c;
  c << 1, -3, 3, -1,  //
      0, 3, -6, 3,    //
      0, 0, 3, -3,    //
      0, 0, 0, 1;
  return c;
}

Oracle::Coefficients Oracle::hermite() {
  // B(0) = P0, B(1) = P1, B'(0) = T0, B'(1) = T1.
  Coefficients c;
  c << 1, 0, -3, 2,  //
      0, 1, -2, 1,   //
      0, 0, 3, -2,   //
      0, 0, -1, 1;
  return c;
}

Oracle::Coefficients Oracle::catmull_rom() {
  // Hermite between P1 and P2 with the tangents (P2 - P0) / 2 and (P3 - P1) / 2.
  const Coefficients h = hermite();
  Coefficients c;
  c.row(0) = -h.row(1) / 2;
  c.row(1) = h.row(0) - h.row(3) / 2;
  c.row(2) = h.row(2) + h.row(1) / 2;
  c.row(3) = h.row(3) / 2;
  return c;
}

Oracle::Coefficients Oracle::linear() {
  Coefficients c = Coefficients::Zero();
  c.row(1) << 1, -1, 0, 0;
  c.row(2) << 0, 1, 0, 0;
  return c;
}

Oracle::Coefficients Oracle::constant() {
  Coefficients c = Coefficients::Zero();
  c(0, 0) = 1;
  return c;
}

Oracle::Coefficients Oracle::family(const std::string& name) {
  if (name == "bspline") return uniform_bspline();
  if (name == "bernstein") return bernstein();
  if (name == "hermite") return hermite();
  if (name == "catmull-rom") return catmull_rom();
  if (name == "linear") return linear();
  if (name == "constant") return constant();
  throw UsageError("unknown blending functions '" + name +
                   "': one of bspline, bernstein, hermite, catmull-rom, linear, constant");
}

bool Oracle::sum_to_one(const Coefficients& functions) {
  const Eigen::RowVector4d sum = functions.colwise().sum();
  return (sum - Eigen::RowVector4d(1, 0, 0, 0)).cwiseAbs().maxCoeff() < 1e-6;
}

Oracle::Oracle() : Oracle(uniform_bspline()) {}

Oracle::Oracle(const Coefficients& all) : Oracle(all, all, all) {}

Oracle::Oracle(const Coefficients& s, const Coefficients& t, const Coefficients& u)
    : coefficients_{s, t, u} {}

Eigen::Vector4d Oracle::blending(Axis axis, double x) const {
  return coefficients_[axis] * Eigen::Vector4d(1.0, x, x * x, x * x * x);
}

Eigen::Vector3d Oracle::evaluate(const Support& support, double s, double t, double u) const {
  const Eigen::Vector4d b_s = blending(kS, s);
  const Eigen::Vector4d b_t = blending(kT, t);
  const Eigen::Vector4d b_u = blending(kU, u);
  Eigen::Vector3d q = Eigen::Vector3d::Zero();
  for (int l = 0; l < 4; ++l) {
    for (int m = 0; m < 4; ++m) {
      for (int n = 0; n < 4; ++n) {
        q += b_s[l] * b_t[m] * b_u[n] * support.row((l * 4 + m) * 4 + n).transpose();
      }
    }
  }
  return q;
}

Oracle::Jet Oracle::jet(const Support& support, const Eigen::Vector3d& local) const {
  std::array<Eigen::Vector4d, 3> b;
  std::array<Eigen::Vector4d, 3> slope;
  for (int a = 0; a < 3; ++a) {
    const double x = local[a];
    b[a] = blending(static_cast<Axis>(a), x);
    slope[a] = coefficients_[a] * Eigen::Vector4d(0.0, 1.0, 2 * x, 3 * x * x);
  }
  // Columns: the value, and the derivatives along s, t, u.
  Eigen::Matrix<double, 3, 4> sum = Eigen::Matrix<double, 3, 4>::Zero();
  for (int l = 0; l < 4; ++l) {
    Eigen::Matrix3d layer = Eigen::Matrix3d::Zero();  // the value, and along t, u
    for (int m = 0; m < 4; ++m) {
      const auto row = support.middleRows<4>((l * 4 + m) * 4).transpose();
      const Eigen::Vector3d at = row * b[kU];
      layer.col(0) += b[kT][m] * at;
      layer.col(1) += slope[kT][m] * at;
      layer.col(2) += b[kT][m] * (row * slope[kU]);
    }
    sum.col(0) += b[kS][l] * layer.col(0);
    sum.col(1) += slope[kS][l] * layer.col(0);
    sum.rightCols<2>() += b[kS][l] * layer.rightCols<2>();
  }
  return {sum.col(0), sum.rightCols<3>()};
}

Support Oracle::pull_back(const Eigen::Vector3d& gradient, const Eigen::Vector3d& local,
                          int derivative) const {
  std::array<Eigen::Vector4d, 3> b;
  for (int a = 0; a < 3; ++a) {
    const double x = local[a];
    b[a] = a == derivative ? coefficients_[a] * Eigen::Vector4d(0.0, 1.0, 2 * x, 3 * x * x)
                           : blending(static_cast<Axis>(a), x);
  }
  Support result;
  for (int p = 0; p < 64; ++p) {
    result.row(p) = b[kS][p / 16] * b[kT][p / 4 % 4] * b[kU][p % 4] * gradient.transpose();
  }
  return result;
}

}  // namespace hwffd
