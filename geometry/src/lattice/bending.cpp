#include "hwffd/lattice/bending.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "hwffd/error.hpp"
#include "hwffd/on_threads.hpp"
#include "hwffd/oracle/oracle.hpp"
#include "newton.hpp"
#include "same_dims.hpp"

namespace hwffd {
namespace {

constexpr double kAffine = 1e-9;          // of the cell's size, that points may lie off
constexpr std::size_t kCellsAtOnce = 64;  // that a thread takes at once

/// weighted[order](g, l): the derivative of that order of B_l at the g-th of the four places of
/// Gauss in [0, 1], times the square root of its weight. Squares of such sums, of degree 6 and
/// less, add up to their integral exactly.
using Weighted = std::array<Eigen::Matrix4d, 3>;

Weighted bspline_at_gauss() {
  const double inner = std::sqrt(3.0 / 7 - 2.0 / 7 * std::sqrt(1.2));
  const double outer = std::sqrt(3.0 / 7 + 2.0 / 7 * std::sqrt(1.2));
  const double root = std::sqrt(30.0);
  const Eigen::Vector4d places(-outer, -inner, inner, outer);
  const Eigen::Vector4d weights(18 - root, 18 + root, 18 + root, 18 - root);
  Weighted result;
  for (int g = 0; g < 4; ++g) {
    const Eigen::Matrix<double, 4, 3> functions = uniform_functions((1 + places[g]) / 2);
    for (int order = 0; order < 3; ++order) {
      result[static_cast<std::size_t>(order)].row(g) =
          std::sqrt(weights[g] / 72) * functions.col(order).transpose();
    }
  }
  return result;
}

/// How often d2/da db derives along each of the local coordinates.
std::array<std::size_t, 3> orders(std::size_t a, std::size_t b) {
  std::array<std::size_t, 3> result{};
  ++result[a];
  ++result[b];
  return result;
}

/// The points with a 4 x 4 matrix applied along each axis.
Support contracted(const Support& support, const std::array<const Eigen::Matrix4d*, 3>& axes) {
  Support along = support;
  Support result;
  for (int axis = 0; axis < 3; ++axis) {
    const int step = axis == 0 ? 16 : axis == 1 ? 4 : 1;
    const Eigen::Matrix4d& map = *axes[static_cast<std::size_t>(axis)];
    for (int row = 0; row < 64; ++row) {
      const int at = row / step % 4;
      const int first = row - at * step;
      result.row(row) = map(at, 0) * along.row(first);
      for (int k = 1; k < 4; ++k) result.row(row) += map(at, k) * along.row(first + k * step);
    }
    along = result;
  }
  return along;
}

/// The integral over a cell whose edges have this inverse, in parts of its volume.
double energy_of_cell(const Support& displacement, const Weighted& weighted,
                      const Eigen::Matrix3d& inverse) {
  std::array<Support, 9> second;  // d2u/di dj at all places, i and j among s, t, u
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = i; j < 3; ++j) {
      const auto order = orders(i, j);
      second[3 * i + j] =
          contracted(displacement, {&weighted[order[0]], &weighted[order[1]], &weighted[order[2]]});
      second[3 * j + i] = second[3 * i + j];
    }
  }
  double sum = 0.0;
  for (int a = 0; a < 3; ++a) {
    for (int b = 0; b < 3; ++b) {
      Support in_space = Support::Zero();
      for (std::size_t i = 0; i < 9; ++i) {
        const double factor =
            inverse(static_cast<int>(i / 3), a) * inverse(static_cast<int>(i % 3), b);
        if (factor != 0.0) in_space += factor * second[i];
      }
      sum += in_space.squaredNorm();
    }
  }
  return sum;
}

/// The edges of the cells, all the same.
/// @throws Error where they are not
Eigen::Matrix3d edges_of(const Lattice& rest, const Family& family,
                         const std::vector<Index3>& cells) {
  const Support first = family.support(rest, cells.front());
  const auto point = [](const Support& of, int l, int m, int n) {
    return of.row(16 * l + 4 * m + n);
  };
  Eigen::Matrix3d edges;
  edges.col(0) = point(first, 2, 1, 1) - point(first, 1, 1, 1);
  edges.col(1) = point(first, 1, 2, 1) - point(first, 1, 1, 1);
  edges.col(2) = point(first, 1, 1, 2) - point(first, 1, 1, 1);
  Support regular;
  for (int row = 0; row < 64; ++row) {
    regular.row(row) =
        (edges * Eigen::Vector3d(row / 16 - 1, row / 4 % 4 - 1, row % 4 - 1)).transpose();
  }
  const double size = edges.colwise().norm().minCoeff();
  const auto spacings = [&](const Index3& cell) {
    return Point(edges * (Eigen::Vector3d(cell[0], cell[1], cell[2]) -
                          Eigen::Vector3d(cells.front()[0], cells.front()[1], cells.front()[2])));
  };
  const bool even = std::all_of(cells.begin(), cells.end(), [&](const Index3& cell) {
    const Support support = family.support(rest, cell);
    const Eigen::RowVector3d corner = (Point(point(first, 1, 1, 1)) + spacings(cell)).transpose();
    return ((support.rowwise() - corner) - regular).cwiseAbs().maxCoeff() <= kAffine * size;
  });
  if (even && std::abs(edges.determinant()) > 0.0) return edges;
  throw Error(
      "bending energy: the lattice at rest is no box of even cells; give one, as around 'box' "
      "makes it");
}

}  // namespace

double bending_energy(const Lattice& rest, const Lattice& deformed, const Family& family) {
  check_same_dims("deformed lattice", deformed.dims(), rest.dims());
  const std::vector<Index3> cells = places(family.cells(rest.dims()));
  const Eigen::Matrix3d inverse = edges_of(rest, family, cells).inverse();
  const Weighted weighted = bspline_at_gauss();
  std::vector<double> sums((cells.size() + kCellsAtOnce - 1) / kCellsAtOnce);
  on_ranges(cells.size(), kCellsAtOnce, [&](std::size_t begin, std::size_t end) {
    for (std::size_t c = begin; c < end; ++c) {
      const Support displacement =
          family.support(deformed, cells[c]) - family.support(rest, cells[c]);
      sums[begin / kCellsAtOnce] += energy_of_cell(displacement, weighted, inverse);
    }
  });
  double sum = 0.0;
  for (const double part : sums) sum += part;
  return sum / static_cast<double>(cells.size());
}

}  // namespace hwffd
