#include "device/reference_device.hpp"

namespace hwffd {

Points ReferenceDevice::run(const Lattice& lattice, const std::vector<Embedded>& vertices,
                            const Blending& blending) {
  const Oracle oracle(blending[0], blending[1], blending[2]);
  Points positions(static_cast<Eigen::Index>(vertices.size()), 3);
  for (std::size_t v = 0; v < vertices.size(); ++v) {
    const Embedded& at = vertices[v];
    positions.row(static_cast<Eigen::Index>(v)) =
        oracle.evaluate(lattice.support(at.cell), at.local[0], at.local[1], at.local[2]);
  }
  return positions;
}

Device::Tangents ReferenceDevice::run_tangents(const Lattice& lattice,
                                               const std::vector<Embedded>& vertices,
                                               const Blending& blending) {
  const Oracle oracle(blending[0], blending[1], blending[2]);
  Tangents tangents{run(lattice, vertices, blending), {}};
  tangents.jacobians.reserve(vertices.size());
  for (const Embedded& at : vertices) {
    tangents.jacobians.push_back(oracle.jet(lattice.support(at.cell), at.local).jacobian);
  }
  return tangents;
}

Points ReferenceDevice::run(const std::vector<SupportedVertex>& vertices,
                            const Blending& blending) {
  const Oracle oracle(blending[0], blending[1], blending[2]);
  Points positions(static_cast<Eigen::Index>(vertices.size()), 3);
  for (std::size_t v = 0; v < vertices.size(); ++v) {
    const SupportedVertex& at = vertices[v];
    positions.row(static_cast<Eigen::Index>(v)) =
        oracle.evaluate(at.support, at.local[0], at.local[1], at.local[2]);
  }
  return positions;
}

}  // namespace hwffd
