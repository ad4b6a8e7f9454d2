#include "hwffd/registration/bending_form.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <map>
#include <utility>

#include "hwffd/error.hpp"
#include "hwffd/registration/volume.hpp"
#include "lane_sum.hpp"

namespace hwffd {
namespace {

constexpr double kNone = 1e-14;  // of cosines of edges at right angles

/// Six times the coefficients of 1, x, x^2, x^3.
constexpr int kBspline[4][4] = {{1, -3, 3, -1}, {4, 0, -6, 3}, {1, 3, 3, -3}, {0, 0, 0, 1}};

std::array<std::int64_t, 4> derived(std::size_t function, int order) {
  std::array<std::int64_t, 4> result{};
  for (std::size_t power = 0; power < 4; ++power) result[power] = kBspline[function][power];
  for (; order > 0; --order) {
    for (std::size_t power = 0; power < 3; ++power) {
      result[power] = static_cast<std::int64_t>(power + 1) * result[power + 1];
    }
    result[3] = 0;
  }
  return result;
}

/// The integral over a cell of the product of two functions, derived so often.
double integral(std::size_t l, int order_l, std::size_t m, int order_m) {
  constexpr std::int64_t kCommon = 420;  // a multiple of 1 to 7
  const auto a = derived(l, order_l);
  const auto b = derived(m, order_m);
  std::int64_t sum = 0;
  for (std::size_t p = 0; p < 4; ++p) {
    for (std::size_t q = 0; q < 4; ++q) {
      sum += a[p] * b[q] * (kCommon / static_cast<std::int64_t>(p + q + 1));
    }
  }
  return static_cast<double>(sum) / static_cast<double>(36 * kCommon);
}

/// to[outer][row] = sum over d of band[row][d] * from[outer][row + d - 3], rows of `inner` numbers.
void multiply(const std::vector<std::array<double, 7>>& band, std::size_t outer, std::size_t inner,
              const std::vector<double>& from, std::vector<double>& to) {
  const std::size_t n = band.size();
  std::fill(to.begin(), to.end(), 0.0);
  for (std::size_t o = 0; o < outer; ++o) {
    for (std::size_t row = 0; row < n; ++row) {
      double* const result = to.data() + (o * n + row) * inner;
      for (std::size_t d = 0; d < 7; ++d) {
        if (row + d < 3 || row + d - 3 >= n) continue;
        const double factor = band[row][d];
        const double* const numbers = from.data() + (o * n + row + d - 3) * inner;
        for (std::size_t i = 0; i < inner; ++i) result[i] += factor * numbers[i];
      }
    }
  }
}

}  // namespace

Eigen::Matrix3d cell_edges(const Lattice& rest) {
  Eigen::Matrix3d edges;
  edges.col(0) = rest.point(2, 1, 1) - rest.point(1, 1, 1);
  edges.col(1) = rest.point(1, 2, 1) - rest.point(1, 1, 1);
  edges.col(2) = rest.point(1, 1, 2) - rest.point(1, 1, 1);
  return edges;
}

BendingForm::BendingForm(const Index3& dims, const Eigen::Matrix3d& edges) : dims_(dims) {
  Lattice::check_dims(dims);
  AffineMap map;
  for (std::size_t row = 0; row < 3; ++row) {
    for (std::size_t a = 0; a < 3; ++a) {
      map.linear[row][a] = edges(static_cast<int>(row), static_cast<int>(a));
    }
  }
  const double det = map.determinant();
  if (det == 0.0 || !std::isfinite(det)) {
    throw Error("bending energy: the edges of a cell span no volume; give a box that has one");
  }
  const auto inverse = map.inverse().linear;
  double metric[3][3];
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t k = 0; k < 3; ++k) {
      metric[i][k] = inverse[i][0] * inverse[k][0] + inverse[i][1] * inverse[k][1] +
                     inverse[i][2] * inverse[k][2];
    }
  }
  // Of orders of derivation along the axes, left and right.
  std::map<std::pair<std::array<int, 3>, std::array<int, 3>>, double> factors;
  const double cells = static_cast<double>(dims[0] - 3) * (dims[1] - 3) * (dims[2] - 3);
  for (std::size_t at = 0; at < 81; ++at) {
    const std::size_t i = at / 27;
    const std::size_t j = at / 9 % 3;
    const std::size_t k = at / 3 % 3;
    const std::size_t l = at % 3;
    const auto cosine = [&](std::size_t a, std::size_t b) {
      const bool none =
          std::abs(metric[a][b]) <= kNone * std::sqrt(metric[a][a]) * std::sqrt(metric[b][b]);
      return none ? 0.0 : metric[a][b];
    };
    const double factor = cosine(i, k) * cosine(j, l) / cells;
    if (factor == 0.0) continue;
    std::array<int, 3> of_rows{};
    std::array<int, 3> of_columns{};
    ++of_rows[i];
    ++of_rows[j];
    ++of_columns[k];
    ++of_columns[l];
    factors[{of_rows, of_columns}] += factor;
  }
  for (const auto& [orders, factor] : factors) {
    Term term{factor, {}};
    for (std::size_t a = 0; a < 3; ++a) {
      const int gram = 3 * orders.first[a] + orders.second[a];
      term.gram[a] = static_cast<std::size_t>(gram);
    }
    terms_.push_back(term);
  }
  for (std::size_t a = 0; a < 3; ++a) {
    for (std::size_t g = 0; g < 9; ++g) {
      Banded& band = gram_[a][g];
      band.assign(static_cast<std::size_t>(dims[a]), {});
      for (std::size_t cell = 0; cell + 3 < band.size(); ++cell) {
        for (std::size_t l = 0; l < 4; ++l) {
          for (std::size_t m = 0; m < 4; ++m) {
            band[cell + l][3 + m - l] +=
                integral(l, static_cast<int>(g / 3), m, static_cast<int>(g % 3));
          }
        }
      }
    }
  }
}

double BendingForm::operator()(const Points& displacements, double weight, Points* gradient) const {
  const auto n_s = static_cast<std::size_t>(dims_[0]);
  const auto n_t = static_cast<std::size_t>(dims_[1]);
  const auto n_u = static_cast<std::size_t>(dims_[2]);
  if (static_cast<std::size_t>(displacements.rows()) != n_s * n_t * n_u) {
    throw Error("bending energy: another number of displacements than the lattice has points");
  }
  const std::vector<double> u(displacements.data(), displacements.data() + displacements.size());
  std::vector<double> along_s(u.size());
  std::vector<double> along_t(u.size());
  std::vector<double> product(u.size());
  std::vector<double> sum(u.size());
  for (const Term& term : terms_) {
    multiply(gram_[0][term.gram[0]], 1, n_t * n_u * 3, u, along_s);
    multiply(gram_[1][term.gram[1]], n_s, n_u * 3, along_s, along_t);
    multiply(gram_[2][term.gram[2]], n_s * n_t, 3, along_t, product);
    for (std::size_t i = 0; i < u.size(); ++i) sum[i] += term.factor * product[i];
  }
  if (gradient != nullptr) {
    double* const to = gradient->data();
    for (std::size_t i = 0; i < u.size(); ++i) to[i] += 2 * weight * sum[i];
  }
  return lane_sum(u.size(), [&](std::size_t i) { return u[i] * sum[i]; });
}

}  // namespace hwffd
