#include "weighted_sum.hpp"

#include <cmath>

namespace hwffd::gl {
namespace {

constexpr int kSamples = 64;  // of a function on [0, 1]

bool sum_to_one(const Oracle::Coefficients& functions) {
  const Eigen::RowVector4d sum = functions.colwise().sum();
  return (sum - Eigen::RowVector4d(1, 0, 0, 0)).cwiseAbs().maxCoeff() < 1e-6;
}

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

void clamp(std::vector<Embedded>& vertices) {
  for (Embedded& vertex : vertices) vertex.local = vertex.local.cwiseMax(0.0).cwiseMin(1.0);
}

}  // namespace

Points weighted_sums(Device& device, const Lattice& lattice, std::vector<Embedded> vertices,
                     const Device::Blending& blending) {
  clamp(vertices);
  if (sum_to_one(blending[0]) && sum_to_one(blending[1]) && sum_to_one(blending[2])) {
    return device.evaluate(lattice, vertices, blending);
  }
  Device::Blending scaled = blending;
  double scale = 1;
  for (Oracle::Coefficients& axis : scaled) {
    const double by = sum_to_one(axis) ? 1.0 : scale_of(axis);
    axis /= by;
    scale *= by;
  }
  const Eigen::RowVector3d low = lattice.points().colwise().minCoeff();
  const Eigen::RowVector3d high = lattice.points().colwise().maxCoeff();
  const Eigen::RowVector3d centre = (low + high) / 2;
  const Points centred = lattice.points().rowwise() - centre;
  Points sums = device.evaluate(Lattice(lattice.dims(), centred), vertices, scaled) * scale;
  const Oracle oracle(blending[0], blending[1], blending[2]);
  for (std::size_t v = 0; v < vertices.size(); ++v) {
    double weight = 1;
    for (const Oracle::Axis axis : {Oracle::kS, Oracle::kT, Oracle::kU}) {
      weight *= oracle.blending(axis, vertices[v].local[axis]).sum();
    }
    sums.row(static_cast<Eigen::Index>(v)) += weight * centre;
  }
  return sums;
}

}  // namespace hwffd::gl
