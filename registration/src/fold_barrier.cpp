#include "hwffd/registration/fold_barrier.hpp"

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <cstddef>
#include <vector>

#include "axis_weights.hpp"
#include "hwffd/error.hpp"
#include "hwffd/lattice/fold.hpp"
#include "hwffd/on_threads.hpp"
#include "hwffd/registration/volume.hpp"

namespace hwffd {
namespace {

constexpr int kHalvings = 18;             // of a cell, six along each axis, as check_folds() has
constexpr std::size_t kCellsAtOnce = 64;  // that a thread takes at once

/// A place along an axis, 0 or 1/2 in its cell, or 1 in the last.
struct Place {
  std::size_t first;  ///< of its control points
  std::array<double, 4> value, slope;
};

std::vector<Place> places_along(int points) {
  constexpr std::array<double, 4> kAt0{1 / 6.0, 4 / 6.0, 1 / 6.0, 0};
  constexpr std::array<double, 4> kSlopeAt0{-0.5, 0, 0.5, 0};
  constexpr std::array<double, 4> kAtHalf{1 / 48.0, 23 / 48.0, 23 / 48.0, 1 / 48.0};
  constexpr std::array<double, 4> kSlopeAtHalf{-0.125, -0.625, 0.625, 0.125};
  constexpr std::array<double, 4> kAt1{0, 1 / 6.0, 4 / 6.0, 1 / 6.0};
  constexpr std::array<double, 4> kSlopeAt1{0, -0.5, 0, 0.5};
  std::vector<Place> result;
  const auto cells = static_cast<std::size_t>(points - 3);
  for (std::size_t cell = 0; cell < cells; ++cell) {
    result.push_back({cell, kAt0, kSlopeAt0});
    result.push_back({cell, kAtHalf, kSlopeAtHalf});
  }
  result.push_back({cells - 1, kAt1, kSlopeAt1});
  return result;
}

/// Rows of `inner` numbers: result = sum over l of w[l]*from[first + l].
void contract(const std::array<double, 4>& w, const double* from, std::size_t inner,
              double* result) {
  for (std::size_t i = 0; i < inner; ++i) {
    result[i] = w[0] * from[i] + w[1] * from[i + inner] + w[2] * from[i + 2 * inner] +
                w[3] * from[i + 3 * inner];
  }
}

/// Its transpose, which adds.
void expand(const std::array<double, 4>& w, const double* from, std::size_t inner, double* result) {
  for (std::size_t l = 0; l < 4; ++l) {
    for (std::size_t i = 0; i < inner; ++i) result[l * inner + i] += w[l] * from[i];
  }
}

/// Columns of a matrix: x, y, z of the derivatives along s, t and u.
using Columns = std::array<std::array<double, 3>, 3>;

std::array<double, 3> cross(const std::array<double, 3>& a, const std::array<double, 3>& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

double dot(const std::array<double, 3>& a, const std::array<double, 3>& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

struct Barrier {
  double value, slope;
};

Barrier barrier(double d) {
  constexpr double kT = FoldBarrier::kThreshold;
  if (d >= kT) return {0.0, 0.0};
  const double below = kT - d;
  const double value = below * below * below / (kT * kT * d);
  return {value, -value * (3 / below + 1 / d)};
}

/// Walks over all places, s first, so that rows of u are the innermost: what an axis contracts is
/// there once for all places beyond it.
class Walk {
 public:
  Walk(const Index3& dims, double mean)
      : s_(places_along(dims[0])),
        t_(places_along(dims[1])),
        u_(places_along(dims[2])),
        row_(3 * static_cast<std::size_t>(dims[2])),
        slice_(row_ * static_cast<std::size_t>(dims[1])),
        mean_(mean) {}

  FoldBarrier::Result run(const Points& points, double weight, Points* gradient) const {
    FoldBarrier::Result result;
    const double count = static_cast<double>(s_.size() * t_.size() * u_.size());
    std::vector<double> value(slice_);  // of a place along s
    std::vector<double> slope(slice_);
    std::vector<double> value_back(slice_);
    std::vector<double> slope_back(slice_);
    std::vector<double> row(3 * row_);  // of one along t: dq/ds, dq/dt, q
    std::vector<double> row_back(3 * row_);
    std::vector<double> back(gradient != nullptr ? static_cast<std::size_t>(points.size()) : 0);
    for (const Place& s : s_) {
      const double* const from = points.data() + s.first * slice_;
      contract(s.value, from, slice_, value.data());
      contract(s.slope, from, slice_, slope.data());
      std::fill(value_back.begin(), value_back.end(), 0.0);
      std::fill(slope_back.begin(), slope_back.end(), 0.0);
      for (const Place& t : t_) {
        const std::size_t first = t.first * row_;
        contract(t.value, slope.data() + first, row_, row.data());
        contract(t.slope, value.data() + first, row_, row.data() + row_);
        contract(t.value, value.data() + first, row_, row.data() + 2 * row_);
        std::fill(row_back.begin(), row_back.end(), 0.0);
        for (const Place& u : u_) {
          at(u, row, weight / (count * mean_), gradient != nullptr ? &row_back : nullptr, result);
        }
        if (gradient == nullptr) continue;
        expand(t.value, row_back.data(), row_, slope_back.data() + first);
        expand(t.slope, row_back.data() + row_, row_, value_back.data() + first);
        expand(t.value, row_back.data() + 2 * row_, row_, value_back.data() + first);
      }
      if (gradient == nullptr) continue;
      expand(s.value, value_back.data(), slice_, back.data() + s.first * slice_);
      expand(s.slope, slope_back.data(), slice_, back.data() + s.first * slice_);
    }
    result.penalty =
        result.least > 0.0 ? result.penalty / count : std::numeric_limits<double>::infinity();
    if (gradient != nullptr && result.least > 0.0) {
      for (std::size_t i = 0; i < back.size(); ++i) gradient->data()[i] += back[i];
    }
    return result;
  }

 private:
  void at(const Place& u, const std::vector<double>& row, double factor,
          std::vector<double>* row_back, FoldBarrier::Result& result) const {
    const std::size_t first = 3 * u.first;
    Columns j;
    contract(u.value, row.data() + first, 3, j[0].data());
    contract(u.value, row.data() + row_ + first, 3, j[1].data());
    contract(u.slope, row.data() + 2 * row_ + first, 3, j[2].data());
    const Columns cofactors{cross(j[1], j[2]), cross(j[2], j[0]), cross(j[0], j[1])};
    const double d = dot(j[0], cofactors[0]) / mean_;
    // A NaN is a fold, too.
    if (!(d >= result.least))
      result.least = d < result.least ? d : -std::numeric_limits<double>::infinity();
    result.most = std::max(result.most, d);
    if (!(d > 0.0)) return;
    const Barrier b = barrier(d);
    result.penalty += b.value;
    if (row_back == nullptr || b.slope == 0.0) return;
    Columns back = cofactors;
    for (auto& column : back) {
      for (double& x : column) x *= factor * b.slope;
    }
    expand(u.value, back[0].data(), 3, row_back->data() + first);
    expand(u.value, back[1].data(), 3, row_back->data() + row_ + first);
    expand(u.slope, back[2].data(), 3, row_back->data() + 2 * row_ + first);
  }

  std::vector<Place> s_, t_, u_;
  std::size_t row_, slice_;  ///< numbers of a row of points along u, of a slice of t and u
  double mean_;
};

/// The mean of the differences of neighbouring points along each axis.
AffineMap mean_edges(const Lattice& lattice) {
  AffineMap result;
  const Index3& dims = lattice.dims();
  for (std::size_t a = 0; a < 3; ++a) {
    std::array<double, 3> sum{};
    Index3 last = dims;
    last[a] = 1;
    for (const Index3& at : places(last)) {
      Index3 end = at;
      end[a] = dims[a] - 1;
      for (std::size_t c = 0; c < 3; ++c) {
        const auto column = static_cast<int>(c);
        sum[c] += lattice.points()(lattice.index(end), column) -
                  lattice.points()(lattice.index(at), column);
      }
    }
    const double count = static_cast<double>(last[0]) * last[1] * last[2] * (dims[a] - 1);
    for (std::size_t c = 0; c < 3; ++c) result.linear[c][a] = sum[c] / count;
  }
  return result;
}

/// The 64 control points of a cell, each component by itself, n along u fastest.
struct CellPoints {
  double at[3][64];

  explicit CellPoints(const Support& support) {
    for (int row = 0; row < 64; ++row) {
      for (int c = 0; c < 3; ++c) at[c][row] = support(row, c);
    }
  }

  /// Those of one of its halves along an axis: knot insertion.
  CellPoints half(int axis, int upper) const {
    CellPoints result;
    const int stride = kStrides[axis];
    for (int c = 0; c < 3; ++c) {
      for (int l = 0; l < 4; ++l) {
        const double* const p = at[c] + (l + upper) / 2 * stride;
        double* const to = result.at[c] + l * stride;
        const bool between = (l + upper) % 2 == 0;
        for (int outer = 0; outer < 64; outer += 4 * stride) {
          for (int i = outer; i < outer + stride; ++i) {
            to[i] = between ? (p[i] + p[i + stride]) / 2
                            : (p[i] + 6 * p[i + stride] + p[i + 2 * stride]) / 8;
          }
        }
      }
    }
    return result;
  }

  /// The mean of the differences of neighbours along an axis.
  double mean_edge(int component, int axis) const {
    const int stride = kStrides[axis];
    double sum = 0.0;
    for (int outer = 0; outer < 64; outer += 4 * stride) {
      for (int i = outer; i < outer + stride; ++i) {
        sum += at[component][i + 3 * stride] - at[component][i];
      }
    }
    return sum / 48;
  }

  static constexpr int kStrides[3] = {16, 4, 1};

 private:
  CellPoints() = default;
};

/// The most that differences of neighbours along an axis are off a number.
double most_off(const double* points, int stride, double wanted) {
  double most = 0.0;
  for (int outer = 0; outer < 64; outer += 4 * stride) {
    for (int i = outer; i < outer + 3 * stride; ++i) {
      most = std::max(most, std::abs(points[i + stride] - points[i] - wanted));
    }
  }
  return most;
}

/// The sign of det J in a cell whose control points are regular enough to be sure of it, or 0. A
/// derivative along an axis is a mean, with weights above 0, of differences of neighbours along it.
/// In parts of the means of these it is near a unit vector, and det J of such columns is positive
/// where in each row of J the diagonal outweighs the rest.
double sign_of_regular(const CellPoints& points) {
  constexpr double kEnough = 0.999;  // for rounding
  AffineMap mean;
  for (int c = 0; c < 3; ++c) {
    for (int a = 0; a < 3; ++a) {
      mean.linear[static_cast<std::size_t>(c)][static_cast<std::size_t>(a)] =
          points.mean_edge(c, a);
    }
  }
  const double det = mean.determinant();
  if (det == 0.0 || !std::isfinite(det) || !std::isfinite(1 / det)) return 0.0;
  const auto to_unit = mean.inverse().linear;
  for (int b = 0; b < 3; ++b) {
    const auto& row = to_unit[static_cast<std::size_t>(b)];
    double along[64];
    for (int i = 0; i < 64; ++i) {
      along[i] = row[0] * (points.at[0][i] - points.at[0][0]) +
                 row[1] * (points.at[1][i] - points.at[1][0]) +
                 row[2] * (points.at[2][i] - points.at[2][0]);
    }
    double off = 0.0;
    for (int a = 0; a < 3; ++a) off += most_off(along, CellPoints::kStrides[a], a == b ? 1 : 0);
    if (!(off < kEnough)) return 0.0;
  }
  return det;
}

/// Whether det J is proved to have a sign over a cell, which is halved along one axis after the
/// other where it is not regular enough, so often at most.
bool has_sign(const CellPoints& points, bool positive, int halvings) {
  const double sign = sign_of_regular(points);
  if (sign != 0.0) return (sign > 0.0) == positive;
  if (halvings == 0) return false;
  const int axis = halvings % 3;
  return has_sign(points.half(axis, 0), positive, halvings - 1) &&
         has_sign(points.half(axis, 1), positive, halvings - 1);
}

bool all_have_sign(const Lattice& lattice, bool positive) {
  const std::vector<Index3> all = places(lattice.cells());
  std::atomic<bool> proved{true};
  on_ranges(all.size(), kCellsAtOnce, [&](std::size_t first, std::size_t end) {
    for (std::size_t c = first; c < end && proved; ++c) {
      if (!has_sign(CellPoints(lattice.support(all[c])), positive, kHalvings)) proved = false;
    }
  });
  return proved;
}

double proved_mean(const Lattice& start) {
  const double mean = mean_edges(start).determinant();
  if (mean != 0.0 && all_have_sign(start, mean > 0.0)) return mean;
  const FoldCheck check = check_folds(start);
  throw Error(
      "start without folds: the lattice is " +
      (check.verdict == FoldCheck::Verdict::kProved ? "too close to a fold" : check.text()) +
      "; give a start that folds nowhere, or allow folds");
}

/// Functions and slopes of a B-spline at a place in its cell.
struct Weights {
  std::array<double, 4> value, slope;
};

Weights weights_at(double x) {
  const double y = 1 - x;
  return {AxisWeights::bspline(x),
          {-y * y / 2, x * (1.5 * x - 2), 0.5 + x * (1 - 1.5 * x), x * x / 2}};
}

/// The integral of q . (dq/db x dq/dc) over a face of all cells, where the coordinate along an axis
/// ends, b and c are the next two axes, and q is measured from `origin`.
double flux(const Lattice& lattice, std::size_t axis, bool upper, const Point& origin) {
  // Of Gauss, exact up to degree 9; each factor has degree 3 or less.
  constexpr std::array<double, 5> kPlaces{-0.9061798459386640, -0.5384693101056831, 0,
                                          0.5384693101056831, 0.9061798459386640};
  constexpr std::array<double, 5> kGauss{0.2369268850561891, 0.4786286704993665, 128.0 / 225,
                                         0.4786286704993665, 0.2369268850561891};
  std::array<Weights, 5> weights;
  for (std::size_t g = 0; g < 5; ++g) weights[g] = weights_at((1 + kPlaces[g]) / 2);
  const std::size_t b = (axis + 1) % 3;
  const std::size_t c = (axis + 2) % 3;
  const Index3& dims = lattice.dims();
  const auto on_face = [&](int at_b, int at_c) {
    Index3 at{};
    at[b] = at_b;
    at[c] = at_c;
    Point sum = Point::Zero();
    for (int l = 0; l < 3; ++l) {
      at[axis] = (upper ? dims[axis] - 3 : 0) + l;
      sum += (l == 1 ? 4 : 1) * (lattice.point(at) - origin);
    }
    const Point mean = sum / 6;
    return std::array<double, 3>{mean[0], mean[1], mean[2]};
  };
  double result = 0.0;
  std::array<std::array<double, 3>, 16> net;
  const auto sum_of = [&](const std::array<double, 4>& along_b,
                          const std::array<double, 4>& along_c) {
    std::array<double, 3> sum{};
    for (std::size_t p = 0; p < 16; ++p) {
      for (std::size_t x = 0; x < 3; ++x) sum[x] += along_b[p / 4] * along_c[p % 4] * net[p][x];
    }
    return sum;
  };
  for (int cell_b = 0; cell_b < dims[b] - 3; ++cell_b) {
    for (int cell_c = 0; cell_c < dims[c] - 3; ++cell_c) {
      for (int p = 0; p < 16; ++p) {
        net[static_cast<std::size_t>(p)] = on_face(cell_b + p / 4, cell_c + p % 4);
      }
      for (std::size_t g = 0; g < 5; ++g) {
        for (std::size_t h = 0; h < 5; ++h) {
          const auto q = sum_of(weights[g].value, weights[h].value);
          const auto q_b = sum_of(weights[g].slope, weights[h].value);
          const auto q_c = sum_of(weights[g].value, weights[h].slope);
          result += kGauss[g] * kGauss[h] / 4 * dot(q, cross(q_b, q_c));
        }
      }
    }
  }
  return result;
}

/// The integral of det J over all cells: by the theorem of Gauss a third of the flux out of them.
double volume_of(const Lattice& lattice) {
  const Index3 middle{lattice.dims()[0] / 2, lattice.dims()[1] / 2, lattice.dims()[2] / 2};
  double sum = 0.0;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    sum += flux(lattice, axis, true, lattice.point(middle));
    sum -= flux(lattice, axis, false, lattice.point(middle));
  }
  return sum / 3;
}

}  // namespace

FoldBarrier::FoldBarrier(const Lattice& start) : dims_(start.dims()), mean_(proved_mean(start)) {}

FoldBarrier::Result FoldBarrier::operator()(const Points& points, double weight,
                                            Points* gradient) const {
  return Walk(dims_, mean_).run(points, weight, gradient);
}

bool FoldBarrier::proves_no_fold(const Points& points) const {
  return all_have_sign(Lattice(dims_, points), mean_ > 0.0);
}

FoldCheck check_bspline_folds(const Lattice& lattice) {
  const double mean = mean_edges(lattice).determinant();
  if (mean == 0.0 || !all_have_sign(lattice, mean > 0.0)) return check_folds(lattice);
  FoldCheck result;
  result.volume = volume_of(lattice);
  return result;
}

FoldBarrier::Result jacobian_range(const Lattice& rest, const Lattice& deformed) {
  return Walk(rest.dims(), mean_edges(rest).determinant()).run(deformed.points(), 0.0, nullptr);
}

}  // namespace hwffd
