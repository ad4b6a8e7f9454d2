#pragma once

#include <vector>

#include "hwffd/glffd.h"
#include "hwffd/oracle/oracle.hpp"
#include "hwffd/tb/random.hpp"

namespace hwffd::gltest {

/// A random number in [low, high).
double uniform(tb::Random& random, double low, double high);

/// Control points at random, with gaps between them that strides step over.
struct RandomMap {
  Index3 points;
  int components;
  Index3 strides;
  std::vector<GLdouble> values;

  RandomMap(tb::Random& random, const Index3& points, int components);

  /// Component c of point (i, j, k).
  double at(int i, int j, int k, int c) const { return values[place(i, j, k, c)]; }
  /// Adds to component c of all points.
  void raise(int c, double by);
  /// Gives it to glMap3d.
  void define(GLenum target, const std::array<double, 6>& domain) const;
  /// Eq. (1) with these functions, straight from the paper: n - degree cells an axis.
  /// @param position  0 to 1 along each axis
  Eigen::VectorXd expected(const std::array<Oracle::Coefficients, 3>& functions,
                           const std::array<int, 3>& degrees,
                           const Eigen::Vector3d& position) const;

 private:
  std::size_t place(int i, int j, int k, int c) const {
    return static_cast<std::size_t>(i * strides[0] + j * strides[1] + k * strides[2] + c);
  }
};

/// Coefficients as glBlendCoefficientd takes them.
std::vector<GLdouble> rows_of(const Oracle::Coefficients& functions);

/// Bernstein polynomials of a degree from 0 to 3, from their formula.
Oracle::Coefficients bernstein(int degree);

/// Puts the state of the GL commands back to what it is in a new thread, but for the points of
/// maps.
void reset_state();

}  // namespace hwffd::gltest
