// The shared library through its C++: a lattice with its device and family, points that stay
// attached, and threads.

#include <gtest/gtest.h>

#include <limits>
#include <stdexcept>
#include <string>

#include "cube.hpp"
#include "errors.hpp"
#include "hwffd/device/deformable_lattice.hpp"
#include "hwffd/lattice/around.hpp"
#include "hwffd/on_threads.hpp"
#include "same_bits.hpp"

namespace hwffd {
namespace {

/// A lattice of a family around the cube, bent, on a device.
DeformableLattice bent(const std::string& name, const std::string& device) {
  const Family family = Family::parse(name);
  DeformableLattice lattice(
      family.from_bspline(lattice_around("box", cube(), family.bspline_dims({7, 7, 4}))), family);
  lattice.deform("bend:50");
  lattice.set_device({device, "basic", ""});
  return lattice;
}

class Library : public ::testing::Test {
 protected:
  ~Library() override { set_thread_count(0); }
  const Points points_ = Points::Random(5000, 3);
};

TEST_F(Library, BitsDoNotDependOnTheNumberOfThreads) {
  for (const std::string device : {"model", "reference"}) {
    DeformableLattice lattice = bent("bspline", device);
    const std::vector<Embedded> places = lattice.attach(points_).places();
    set_thread_count(1);
    const Points expected = lattice.carry(points_);
    const Device::Tangents tangents =
        make_device({device, "factored3", "fx18"})->tangents(lattice.deformed(), places);
    for (const std::size_t threads : {2, 5}) {
      set_thread_count(threads);
      EXPECT_TRUE(same_bits(lattice.carry(points_), expected)) << device;
      const Device::Tangents again =
          make_device({device, "factored3", "fx18"})->tangents(lattice.deformed(), places);
      EXPECT_TRUE(same_bits(again.positions, tangents.positions)) << device;
      for (std::size_t i = 0; i < places.size(); ++i) {
        ASSERT_TRUE(same_bits(again.jacobians[i], tangents.jacobians[i])) << device << i;
      }
    }
    EXPECT_EQ(lattice.device().counts().vertices, 15000u);
  }
}

TEST_F(Library, SaturatedResultsOfAllThreadsAreCounted) {
  const Lattice box = lattice_around("box", cube(), {4, 4, 4});
  const std::vector<Embedded> places = Attachment(box, points_, Outside::parse("keep")).places();
  const Oracle::Coefficients tall = 40 * Oracle::uniform_bspline();
  std::vector<std::uint64_t> saturated;
  for (const std::size_t threads : {1, 4}) {
    set_thread_count(threads);
    const std::unique_ptr<Device> device = make_device({"model", "basic", "fx18"});
    device->evaluate(box, places, {tall, tall, tall});
    saturated.push_back(device->counts().saturated);
  }
  EXPECT_GT(saturated[0], 1000u);
  EXPECT_EQ(saturated[0], saturated[1]);
}

TEST_F(Library, AttachedPointsAreCarriedAsOthersAre) {
  for (const std::string& family : Family::names()) {
    DeformableLattice lattice = bent(family, "reference");
    const Attachment attachment = lattice.attach(points_);
    const Points first = lattice.carry(points_);
    EXPECT_TRUE(same_bits(lattice.carry(attachment), first)) << family;
    lattice.deform("twist:30");
    EXPECT_TRUE(same_bits(lattice.carry(attachment), lattice.carry(points_))) << family;
    EXPECT_FALSE(same_bits(lattice.carry(attachment), first)) << family;
    EXPECT_EQ(lattice.summary().inside, 5000u) << family;
    DeformableLattice model = bent(family, "model");
    EXPECT_LT((model.carry(points_) - first).cwiseAbs().maxCoeff(), 5e-6) << family;
  }
}

TEST_F(Library, PartsOfManyPointsAreCarriedAsTheWholeIs) {
  Points many = 1.1 * Points::Random(20000, 3);
  for (const std::string device : {"model", "reference"}) {
    DeformableLattice lattice = bent("bspline", device);
    lattice.set_device({device, "factored", "fx18"});
    const Attachment attachment = lattice.attach(many);
    const Points whole = lattice.carry(attachment);
    const EmbeddingSummary summary = lattice.summary();
    EXPECT_GT(summary.outside, 1000u);
    for (const std::size_t threads : {1, 3}) {
      set_thread_count(threads);
      EXPECT_TRUE(same_bits(lattice.carry(many), whole)) << device;
      EXPECT_EQ(lattice.summary().points, summary.points);
      EXPECT_EQ(lattice.summary().inside, summary.inside);
      EXPECT_EQ(lattice.summary().outside, summary.outside);
      EXPECT_EQ(lattice.summary().worst_residual, summary.worst_residual);
    }
    Points broken = many;
    broken(19000, 1) = std::numeric_limits<double>::quiet_NaN();
    EXPECT_ERROR_PART(lattice.carry(broken), "point 19000");
    EXPECT_TRUE(same_bits(lattice.carry(many), whole)) << device;
  }
}

TEST_F(Library, GradientsAreThoseOfDifferences) {
  for (const std::string& family : Family::names()) {
    DeformableLattice lattice = bent(family, "reference");
    const Points some = 0.9 * points_.topRows(50);
    const std::vector<Eigen::Matrix3d> gradients = lattice.gradients(lattice.attach(some));
    constexpr double kStep = 1e-6;
    for (int axis = 0; axis < 3; ++axis) {
      Points step = Points::Zero(50, 3);
      step.col(axis).setConstant(kStep);
      const Points slope = (lattice.carry(some + step) - lattice.carry(some - step)) / (2 * kStep);
      for (Eigen::Index i = 0; i < 50; ++i) {
        const Eigen::Matrix3d& gradient = gradients[static_cast<std::size_t>(i)];
        EXPECT_LT((gradient.col(axis) - slope.row(i).transpose()).norm(), 1e-6) << family << i;
      }
    }
  }
}

TEST_F(Library, DisplacementsAndTheInverseAreThoseOfWhatIsCarried) {
  for (const std::string family : {"bspline", "bernstein"}) {
    DeformableLattice lattice = bent(family, "reference");
    const Points carried = lattice.carry(points_);
    EXPECT_EQ(lattice.displacements(points_), carried - points_) << family;
    EXPECT_LT((lattice.inverse(carried) - points_).cwiseAbs().maxCoeff(), 1e-9) << family;
    Points broken = carried;
    broken(41, 2) = std::numeric_limits<double>::quiet_NaN();
    EXPECT_ERROR_PART(lattice.inverse(broken), "point 41 is not finite");
  }
}

// Points that x takes further by a y^2 have one second derivative, 2 a.
TEST_F(Library, BendingEnergyIsOfTheDeformationAlone) {
  constexpr double kBend = 0.1;
  DeformableLattice lattice(lattice_around("box", cube(), {5, 6, 4}));
  EXPECT_NEAR(lattice.bending_energy(), 0, 1e-20);
  lattice.deform("twist:30");
  EXPECT_GT(lattice.bending_energy(), 1e-3);
  Points points = lattice.rest().points();
  points.col(0).array() += kBend * points.col(1).array().square();
  lattice.move(points);
  EXPECT_NEAR(lattice.bending_energy(), 4 * kBend * kBend, 1e-12);
}

TEST_F(Library, PointsOfAnotherLatticeAreRefused) {
  DeformableLattice lattice = bent("bspline", "reference");
  DeformableLattice other(lattice_around("sphere", cube(), {4, 5, 7}));
  const std::string text =
      "these points are attached to another lattice at rest; attach them to this one";
  EXPECT_ERROR(lattice.carry(other.attach(points_)), text);
  EXPECT_ERROR(lattice.gradients(other.attach(points_)), text);
  DeformableLattice larger(lattice_around("box", 2 * cube(), {5, 5, 4}));
  DeformableLattice smaller(lattice_around("box", cube(), {5, 5, 4}));
  EXPECT_ERROR(smaller.carry(larger.attach(points_)), text);
  const Attachment attachment = lattice.attach(points_);
  lattice.set_family(Family::parse("linear"));
  EXPECT_ERROR(lattice.carry(attachment), text);
  EXPECT_ERROR_PART(other.set_family(Family::parse("bernstein")), "takes 4, 7, 10");
  EXPECT_EQ(other.family().name(), "bspline");
  EXPECT_ERROR_PART(lattice.evaluate({Embedded{{9, 0, 0}, {0, 0, 0}, true}}),
                    "vertex 0: cell (9, 0, 0) of a lattice of 4 x 4 x 1 cells");
}

TEST_F(Library, AWatchEndsAnEvaluation) {
  struct Enough : std::exception {};
  const Points many = Points::Random(400000, 3);
  DeformableLattice lattice = bent("bspline", "model");
  const Attachment attachment = lattice.attach(many);
  for (const std::size_t threads : {1, 2}) {
    set_thread_count(threads);
    int looks = 0;
    const Watch watch([&] {
      if (++looks == 2) throw Enough();
    });
    EXPECT_THROW(lattice.carry(attachment), Enough);
    EXPECT_EQ(looks, 2);
  }
  EXPECT_EQ(lattice.carry(points_).rows(), 5000);
}

}  // namespace
}  // namespace hwffd
