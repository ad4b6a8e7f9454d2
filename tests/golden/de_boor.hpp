#pragma once

#include <array>
#include <vector>

namespace hwffd {

/// A cubic spline by de Boor's algorithm, straight from its knots and one coordinate of its control
/// points, in extended precision. It shares nothing with the golden library's functions of spans.
class DeBoor {
 public:
  struct Jet {
    long double value;
    long double slope;  ///< of the parameter, not of a cell's x
  };

  DeBoor(std::vector<double> knots, std::vector<double> points)
      : knots_(knots.begin(), knots.end()), points_(points.begin(), points.end()) {}

  /// At parameter t of the knot interval k to k + 1, which is not empty.
  Jet at(std::size_t k, long double t) const {
    std::array<long double, 4> d{};
    for (std::size_t j = 0; j < 4; ++j) d[j] = points_[k - 3 + j];
    std::array<long double, 3> slopes{};  // control points of the derivative, of degree 2
    for (std::size_t j = 0; j < 3; ++j) {
      slopes[j] = 3 * (d[j + 1] - d[j]) / (knots_[k + 1 + j] - knots_[k - 2 + j]);
    }
    return {triangle(d, k, t), triangle(slopes, k, t)};
  }

 private:
  /// The triangle of a spline of degree N - 1.
  template <std::size_t N>
  long double triangle(std::array<long double, N> d, std::size_t k, long double t) const {
    for (std::size_t r = 1; r < N; ++r) {
      for (std::size_t j = N - 1; j >= r; --j) {
        const long double left = knots_[k - (N - 1) + j];
        const long double right = knots_[k + 1 + j - r];
        d[j] = ((right - t) * d[j - 1] + (t - left) * d[j]) / (right - left);
      }
    }
    return d[N - 1];
  }

  std::vector<long double> knots_;
  std::vector<long double> points_;
};

}  // namespace hwffd
