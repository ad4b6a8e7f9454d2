#include "weighted_sum.hpp"

#include <algorithm>
#include <cmath>

namespace hwffd::gl {
namespace {

constexpr int kSamples = 64;  // of a function on [0, 1]

/// The power of two that the sum of the functions' magnitudes stays below.
double scale_of(const Oracle::Coefficients& functions) {
  const Oracle oracle(functions);
  double largest = 0;
  for (int i = 0; i <= kSamples; ++i) {
    const Eigen::Vector4d values = oracle.blending(Oracle::kS, static_cast<double>(i) / kSamples);
    largest = std::max(largest, values.cwiseAbs().sum());
  }
  int exponent = 0;
  std::frexp(largest, &exponent);  // largest < 2^exponent
  return std::ldexp(1.0, exponent);
}

std::vector<Embedded> clamped(std::vector<Embedded> vertices) {
  for (Embedded& vertex : vertices) vertex.local = vertex.local.cwiseMax(0.0).cwiseMin(1.0);
  return vertices;
}

bool all_sum_to_one(const Device::Blending& blending) {
  return std::all_of(blending.begin(), blending.end(), Oracle::sum_to_one);
}

/// What a device can evaluate in place of functions that do not sum to 1.
struct Centred {
  Lattice lattice;
  Device::Blending blending;
  double scale = 1;
  Support centre;  ///< the lattice's, 64 times: what was taken away from any support

  Centred(const Lattice& from, const Device::Blending& functions)
      : lattice(from), blending(functions) {
    for (Oracle::Coefficients& axis : blending) {
      const double by = Oracle::sum_to_one(axis) ? 1.0 : scale_of(axis);
      axis /= by;
      scale *= by;
    }
    const Eigen::RowVector3d low = from.points().colwise().minCoeff();
    const Eigen::RowVector3d high = from.points().colwise().maxCoeff();
    centre.rowwise() = (low + high) / 2;
    lattice = Lattice(from.dims(), from.points().rowwise() - centre.row(0));
  }
};

Device::Tangents on_device(Device& device, const Lattice& lattice,
                           const std::vector<Embedded>& places, const Device::Blending& blending,
                           bool derivatives) {
  if (derivatives) return device.tangents(lattice, places, blending);
  return {device.evaluate(lattice, places, blending), {}};
}

}  // namespace

Device::Tangents weighted_sums(Device& device, const Lattice& lattice,
                               const std::vector<Embedded>& vertices,
                               const Device::Blending& blending, bool derivatives) {
  const std::vector<Embedded> places = clamped(vertices);
  if (all_sum_to_one(blending)) return on_device(device, lattice, places, blending, derivatives);
  const Centred centred(lattice, blending);
  Device::Tangents sums = on_device(device, centred.lattice, places, centred.blending, derivatives);
  const Oracle oracle(blending[0], blending[1], blending[2]);
  sums.positions *= centred.scale;
  for (std::size_t v = 0; v < places.size(); ++v) {
    const Oracle::Jet mend = oracle.jet(centred.centre, places[v].local);
    sums.positions.row(static_cast<Eigen::Index>(v)) += mend.value.transpose();
    if (derivatives) sums.jacobians[v] = sums.jacobians[v] * centred.scale + mend.jacobian;
  }
  return sums;
}

}  // namespace hwffd::gl
