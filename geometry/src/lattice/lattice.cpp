#include "hwffd/lattice/lattice.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "hwffd/error.hpp"
#include "hwffd/lattice/coordinates.hpp"
#include "same_dims.hpp"

namespace hwffd {

std::vector<Index3> places(const Index3& counts) {
  std::vector<Index3> all;
  for (int n = 0; n < counts[0] * counts[1] * counts[2]; ++n) {
    all.push_back({n / (counts[1] * counts[2]), n / counts[2] % counts[1], n % counts[2]});
  }
  return all;
}

void Lattice::check_dims(const Index3& dims, int least) {
  for (const int n : dims) {
    if (n >= least && n <= kMaxPoints) continue;
    throw Error(fmt::format("lattice of {} x {} x {} points: each axis takes {} to {} points",
                            dims[0], dims[1], dims[2], least, kMaxPoints));
  }
}

Index3 Lattice::cells() const {
  Index3 result = dims_;
  for (int& n : result) n = std::max(0, n - 3);
  return result;
}

Lattice::Lattice(const Index3& dims, Points points) : dims_(dims), points_(std::move(points)) {
  check_dims(dims, kFewestPoints);
  const Eigen::Index expected = static_cast<Eigen::Index>(dims[0]) * dims[1] * dims[2];
  if (points_.rows() != expected) {
    throw Error(fmt::format("lattice of {} x {} x {} points: {} points given; give {}", dims[0],
                            dims[1], dims[2], points_.rows(), expected));
  }
  check_coordinates("lattice point", points_);
}

Support Lattice::support(const Index3& cell) const {
  const Index3 count = cells();
  for (std::size_t a = 0; a < 3; ++a) {
    if (cell[a] >= 0 && cell[a] < count[a]) continue;
    throw Error(fmt::format("cell ({}, {}, {}) is outside the lattice; it has {} x {} x {} cells",
                            cell[0], cell[1], cell[2], count[0], count[1], count[2]));
  }
  Support support;
  for (int l = 0; l < 4; ++l) {
    for (int m = 0; m < 4; ++m) {
      for (int n = 0; n < 4; ++n) {
        support.row((l * 4 + m) * 4 + n) =
            points_.row(index(cell[0] + l, cell[1] + m, cell[2] + n));
      }
    }
  }
  return support;
}

Lattice between(const Lattice& a, const Lattice& b, double fraction) {
  check_same_dims("second keyframe", b.dims(), a.dims());
  if (fraction == 0.0) return a;
  if (fraction == 1.0) return b;
  return Lattice(a.dims(), a.points() + fraction * (b.points() - a.points()));
}

}  // namespace hwffd
