#include "circular.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "hwffd/error.hpp"
#include "hwffd/lattice/box.hpp"

namespace hwffd {

double round_radius(double step) {
  // In the middle between knots the blending functions are 1/48, 23/48, 23/48, 1/48.
  return 24.0 / (23.0 * std::cos(step / 2) + std::cos(3 * step / 2));
}

Surround surround(const Points& points, const Point& room) {
  const Box box = Box::around(points, room);
  Surround result;
  result.half = box.edges().diagonal() / 2;
  result.centre = box.origin() + result.half;
  for (Eigen::Index i = 0; i < points.rows(); ++i) {
    const Point arm = (Point(points.row(i)) - result.centre).cwiseAbs() + room;
    result.radius = std::max(result.radius, arm.norm());
    result.horizontal_radius = std::max(result.horizontal_radius, std::hypot(arm[0], arm[2]));
  }
  // Points on a vertical line, or one point: any radius holds them that holds the room.
  const double least = result.half.minCoeff();
  if (result.radius < room.norm() + 1e-9 * least) result.radius = least;
  const double horizontal_room = std::hypot(room[0], room[2]);
  if (result.horizontal_radius < horizontal_room + 1e-9 * least) result.horizontal_radius = least;
  return result;
}

void check_inner(const char* shape, double inner) {
  if (inner >= 0.0 && inner < 1.0) return;
  throw Error(fmt::format(
      "{} lattice: inner radius {} of the outer; give 0 (solid) or more, and less than 1", shape,
      inner));
}

void check_round(const char* shape, const Index3& dims, int axis, int minimum) {
  const int n = dims[static_cast<std::size_t>(axis)];
  if (n >= minimum) return;
  throw Error(fmt::format(
      "{} lattice: {} points along {}, which goes around; give at least {}, as three of them {}",
      shape, n, "stu"[axis], minimum,
      axis == 2 ? "repeat the first three" : "lie at and beyond the poles"));
}

double layer_radius(int i, int n, double inner) {
  return inner + (1.0 - inner) * (i - 1.0) / (n - 3);
}

}  // namespace hwffd
