#pragma once

#include <vector>

#include "hwffd/lattice/lattice.hpp"

namespace hwffd::mass_spring {

/// What a body is made of. Every control point has mass 1.
struct Material {
  double stiffness = 1200;  ///< of every spring: force by length
  double damping = 16;      ///< of every spring: force by the speed at which it gets longer
};

/// A lattice as a body: its control points are masses, joined by springs to their neighbours along
/// s, t, u and, against shear, along the diagonals of faces and cells. The springs are at
/// rest in the lattice it is made from. Forces act along the springs only, so that a body left
/// alone keeps its momentum and angular momentum.
class MassSpring {
 public:
  explicit MassSpring(const Lattice& rest, const Material& material = {});

  /// The control points where they are now.
  Lattice lattice() const { return {dims_, positions_}; }

  /// Holds a point (a row of Lattice::points()) at a place, until let_go().
  void hold(Eigen::Index point, const Point& at);
  void let_go(Eigen::Index point) { held_[static_cast<std::size_t>(point)] = false; }

  /// Moves everything on by a time, in one step of the velocity Verlet method. Steps must be short:
  /// 0.1 / sqrt(stiffness) or less, and less than 0.03 / damping.
  void step(double time);

  double kinetic_energy() const { return velocities_.squaredNorm() / 2; }
  double elastic_energy() const;
  double energy() const { return kinetic_energy() + elastic_energy(); }

  Point momentum() const { return velocities_.colwise().sum(); }
  /// About the origin.
  Point angular_momentum() const;

 private:
  struct Spring {
    Eigen::Index a;
    Eigen::Index b;
    double length;  ///< at rest
  };

  void join_neighbours(const Lattice& rest);
  Points forces() const;
  void accelerate(double time);

  Index3 dims_;
  Material material_;
  Points positions_;
  Points velocities_;
  std::vector<bool> held_;
  std::vector<Spring> springs_;
};

}  // namespace hwffd::mass_spring
