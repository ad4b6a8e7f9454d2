#include "hwffd/lattice/cylinder.hpp"

#include <cmath>

#include "circular.hpp"
#include "generate.hpp"
#include "hwffd/lattice/shape.hpp"

namespace hwffd {

Cylinder::Cylinder(const Point& base, const Eigen::Matrix3d& edges, double inner)
    : base_(base), edges_(edges), inner_(inner) {
  check_frame("cylinder", base, edges);
  check_inner("cylinder", inner);
}

Cylinder Cylinder::around(const Points& points, const Point& room) {
  const Surround s = surround(points, room);
  const Point base = s.centre - Point(0, s.half[1], 0);
  return Cylinder(base,
                  Point(s.horizontal_radius, 2 * s.half[1], s.horizontal_radius).asDiagonal());
}

Lattice Cylinder::lattice(const Index3& dims) const {
  Lattice::check_dims(dims);
  check_round("cylinder", dims, 2, 6);
  const int around = dims[2] - 3;
  const double step = 2 * M_PI / around;
  const double reach = round_radius(step);
  return generate_lattice(dims, [&](int i, int j, int k) {
    const double angle = (k % around - 1) * step;
    const double radius = reach * layer_radius(i, dims[0], inner_);
    const double height = (j - 1.0) / (dims[1] - 3);
    return Point(base_ +
                 edges_ * Point(radius * std::cos(angle), height, radius * std::sin(angle)));
  });
}

Shape cylinder_shape() {
  return {"cylinder",
          {4, 4, 9},
          {5, 6, 11},
          true,
          [](const Points& points, const Point& room, const Index3& dims) {
            return Cylinder::around(points, room).lattice(dims);
          },
          [](const Placement& placement, const Index3& dims) {
            return Cylinder(placement.origin, placement.edges, placement.inner).lattice(dims);
          }};
}

}  // namespace hwffd
