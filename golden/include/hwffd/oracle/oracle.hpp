#pragma once

#include <Eigen/Core>
#include <array>
#include <string>

#include "hwffd/points.hpp"

namespace hwffd {

/// Eq. (1) in double precision, straight from the paper. It shares nothing with the bit-true
/// models: their results are compared with it under an error bound, never for equality.
class Oracle {
 public:
  /// Blending coefficients of one axis, 4 x 4: row l is the function B_l, the columns are the
  /// coefficients of 1, s, s^2, s^3.
  using Coefficients = Eigen::Matrix4d;

  enum Axis { kS = 0, kT = 1, kU = 2 };

  /// Uniform cubic B-spline (paper, section 2).
  static Coefficients uniform_bspline();
  /// Bernstein polynomials of degree 3 (Bezier volumes).
  static Coefficients bernstein();
  /// Cubic Hermite, in the order P0, T0, P1, T1.
  static Coefficients hermite();
  /// Catmull-Rom, through the two middle points.
  static Coefficients catmull_rom();
  /// Straight between the two middle points.
  static Coefficients linear();
  /// The first point alone.
  static Coefficients constant();
  /// bspline, bernstein, hermite, catmull-rom, linear or constant. Throws UsageError, which lists
  /// them.
  static Coefficients family(const std::string& name);

  /// Whether functions sum to 1 everywhere, to within the rounding of coefficients in binary32: a
  /// sum of points weighted by them moves with the points.
  static bool sum_to_one(const Coefficients& functions);

  /// Uniform cubic B-spline along all axes.
  Oracle();
  /// The same coefficients along all axes.
  explicit Oracle(const Coefficients& all);
  /// Coefficients for s, t and u.
  Oracle(const Coefficients& s, const Coefficients& t, const Coefficients& u);

  /// B_0(x) .. B_3(x) of an axis.
  Eigen::Vector4d blending(Axis axis, double x) const;

  /// q(s, t, u) of eq. (1).
  /// @param support 64 x 3, row (l*4 + m)*4 + n (Lattice::support)
  Eigen::Vector3d evaluate(const Support& support, double s, double t, double u) const;

  /// A point and its derivatives.
  struct Jet {
    Eigen::Vector3d value;     ///< q(s, t, u)
    Eigen::Matrix3d jacobian;  ///< column a: dq/ds, dq/dt, dq/du
  };

  /// q(s, t, u) and its derivatives, contracted axis by axis; value is evaluate() but for rounding.
  /// @param local s, t, u
  Jet jet(const Support& support, const Eigen::Vector3d& local) const;

  /// The transpose: what a gradient with respect to q adds to that with respect to each of the 64
  /// control points, in the order of a support.
  /// @param local s, t, u
  /// @param derivative  the gradient is that with respect to the derivative along this axis; -1: to
  ///   q
  Support pull_back(const Eigen::Vector3d& gradient, const Eigen::Vector3d& local,
                    int derivative = -1) const;

 private:
  std::array<Coefficients, 3> coefficients_;
};

}  // namespace hwffd
