#include "hwffd/lattice/bezier_volume.hpp"

#include <array>
#include <vector>

#include "hwffd/lattice/conversion.hpp"
#include "hwffd/oracle/oracle.hpp"

namespace hwffd {
namespace {

using Coefficients = BezierVolume::Coefficients;

double binomial(int n, int k) {
  double value = 1.0;
  for (int i = 1; i <= k; ++i) value = value * (n - k + i) / i;
  return value;
}

Eigen::Index count(const Index3& degree) {
  return static_cast<Eigen::Index>(degree[0] + 1) * (degree[1] + 1) * (degree[2] + 1);
}

/// Products of the binomials of coefficients: one times its product is the coefficient of
/// s^i (1-s)^(n-i) and so on, in which a product of polynomials is a convolution.
class Scales {
 public:
  explicit Scales(const Index3& degree) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      for (int i = 0; i <= degree[axis]; ++i) of_axis_[axis].push_back(binomial(degree[axis], i));
    }
  }

  double at(const Index3& place) const {
    return along(0, place) * along(1, place) * along(2, place);
  }

 private:
  double along(std::size_t axis, const Index3& place) const {
    return of_axis_[axis][static_cast<std::size_t>(place[axis])];
  }

  std::array<std::vector<double>, 3> of_axis_;
};

Coefficients scaled(const BezierVolume& volume) {
  const Scales scales(volume.degree());
  Coefficients result = volume.coefficients();
  for (Eigen::Index row = 0; row < result.rows(); ++row) {
    result.row(row) *= scales.at(volume.place(row));
  }
  return result;
}

Index3 sum(const Index3& a, const Index3& b) { return {a[0] + b[0], a[1] + b[1], a[2] + b[2]}; }

}  // namespace

BezierVolume::BezierVolume(const Index3& degree, Coefficients coefficients)
    : degree_(degree), coefficients_(std::move(coefficients)) {}

BezierVolume BezierVolume::of_cell(const Support& support) {
  static const Eigen::Matrix4d axis = conversion(Oracle::uniform_bspline(), Oracle::bernstein());
  return BezierVolume({3, 3, 3}, convert(support, {axis, axis, axis}));
}

Index3 BezierVolume::place(Eigen::Index row) const {
  const int k = static_cast<int>(row);
  const int n_t = degree_[1] + 1;
  const int n_u = degree_[2] + 1;
  return {k / (n_t * n_u), k / n_u % n_t, k % n_u};
}

Eigen::Index BezierVolume::step(int axis) const {
  Index3 next{0, 0, 0};
  next[static_cast<std::size_t>(axis)] = 1;
  return index(next);
}

BezierVolume BezierVolume::derivative(int axis) const {
  const auto a = static_cast<std::size_t>(axis);
  Index3 degree = degree_;
  --degree[a];
  BezierVolume result(degree, Coefficients(count(degree), coefficients_.cols()));
  for (Eigen::Index row = 0; row < result.coefficients_.rows(); ++row) {
    const Eigen::Index from = index(result.place(row));
    result.coefficients_.row(row) =
        degree_[a] * (coefficients_.row(from + step(axis)) - coefficients_.row(from));
  }
  return result;
}

BezierVolume BezierVolume::face(int axis, int end) const {
  const auto a = static_cast<std::size_t>(axis);
  Index3 degree = degree_;
  degree[a] = 0;
  BezierVolume result(degree, Coefficients(count(degree), coefficients_.cols()));
  for (Eigen::Index row = 0; row < result.coefficients_.rows(); ++row) {
    Index3 at = result.place(row);
    at[a] = end * degree_[a];
    result.coefficients_.row(row) = coefficients_.row(index(at));
  }
  return result;
}

std::array<BezierVolume, 2> BezierVolume::halves(int axis) const {
  const auto a = static_cast<std::size_t>(axis);
  const int n = degree_[a];
  const Eigen::Index next = step(axis);
  BezierVolume low = *this;
  BezierVolume high = *this;
  Coefficients& c = low.coefficients_;
  for (Eigen::Index first = 0; first < c.rows(); ++first) {
    if (place(first)[a] != 0) continue;
    // De Casteljau: in place, level by level, the low half remains; the last of each level is the
    // high half.
    for (int level = 1; level <= n; ++level) {
      for (int i = n; i >= level; --i) {
        c.row(first + i * next) = (c.row(first + i * next) + c.row(first + (i - 1) * next)) / 2;
      }
      high.coefficients_.row(first + (n - level) * next) = c.row(first + n * next);
    }
  }
  return {std::move(low), std::move(high)};
}

std::array<BezierVolume, 8> BezierVolume::octants() const {
  const std::array<BezierVolume, 2> s = halves(0);
  const std::array<BezierVolume, 2> low = s[0].halves(1);
  const std::array<BezierVolume, 2> high = s[1].halves(1);
  auto a = low[0].halves(2);
  auto b = low[1].halves(2);
  auto c = high[0].halves(2);
  auto d = high[1].halves(2);
  return {std::move(a[0]), std::move(a[1]), std::move(b[0]), std::move(b[1]),
          std::move(c[0]), std::move(c[1]), std::move(d[0]), std::move(d[1])};
}

BezierVolume BezierVolume::without_factor(int axis, int end, int power) const {
  const auto a = static_cast<std::size_t>(axis);
  Index3 degree = degree_;
  degree[a] -= power;
  BezierVolume result(degree, Coefficients(count(degree), coefficients_.cols()));
  for (Eigen::Index row = 0; row < result.coefficients_.rows(); ++row) {
    Index3 at = result.place(row);
    const double below = binomial(degree[a], at[a]);
    if (end == 0) at[a] += power;
    result.coefficients_.row(row) =
        coefficients_.row(index(at)) * (binomial(degree_[a], at[a]) / below);
  }
  return result;
}

BezierVolume product(const BezierVolume& a, const BezierVolume& b) {
  const Index3 degree = sum(a.degree(), b.degree());
  BezierVolume result(degree, Coefficients::Zero(count(degree), 1));
  const Coefficients x = scaled(a);
  const Coefficients y = scaled(b);
  Coefficients c = Coefficients::Zero(count(degree), 1);
  // A row of coefficients of b along u meets consecutive rows of the product: from where on, for
  // the first coefficient of a.
  const Eigen::Index run = b.degree()[2] + 1;
  std::vector<Eigen::Index> starts;
  for (Eigen::Index j = 0; j < y.rows(); j += run) starts.push_back(result.index(b.place(j)));
  for (Eigen::Index i = 0; i < x.rows(); ++i) {
    const double factor = x(i, 0);
    const double* from = y.data();
    double* const first = c.data() + result.index(a.place(i));
    for (const Eigen::Index start : starts) {
      double* const to = first + start;
      for (Eigen::Index k = 0; k < run; ++k) to[k] += factor * from[k];
      from += run;
    }
  }
  const Scales scales(degree);
  for (Eigen::Index row = 0; row < c.rows(); ++row) c(row, 0) /= scales.at(result.place(row));
  return BezierVolume(degree, std::move(c));
}

BezierVolume jacobian_determinant(const BezierVolume& map) {
  const BezierVolume s = map.derivative(0);
  const BezierVolume t = map.derivative(1);
  const BezierVolume u = map.derivative(2);
  const Index3 degree = sum(sum(s.degree(), t.degree()), u.degree());
  Coefficients total = Coefficients::Zero(count(degree), 1);
  for (int x = 0; x < 3; ++x) {
    const int y = (x + 1) % 3;
    const int z = (x + 2) % 3;
    const BezierVolume plus = product(t.component(y), u.component(z));
    const BezierVolume minus = product(t.component(z), u.component(y));
    const BezierVolume cross(plus.degree(), plus.coefficients() - minus.coefficients());
    total += product(s.component(x), cross).coefficients();
  }
  return BezierVolume(degree, std::move(total));
}

}  // namespace hwffd
