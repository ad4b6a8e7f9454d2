#pragma once

#include <cstddef>
#include <functional>
#include <string>
#include <vector>

namespace hwffd {

/// When minimize() ends.
struct LbfgsOptions {
  int memory = 8;           ///< pairs of differences that the inverse Hessian is made of
  int iterations = 100;     ///< most
  int evaluations = 1000;   ///< most
  double tolerance = 1e-5;  ///< of the value's decrease in `window` iterations, in parts of |f|
  int window = 1;
  double gradient = 0.0;  ///< ends where no component of the gradient is larger
  /// Largest component of the first step; 0: the step is the gradient's, of length 1 at most, as
  /// in L-BFGS-B.
  double first_step = 0.0;
};

/// After an iteration, of which the first is 1.
struct LbfgsState {
  int iteration = 0;
  int evaluations = 0;
  double value = 0.0;
  double gradient = 0.0;  ///< its largest component
  double step = 0.0;      ///< of the line search, in parts of the direction
  const std::vector<double>* x = nullptr;
};

enum class LbfgsEnd {
  kConverged,   ///< the value decreased by less than the tolerance, or the gradient is small
  kIterations,  ///< or evaluations: there are no more
  kLineSearch,  ///< no step along the gradient decreases the value
  kStopped      ///< by the visitor
};

struct LbfgsResult {
  std::vector<double> x;  ///< with the least value of all iterations
  double value = 0.0;
  int iterations = 0;
  int evaluations = 0;
  LbfgsEnd end = LbfgsEnd::kConverged;
};

/// The value at x, and its gradient, which has the size of x. +infinity or NaN: x is out of bounds,
/// and the line search takes a shorter step.
using LbfgsObjective =
    std::function<double(const std::vector<double>& x, std::vector<double>& gradient)>;

/// Minimizes a function of many variables by L-BFGS (Nocedal 1980): directions by the two-loop
/// recursion, steps by the line search of More and Thuente (1994) for the strong Wolfe conditions,
/// with the constants of L-BFGS-B 3.0 (1e-3, 0.9), whose iterates these are but for rounding where
/// there are no bounds. A pair of differences without positive curvature is left out. If no step
/// is found the memory is dropped, once, and the gradient tried.
///
/// Sums have a fixed order, in eight lanes: no bit depends on threads, vector units or a BLAS.
/// @param visit  called after each iteration; false ends
/// @param accepts  whether a step that would end the line search is allowed; if not it is as one
///   out of bounds. None: any is
/// @throws Error where the value at x is not finite
LbfgsResult minimize(const LbfgsObjective& objective, std::vector<double> x,
                     const LbfgsOptions& options = {},
                     const std::function<bool(const LbfgsState&)>& visit = {},
                     const std::function<bool(const std::vector<double>& x)>& accepts = {});

}  // namespace hwffd
