#include "device/reference_device.hpp"

#include "hwffd/lattice/lattice_evaluator.hpp"

namespace hwffd {
namespace {

class ReferenceDevice final : public Device {
 public:
  std::string name() const override { return "reference"; }

 protected:
  Points run(const Lattice& lattice, const std::vector<Embedded>& vertices,
             const Blending& blending) override {
    return evaluate_in(lattice, vertices, blending);
  }

  Points run(const std::vector<SupportedVertex>& vertices, const Blending& blending) override {
    return evaluate_in(vertices, blending);
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
