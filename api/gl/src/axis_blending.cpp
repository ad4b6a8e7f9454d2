#include "axis_blending.hpp"

#include <limits>

namespace hwffd::gl {

AxisBlending::AxisBlending(int degree, const Oracle::Coefficients& coefficients)
    : degree_(degree), coefficients_(coefficients) {
  const Oracle::Coefficients bspline = Oracle::uniform_bspline();
  const double rounding = std::numeric_limits<float>::epsilon();
  if ((coefficients_ - bspline).cwiseAbs().maxCoeff() <= rounding) coefficients_ = bspline;
}

AxisBlending AxisBlending::bernstein(int degree) {
  Oracle::Coefficients functions = Oracle::Coefficients::Zero();
  // Function l of degree d is (1 - x) times function l of d - 1, plus x times function l - 1.
  functions(0, 0) = 1;
  for (int d = 1; d <= degree; ++d) {
    const Oracle::Coefficients lower = functions;
    Oracle::Coefficients times_x = Oracle::Coefficients::Zero();
    times_x.rightCols<3>() = lower.leftCols<3>();
    functions = lower - times_x;
    functions.bottomRows<3>() += times_x.topRows<3>();
  }
  return AxisBlending(degree, functions);
}

}  // namespace hwffd::gl
