#include "device/reference_device.hpp"

#include "hwffd/lattice/lattice_evaluator.hpp"
#include "hwffd/lattice/pull_back.hpp"
#include "hwffd/on_threads.hpp"

namespace hwffd {
namespace {

constexpr std::size_t kJetsAtOnce = 256;

class ReferenceDevice final : public Device {
 public:
  std::string name() const override { return "reference"; }
  bool concurrent() const override { return true; }

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
    tangents.jacobians.resize(vertices.size());
    on_ranges(vertices.size(), kJetsAtOnce, [&](std::size_t first, std::size_t end) {
      for (std::size_t i = first; i < end; ++i) {
        const Embedded& at = vertices[i];
        tangents.jacobians[i] = oracle.jet(lattice.support(at.cell), at.local).jacobian;
      }
    });
    return tangents;
  }

  Points run_pull_back(const Index3& dims, const std::vector<Embedded>& vertices,
                       const Points& gradient, const Blending& blending) override {
    return pull_back_in(dims, vertices, gradient, blending);
  }
};

}  // namespace

std::unique_ptr<Device> reference_device() { return std::make_unique<ReferenceDevice>(); }

}  // namespace hwffd
