#include "device/reference_device.hpp"

namespace hwffd {
namespace {

/// A position for each vertex, of the support that `support` finds for it.
template <class Vertex, class FindSupport>
Points positions_of(const std::vector<Vertex>& vertices, const Device::Blending& blending,
                    const FindSupport& support) {
  const Oracle oracle(blending[0], blending[1], blending[2]);
  Points positions(static_cast<Eigen::Index>(vertices.size()), 3);
  for (std::size_t v = 0; v < vertices.size(); ++v) {
    const Eigen::Vector3d& local = vertices[v].local;
    positions.row(static_cast<Eigen::Index>(v)) =
        oracle.evaluate(support(vertices[v]), local[0], local[1], local[2]);
  }
  return positions;
}

class ReferenceDevice final : public Device {
 public:
  std::string name() const override { return "reference"; }

 protected:
  Points run(const Lattice& lattice, const std::vector<Embedded>& vertices,
             const Blending& blending) override {
    return positions_of(vertices, blending,
                        [&lattice](const Embedded& at) { return lattice.support(at.cell); });
  }

  Points run(const std::vector<SupportedVertex>& vertices, const Blending& blending) override {
    return positions_of(vertices, blending,
                        [](const SupportedVertex& at) -> const Support& { return at.support; });
  }

  Tangents run_tangents(const Lattice& lattice, const std::vector<Embedded>& vertices,
                        const Blending& blending) override {
    const Oracle oracle(blending[0], blending[1], blending[2]);
    Tangents tangents{run(lattice, vertices, blending), {}};
    tangents.jacobians.reserve(vertices.size());
    for (const Embedded& at : vertices) {
      tangents.jacobians.push_back(oracle.jet(lattice.support(at.cell), at.local).jacobian);
    }
    return tangents;
  }
};

}  // namespace

std::unique_ptr<Device> reference_device() { return std::make_unique<ReferenceDevice>(); }

}  // namespace hwffd
