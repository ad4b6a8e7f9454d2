#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "hwffd/lattice/lattice.hpp"

namespace hwffd {

/// The edges of a cell of a lattice at rest whose cells are all alike, 3 x 3, column a along s, t,
/// u.
Eigen::Matrix3d cell_edges(const Lattice& rest);

/// The bending energy of lattices over one rest, bending_energy() (hwffd/lattice/bending.hpp) but
/// for rounding, as a quadratic form of the displacements u of their control points:
///
///     E(u) = sum over axes c = x,y,z of u_c^T K u_c
///
/// K is a sum of products of three matrices, one along each axis of the lattice: the Gram matrices
/// of uniform cubic B-splines and their derivatives over the cells, of seven diagonals. A value
/// with its gradient takes some 130 multiplications a coordinate for a rest with edges at right
/// angles. Sums have a fixed order; no bit depends on threads or vector units.
class BendingForm {
 public:
  /// @param dims  control points an axis
  /// @param edges  3 x 3, column a the edge of a cell along s, t, u
  /// @throws Error for edges that span no volume
  BendingForm(const Index3& dims, const Eigen::Matrix3d& edges);

  /// The energy of displacements, m x 3, in the order of Lattice::index(). Adds `weight` times its
  /// gradient to `gradient`, if there is one.
  double operator()(const Points& displacements, double weight = 1.0,
                    Points* gradient = nullptr) const;

 private:
  /// Seven diagonals a row: row p has the entries of p - 3 to p + 3.
  using Banded = std::vector<std::array<double, 7>>;
  struct Term {
    double factor;
    std::array<std::size_t, 3> gram;  ///< 3*(order of the left function) + order of the right
  };

  Index3 dims_;
  std::array<std::array<Banded, 9>, 3> gram_;
  std::vector<Term> terms_;
};

}  // namespace hwffd
