#include "hwffd/lattice/pull_back.hpp"

#include <algorithm>
#include <cmath>
#include <mutex>

#include "hwffd/on_threads.hpp"

namespace hwffd {
namespace {

constexpr std::size_t kRanges = 16;           // at most, each with sums of its own
constexpr std::size_t kLeastOfARange = 1024;  // vertices, so that sums do not take longest
constexpr int kDoubleDigits = 53;             // of a double

/// Adds numbers of at most 2^most, 2^count of them at most, in any order with the same result.
class Cut {
 public:
  Cut(int most, int count) : unit_(most + count + 1 - kDoubleDigits) {
    to_unit_ = std::ldexp(1.5, unit_ + kDoubleDigits - 1);
  }
  /// A number rounded to a multiple of the unit, 2^(most + count + 1 - 53).
  double operator()(double number) const { return (number + to_unit_) - to_unit_; }
  /// What that leaves is at most 2^rest.
  int rest() const { return unit_ - 1; }

 private:
  int unit_;
  double to_unit_;  // from which on a double has no digits below the unit
};

/// The exponent e of the smallest power of two above a number, 2^e.
int exponent_above(double number) {
  int exponent = 0;
  std::frexp(number, &exponent);
  return exponent;
}

/// The same of any weight of an axis, at coordinates of at most that magnitude.
int weight_exponent(const Oracle::Coefficients& functions, double largest) {
  const Eigen::Vector4d powers(1, largest, largest * largest, largest * largest * largest);
  return exponent_above((functions.cwiseAbs() * powers).maxCoeff());
}

}  // namespace

Points pull_back_in(const Index3& dims, const std::vector<Embedded>& vertices,
                    const Points& gradient, const std::array<Oracle::Coefficients, 3>& blending) {
  const Eigen::Index points = static_cast<Eigen::Index>(dims[0]) * dims[1] * dims[2];
  const double largest = vertices.empty() ? 0 : gradient.cwiseAbs().maxCoeff();
  if (largest == 0) return Points::Zero(points, 3);
  // Gradients are made smaller than 1 for the sums.
  const int scale = exponent_above(largest);
  int most = 0;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    double reach = 1;
    for (const Embedded& vertex : vertices) {
      reach = std::max(reach, std::abs(vertex.local[static_cast<Eigen::Index>(axis)]));
    }
    most += weight_exponent(blending[axis], reach);
  }
  const int count = 1 + exponent_above(static_cast<double>(vertices.size()));
  const Cut first_cut(most, count);
  const Cut second_cut(first_cut.rest(), count);

  Points sums = Points::Zero(points, 3);
  Points rests = sums;
  std::mutex joining;
  const std::size_t size = std::max(kLeastOfARange, (vertices.size() + kRanges - 1) / kRanges);
  on_ranges(vertices.size(), size, [&](std::size_t first, std::size_t end) {
    Points own_sums = Points::Zero(points, 3);
    Points own_rests = own_sums;
    for (std::size_t v = first; v < end; ++v) {
      const Embedded& at = vertices[v];
      std::array<Eigen::Vector4d, 3> weight;
      for (std::size_t axis = 0; axis < 3; ++axis) {
        const double x = at.local[static_cast<Eigen::Index>(axis)];
        weight[axis] = blending[axis] * Eigen::Vector4d(1, x, x * x, x * x * x);
      }
      std::array<double, 3> own{};
      for (std::size_t c = 0; c < 3; ++c) {
        own[c] = std::ldexp(gradient(static_cast<Eigen::Index>(v), static_cast<Eigen::Index>(c)),
                            -scale);
      }
      for (int l = 0; l < 4; ++l) {
        for (int m = 0; m < 4; ++m) {
          const double row_weight = weight[0][l] * weight[1][m];
          const Eigen::Index row =
              (static_cast<Eigen::Index>(at.cell[0] + l) * dims[1] + at.cell[1] + m) * dims[2] +
              at.cell[2];
          for (int n = 0; n < 4; ++n) {
            const double whole = row_weight * weight[2][n];
            for (Eigen::Index c = 0; c < 3; ++c) {
              const double term = whole * own[static_cast<std::size_t>(c)];
              const double cut = first_cut(term);
              own_sums(row + n, c) += cut;
              own_rests(row + n, c) += second_cut(term - cut);
            }
          }
        }
      }
    }
    const std::lock_guard<std::mutex> lock(joining);
    sums += own_sums;
    rests += own_rests;
  });
  return (sums + rests).unaryExpr([&](double sum) { return std::ldexp(sum, scale); });
}

}  // namespace hwffd
