// Eq. (1) and its derivatives on devices for functions that do not sum to 1, far from the origin.
#include <gtest/gtest.h>

#include <algorithm>

#include "hwffd/lattice/box.hpp"
#include "hwffd/lattice/deformation.hpp"
#include "sample_lattices.hpp"
#include "weighted_sum.hpp"

namespace hwffd::gl {
namespace {

struct WeightedScene {
  Lattice lattice = Deformation::parse("random:3")
                        .apply(Box({4, -3, 5}, Eigen::Matrix3d::Identity()).lattice({5, 6, 4}));
  std::vector<Embedded> vertices = test::known_places(lattice, 200, 1);
};

/// The largest differences of values and of derivatives from the oracle's.
struct Errors {
  double value = 0;
  double derivative = 0;
};

Errors errors_of(Device& device, const Device::Blending& blending) {
  const WeightedScene scene;
  const Device::Tangents got = weighted_sums(device, scene.lattice, scene.vertices, blending, true);
  EXPECT_EQ(got.positions,
            weighted_sums(device, scene.lattice, scene.vertices, blending, false).positions);
  const Oracle oracle(blending[0], blending[1], blending[2]);
  Errors errors;
  for (std::size_t v = 0; v < scene.vertices.size(); ++v) {
    const Embedded& at = scene.vertices[v];
    const Oracle::Jet exact = oracle.jet(scene.lattice.support(at.cell), at.local);
    const Eigen::Vector3d value = got.positions.row(static_cast<Eigen::Index>(v));
    errors.value = std::max(errors.value, (value - exact.value).cwiseAbs().maxCoeff());
    errors.derivative =
        std::max(errors.derivative, (got.jacobians[v] - exact.jacobian).cwiseAbs().maxCoeff());
  }
  return errors;
}

TEST(Weighted, TangentsOfFunctionsThatDoNotSumToOne) {
  const Device::Blending hermite{Oracle::uniform_bspline(), Oracle::hermite(),
                                 Oracle::bernstein() * 0.5};
  const Device::Blending bspline{Oracle::uniform_bspline(), Oracle::uniform_bspline(),
                                 Oracle::uniform_bspline()};
  for (const Device::Blending& blending : {hermite, bspline}) {
    EXPECT_LT(errors_of(*make_device({"reference", "", ""}), blending).derivative, 1e-12);
    for (const auto& [format, step] :
         {std::pair{"fp32", 1e-5}, std::pair{"fx18", 3e-3}, std::pair{"fx32", 3e-7}}) {
      const Errors errors = errors_of(*make_device({"model", "basic", format}), blending);
      EXPECT_LT(errors.value, step) << format;
      EXPECT_LT(errors.derivative, step) << format;
      EXPECT_GT(errors.derivative, 0) << format;
    }
  }
}

}  // namespace
}  // namespace hwffd::gl
