#include "hwffd/lattice/keyframe.hpp"

#include "same_dims.hpp"

namespace hwffd {

Lattice between(const Lattice& a, const Lattice& b, double fraction) {
  check_same_dims("second keyframe", b.dims(), a.dims());
  if (fraction == 0.0) return a;
  if (fraction == 1.0) return b;
  return Lattice(a.dims(), a.points() + fraction * (b.points() - a.points()));
}

}  // namespace hwffd
