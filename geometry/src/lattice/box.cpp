#include "hwffd/lattice/box.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>

#include "generate.hpp"
#include "hwffd/error.hpp"
#include "hwffd/lattice/shape.hpp"

namespace hwffd {
namespace {

constexpr double kFaceTolerance = 1e-12;

/// Position along one axis, 0..1 over the box: a hair outside becomes the face.
double snap(double x) {
  if (x < 0.0 && x >= -kFaceTolerance) return 0.0;
  if (x > 1.0 && x <= 1.0 + kFaceTolerance) return 1.0;
  return x;
}

}  // namespace

Box::Box(const Point& origin, const Eigen::Matrix3d& edges)
    : origin_(origin), edges_(edges), inverse_(edges.inverse()) {
  check_frame("box", origin, edges);
}

Box Box::around(const Points& points, const Point& room) {
  if (points.rows() == 0 || !points.allFinite()) {
    throw Error("box lattice: no bounding box; give at least one point, all finite");
  }
  const Point low = points.colwise().minCoeff();
  const Point high = points.colwise().maxCoeff();
  const Point extent = high - low;
  const double largest = extent.maxCoeff() > 0.0 ? extent.maxCoeff() : 1.0;
  Point origin = low;
  Point size = extent;
  for (int a = 0; a < 3; ++a) {
    if (extent[a] > 1e-9 * largest) continue;
    size[a] = largest;
    origin[a] = low[a] + extent[a] / 2 - largest / 2;
  }
  return Box(origin - room, (size + 2 * room).asDiagonal());
}

std::optional<Box> Box::of(const Lattice& lattice) {
  const Index3 cells = lattice.cells();
  const Point origin = lattice.point(1, 1, 1);
  Eigen::Matrix3d edges;
  edges << lattice.point(cells[0] + 1, 1, 1) - origin, lattice.point(1, cells[1] + 1, 1) - origin,
      lattice.point(1, 1, cells[2] + 1) - origin;
  try {
    Box box(origin, edges);
    const Points difference = box.lattice(lattice.dims()).points() - lattice.points();
    const double size = edges.colwise().norm().minCoeff();
    if (difference.rowwise().norm().maxCoeff() <= kFaceTolerance * size) return box;
  } catch (const Error&) {
    // Edges without volume: not a box.
  }
  return std::nullopt;
}

Lattice Box::lattice(const Index3& dims) const {
  Lattice::check_dims(dims);
  return generate_lattice(dims, [&](int i, int j, int k) {
    const Eigen::Vector3d at((i - 1.0) / (dims[0] - 3), (j - 1.0) / (dims[1] - 3),
                             (k - 1.0) / (dims[2] - 3));
    return Point(origin_ + edges_ * at);
  });
}

Embedded Box::embed(const Index3& dims, const Point& point) const {
  const Eigen::Vector3d at = inverse_ * (point - origin_);
  Embedded result;
  result.inside = true;
  for (int a = 0; a < 3; ++a) {
    const auto axis = static_cast<std::size_t>(a);
    const int cells = dims[axis] - 3;
    const double x = snap(at[a]);
    result.inside = result.inside && x >= 0.0 && x <= 1.0;
    // So written, what is no number is in the first cell.
    const double cell = std::max(0.0, std::min(std::floor(x * cells), cells - 1.0));
    result.cell[axis] = static_cast<int>(cell);
    result.local[a] = x * cells - cell;
  }
  return result;
}

std::vector<Embedded> Box::embed(const Index3& dims, const Points& points) const {
  std::vector<Embedded> result;
  result.reserve(static_cast<std::size_t>(points.rows()));
  for (Eigen::Index i = 0; i < points.rows(); ++i) {
    result.push_back(embed(dims, Point(points.row(i))));
  }
  return result;
}

Point Box::point(const Index3& dims, const Embedded& embedded) const {
  Eigen::Vector3d at;
  for (int a = 0; a < 3; ++a) {
    const auto axis = static_cast<std::size_t>(a);
    at[a] = (embedded.cell[axis] + embedded.local[a]) / (dims[axis] - 3);
  }
  return origin_ + edges_ * at;
}

Shape box_shape() {
  return {"box",
          {4, 4, 4},
          {7, 6, 5},
          false,
          [](const Points& points, const Point& room, const Index3& dims) {
            return Box::around(points, room).lattice(dims);
          },
          [](const Placement& placement, const Index3& dims) {
            return Box(placement.origin, placement.edges).lattice(dims);
          }};
}

}  // namespace hwffd
