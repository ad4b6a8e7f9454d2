// Points carried through the lattices of a hierarchy.

#include "hwffd/device/deformer.hpp"

#include <gtest/gtest.h>

#include "hwffd/error.hpp"
#include "hwffd/lattice/around.hpp"
#include "hwffd/lattice/deformation.hpp"
#include "sample_lattices.hpp"

namespace hwffd {
namespace {

Points cloud() {
  Points points(200, 3);
  std::uint32_t state = 1;
  for (Eigen::Index i = 0; i < points.size(); ++i) {
    state = state * 1664525u + 1013904223u;
    points.data()[i] = state / 4294967296.0;
  }
  return points;
}

Lattice box(const Points& points) { return lattice_around("box", points, {5, 5, 5}); }

Lattice moved(const Lattice& lattice, const char* text) {
  return Deformation::parse(text).apply(lattice);
}

TEST(Deformer, OneStageIsTheLatticeItself) {
  const Points points = cloud();
  const Lattice rest = box(points);
  const Deformer deformer(points, nullptr, {Deformer::Rest{rest}}, Outside::parse("keep"));
  const std::unique_ptr<Device> device = make_device({"reference", "", ""});
  const Deformer::Result still = deformer.deform({rest}, *device);
  EXPECT_LT((still.positions - points).cwiseAbs().maxCoeff(), 1e-12);
  EXPECT_LT((still.gradients[7] - Eigen::Matrix3d::Identity()).norm(), 1e-10);
  ASSERT_EQ(still.summaries.size(), 1u);
  EXPECT_EQ(still.summaries[0].inside, 200u);
  const Deformer::Result scaled = deformer.deform({moved(rest, "scale:2")}, *device);
  EXPECT_LT((scaled.gradients[7] - 2 * Eigen::Matrix3d::Identity()).norm(), 1e-9);
}

TEST(Deformer, StagesComposeInOrder) {
  const Points points = cloud();
  const Lattice first = box(points);
  const Lattice bent = moved(first, "bend:40");
  const std::unique_ptr<Device> device = make_device({"reference", "", ""});
  const Outside outside = Outside::parse("clamp");
  const Points between =
      Deformer(points, nullptr, {Deformer::Rest{first}}, outside).deform({bent}, *device).positions;
  const Lattice second = box((Points(2, 3) << -2, -2, -2, 3, 3, 3).finished());
  const Lattice twisted = moved(second, "twist:50");
  const Points separate = Deformer(between, nullptr, {Deformer::Rest{second}}, outside)
                              .deform({twisted}, *device)
                              .positions;
  const Deformer both(points, nullptr, {Deformer::Rest{first}, Deformer::Rest{second}}, outside);
  const Deformer::Result result = both.deform({bent, twisted}, *device);
  EXPECT_EQ(result.positions, separate);
  EXPECT_EQ(result.summaries.size(), 2u);

  // The gradient of both is their product: against central differences.
  const double h = 1e-6;
  for (int axis = 0; axis < 3; ++axis) {
    Points ahead = points, behind = points;
    ahead.col(axis).array() += h;
    behind.col(axis).array() -= h;
    const auto at = [&](const Points& p) {
      return Deformer(p, nullptr, {Deformer::Rest{first}, Deformer::Rest{second}}, outside)
          .deform({bent, twisted}, *device)
          .positions;
    };
    const Points slope = (at(ahead) - at(behind)) / (2 * h);
    for (Eigen::Index i = 0; i < points.rows(); ++i) {
      if (points.row(i).minCoeff() < 0.02 || points.row(i).maxCoeff() > 0.98) continue;
      const Eigen::Vector3d column = result.gradients[static_cast<std::size_t>(i)].col(axis);
      EXPECT_LT((column - slope.row(i).transpose()).norm(), 1e-5) << "point " << i;
    }
  }
}

// Normals come from the device: its derivatives, near those in double, and only where wanted.
TEST(Deformer, GradientsAreOfTheDevice) {
  const Points points = cloud();
  const Lattice rest = box(points);
  const Deformer deformer(points, nullptr, {Deformer::Rest{rest}}, Outside::parse("keep"));
  const std::vector<Lattice> bent{moved(rest, "bend:40")};
  const Deformer::Result exact = deformer.deform(bent, *make_device({"reference", "", ""}));
  for (const auto& [format, step] : {std::pair{"fp32", 1e-5}, std::pair{"fx18", 2e-3}}) {
    const std::unique_ptr<Device> device = make_device({"model", "basic", format});
    const Deformer::Result got = deformer.deform(bent, *device);
    double most = 0;
    for (std::size_t i = 0; i < exact.gradients.size(); ++i) {
      most = std::max(most, (got.gradients[i] - exact.gradients[i]).cwiseAbs().maxCoeff());
    }
    EXPECT_LT(most, step) << format;
    EXPECT_GT(most, 0) << format;
    const Deformer::Result bare = deformer.deform(bent, *device, Deformer::Gradients::kNone);
    EXPECT_EQ(bare.positions, got.positions);
    EXPECT_TRUE(bare.gradients.empty());
  }
}

TEST(Deformer, CountsEdgesThatTear) {
  const Points points = (Points(3, 3) << 0.5, 0.5, 0.5, 0.6, 0.5, 0.5, 1.5, 0.5, 0.5).finished();
  const Lattice unit = box((Points(2, 3) << 0, 0, 0, 1, 1, 1).finished());
  const std::unique_ptr<Device> device = make_device({"reference", "", ""});
  const Deformer::Triangles triangles{{0, 1, 2}};
  const auto one_triangle = [&]() -> const Deformer::Triangles& { return triangles; };
  const auto torn = [&](const char* outside) {
    return Deformer(points, one_triangle, {Deformer::Rest{unit}}, Outside::parse(outside))
        .deform({moved(unit, "shear:0.5")}, *device)
        .torn_edges;
  };
  EXPECT_EQ(torn("keep"), 2u);
  EXPECT_EQ(torn("clamp"), 0u);
  EXPECT_EQ(torn("fade:1"), 0u);
}

TEST(Deformer, RefusesLatticesThatDoNotFit) {
  const Points points = cloud();
  const Lattice rest = box(points);
  const Outside keep = Outside::parse("keep");
  const std::unique_ptr<Device> device = make_device({"reference", "", ""});
  EXPECT_THROW(Deformer(points, nullptr, {}, keep), Error);
  const Deformer deformer(points, nullptr, {Deformer::Rest{rest}}, keep);
  EXPECT_THROW(deformer.deform({}, *device), Error);
  EXPECT_THROW(deformer.deform({rest, rest}, *device), Error);
  EXPECT_THROW(deformer.deform({lattice_around("box", points, {4, 5, 5})}, *device), Error);
}

}  // namespace
}  // namespace hwffd
