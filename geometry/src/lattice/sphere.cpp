#include "hwffd/lattice/sphere.hpp"

#include <cmath>

#include "circular.hpp"
#include "generate.hpp"
#include "hwffd/lattice/shape.hpp"

namespace hwffd {

Sphere::Sphere(const Point& centre, const Eigen::Matrix3d& edges, double inner)
    : centre_(centre), edges_(edges), inner_(inner) {
  check_frame("sphere", centre, edges);
  check_inner("sphere", inner);
}

Sphere Sphere::around(const Points& points, const Point& room) {
  const Surround s = surround(points, room);
  return Sphere(s.centre, Eigen::Matrix3d::Identity() * s.radius);
}

Lattice Sphere::lattice(const Index3& dims) const {
  Lattice::check_dims(dims);
  check_round("sphere", dims, 1, 5);
  check_round("sphere", dims, 2, 6);
  const int around = dims[2] - 3;
  const double step = 2 * M_PI / around;
  const double rise = M_PI / (dims[1] - 3);  // from one layer along t to the next
  return generate_lattice(dims, [&](int i, int j, int k) {
    const double angle = (k % around - 1) * step;
    const double height = (j - 1) * rise;  // from the lower pole
    const double radius = round_radius(rise) * layer_radius(i, dims[0], inner_);
    const double level = radius * round_radius(step) * std::sin(height);
    return Point(centre_ + edges_ * Point(level * std::cos(angle), -radius * std::cos(height),
                                          level * std::sin(angle)));
  });
}

Shape sphere_shape() {
  return {"sphere",
          {4, 6, 9},
          {5, 8, 11},
          true,
          [](const Points& points, const Point& room, const Index3& dims) {
            return Sphere::around(points, room).lattice(dims);
          },
          [](const Placement& placement, const Index3& dims) {
            return Sphere(placement.origin, placement.edges, placement.inner).lattice(dims);
          }};
}

}  // namespace hwffd
