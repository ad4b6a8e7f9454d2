#include "hwffd/registration/bending_form.hpp"

#include <gtest/gtest.h>

#include "errors.hpp"
#include "hwffd/lattice/bending.hpp"
#include "hwffd/lattice/box.hpp"
#include "random_numbers.hpp"

namespace hwffd {
namespace {

struct Case {
  Lattice rest, deformed;
  Eigen::Matrix3d edges;  ///< of a cell
};

Case random_case(const Index3& dims, const Eigen::Matrix3d& edges) {
  Lattice rest = Box(Point(1, 2, 3), edges).lattice(dims);
  RandomNumbers random(1);
  Points points = rest.points();
  for (Eigen::Index i = 0; i < points.size(); ++i) points.data()[i] += random(-1, 1);
  Lattice deformed(dims, points);
  Eigen::Matrix3d cell = edges;
  for (int a = 0; a < 3; ++a) cell.col(a) /= dims[static_cast<std::size_t>(a)] - 3;
  return {std::move(rest), std::move(deformed), cell};
}

std::vector<Case> cases() {
  const Eigen::Matrix3d box = Eigen::Vector3d(2, 3, 1).asDiagonal();
  Eigen::Matrix3d oblique;
  oblique << 1, 0.25, 0, 0, 2, 0, 0.5, 0, 3;
  Eigen::Matrix3d turned;
  turned << 0.8, -0.6, 0, 0.6, 0.8, 0, 0, 0, 1;
  return {random_case({4, 4, 4}, box), random_case({6, 5, 9}, box), random_case({5, 7, 4}, oblique),
          random_case({5, 6, 7}, turned * box)};
}

TEST(BendingForm, IsTheBendingEnergy) {
  for (const Case& c : cases()) {
    const double wanted = bending_energy(c.rest, c.deformed);
    const BendingForm form(c.rest.dims(), c.edges);
    EXPECT_NEAR(form(c.deformed.points() - c.rest.points()), wanted, 1e-12 * wanted);
    EXPECT_GT(wanted, 0.1);
  }
}

/// A quadratic form's central differences are exact but for rounding.
TEST(BendingForm, GradientIsThatOfDifferences) {
  for (const Case& c : cases()) {
    const BendingForm form(c.rest.dims(), c.edges);
    const Points u = c.deformed.points() - c.rest.points();
    Points gradient = Points::Constant(u.rows(), 3, 100.0);
    form(u, 3.0, &gradient);
    RandomNumbers random(2);
    for (int n = 0; n < 20; ++n) {
      const auto at = static_cast<Eigen::Index>(random(0, static_cast<double>(u.size())));
      Points more = u;
      Points less = u;
      more.data()[at] += 0.5;
      less.data()[at] -= 0.5;
      const double difference = 3 * (form(more) - form(less));
      EXPECT_NEAR(gradient.data()[at] - 100, difference, 1e-11 * (1 + 3 * form(u)));
    }
  }
}

TEST(BendingForm, OfAffineMapsIsNone) {
  for (const Case& c : cases()) {
    const BendingForm form(c.rest.dims(), c.edges);
    const Points u = c.rest.points() * c.edges;
    EXPECT_NEAR(form(u), 0.0, 1e-11 * form(c.deformed.points()));
  }
}

TEST(BendingForm, Refuses) {
  EXPECT_ERROR(BendingForm({4, 4, 4}, Eigen::Matrix3d::Zero()),
               "bending energy: the edges of a cell span no volume; give a box that has one");
  EXPECT_ERROR(BendingForm({4, 4, 4}, Eigen::Matrix3d::Identity())(Points::Zero(63, 3)),
               "bending energy: another number of displacements than the lattice has points");
}

}  // namespace
}  // namespace hwffd
