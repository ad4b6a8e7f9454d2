#include "mass_spring/mass_spring.hpp"

#include <Eigen/Geometry>
#include <array>

namespace hwffd::mass_spring {
namespace {

/// From a point to those it is joined to; the others are joined to it.
constexpr std::array<Index3, 13> kNeighbours{{{1, 0, 0},
                                              {0, 1, 0},
                                              {0, 0, 1},
                                              {1, 1, 0},
                                              {1, -1, 0},
                                              {1, 0, 1},
                                              {1, 0, -1},
                                              {0, 1, 1},
                                              {0, 1, -1},
                                              {1, 1, 1},
                                              {1, 1, -1},
                                              {1, -1, 1},
                                              {1, -1, -1}}};

}  // namespace

MassSpring::MassSpring(const Lattice& rest, const Material& material)
    : dims_(rest.dims()),
      material_(material),
      positions_(rest.points()),
      velocities_(Points::Zero(rest.points().rows(), 3)),
      held_(static_cast<std::size_t>(rest.points().rows()), false) {
  join_neighbours(rest);
}

void MassSpring::join_neighbours(const Lattice& rest) {
  const auto has = [&](const Index3& at) {
    return at[0] < dims_[0] && at[1] >= 0 && at[1] < dims_[1] && at[2] >= 0 && at[2] < dims_[2];
  };
  for (const Index3& at : places(dims_)) {
    for (const Index3& to : kNeighbours) {
      const Index3 other{at[0] + to[0], at[1] + to[1], at[2] + to[2]};
      if (!has(other)) continue;
      springs_.push_back(
          {rest.index(at), rest.index(other), (rest.point(other) - rest.point(at)).norm()});
    }
  }
}

void MassSpring::hold(Eigen::Index point, const Point& at) {
  held_[static_cast<std::size_t>(point)] = true;
  positions_.row(point) = at;
  velocities_.row(point).setZero();
}

Points MassSpring::forces() const {
  Points sum = Points::Zero(positions_.rows(), 3);
  for (const Spring& spring : springs_) {
    const Point between = positions_.row(spring.b) - positions_.row(spring.a);
    const Point moving = velocities_.row(spring.b) - velocities_.row(spring.a);
    const double length = between.norm();
    if (length == 0) continue;  // no direction to push in
    const Point along = between / length;
    const Point pull =
        (material_.stiffness * (length - spring.length) + material_.damping * moving.dot(along)) *
        along;
    sum.row(spring.a) += pull;
    sum.row(spring.b) -= pull;
  }
  return sum;
}

void MassSpring::accelerate(double time) {
  const Points force = forces();
  for (Eigen::Index p = 0; p < positions_.rows(); ++p) {
    if (!held_[static_cast<std::size_t>(p)]) velocities_.row(p) += time * force.row(p);
  }
}

void MassSpring::step(double time) {
  accelerate(time / 2);
  positions_ += time * velocities_;
  accelerate(time / 2);
}

double MassSpring::elastic_energy() const {
  double sum = 0.0;
  for (const Spring& spring : springs_) {
    const double longer =
        (positions_.row(spring.b) - positions_.row(spring.a)).norm() - spring.length;
    sum += material_.stiffness * longer * longer / 2;
  }
  return sum;
}

Point MassSpring::angular_momentum() const {
  Point sum = Point::Zero();
  for (Eigen::Index p = 0; p < positions_.rows(); ++p) {
    const Point position = positions_.row(p);
    const Point velocity = velocities_.row(p);
    sum += position.cross(velocity);
  }
  return sum;
}

}  // namespace hwffd::mass_spring
