#pragma once

#include "hwffd/device/device.hpp"

namespace hwffd {

/// Eq. (1) in double precision, by the oracle.
class ReferenceDevice final : public Device {
 public:
  std::string name() const override { return "reference"; }

 protected:
  Points run(const Lattice& lattice, const std::vector<Embedded>& vertices,
             const Blending& blending) override;
  Points run(const std::vector<SupportedVertex>& vertices, const Blending& blending) override;
  Tangents run_tangents(const Lattice& lattice, const std::vector<Embedded>& vertices,
                        const Blending& blending) override;
};

}  // namespace hwffd
