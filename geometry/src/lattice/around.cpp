#include "hwffd/lattice/around.hpp"

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <cmath>
#include <limits>

#include "hwffd/error.hpp"
#include "hwffd/excerpt.hpp"
#include "hwffd/lattice/few_points.hpp"
#include "hwffd/lattice/shape.hpp"

namespace hwffd {
namespace {

const Shape& find(const std::string& name) {
  const Shape* shape = find_shape(name);
  if (shape != nullptr) return *shape;
  throw UsageError("shape '" + excerpt(name) + "' is unknown; one of " + shape_list());
}

void check(const Fit& fit) {
  const bool padded = fit.padding.allFinite() && (fit.padding.array() >= 0.0).all();
  if (!padded) throw UsageError("padding: a finite number of at least 0, or one for x, y and z");
  const double scale = fit.frame.colwise().norm().prod();
  if (fit.frame.allFinite() && std::abs(fit.frame.determinant()) > 1e-9 * scale) return;
  throw UsageError(
      "rotation: spans no volume; give 3 x 3 finite numbers, columns in three directions");
}

}  // namespace

Index3 usual_dims(const std::string& shape) { return find(shape).usual; }

Eigen::Matrix3d frame_with_axis(const Eigen::Vector3d& direction) {
  const double length = direction.stableNorm();
  if (!(length > 0.0) || !std::isfinite(length)) {
    throw UsageError("axis: no direction; give three finite numbers, not all of them 0");
  }
  const Eigen::Vector3d up = direction / length;
  // Rodrigues' formula about y x up, whose length is the sine: exact for x, y and z.
  const Eigen::Vector3d about = Eigen::Vector3d::UnitY().cross(up);
  const double squared = about.squaredNorm();
  if (up[1] < 0.0 && squared < std::numeric_limits<double>::min()) {
    return Eigen::Vector3d(1, -1, -1).asDiagonal();
  }
  // 1 + cosine, which cancels where it points down.
  const double sum = up[1] < 0.0 ? squared / (1.0 - up[1]) : 1.0 + up[1];
  Eigen::Matrix3d cross;
  cross << 0, -about[2], about[1], about[2], 0, -about[0], -about[1], about[0], 0;
  return Eigen::Matrix3d::Identity() + cross + cross * cross / sum;
}

Points corners_of(const Point& low, const Point& high) {
  if (!low.allFinite() || !high.allFinite() || (low.array() == high.array()).any()) {
    throw UsageError(
        "region: spans no volume; give two corners, finite and different along x, y and z");
  }
  Points corners(8, 3);
  for (int i = 0; i < 8; ++i) {
    for (int a = 0; a < 3; ++a) corners(i, a) = (i >> a) % 2 == 0 ? low[a] : high[a];
  }
  return corners;
}

Lattice lattice_around(const std::string& shape, const Points& points, const Index3& dims,
                       const Fit& fit) {
  check(fit);
  const bool upright = fit.frame == Eigen::Matrix3d::Identity();
  const Eigen::Matrix3d inverse = upright ? fit.frame : fit.frame.inverse();
  Point room = Point::Zero();
  if (points.rows() > 0) {
    room = inverse.cwiseAbs() * Point(fit.room * points.cwiseAbs().colwise().maxCoeff());
  }
  const Shape& entry = find(shape);
  if (upright) return entry.around(points, room + fit.padding, dims);
  const Lattice lattice = entry.around(points * inverse.transpose(), room + fit.padding, dims);
  return Lattice(dims, lattice.points() * fit.frame.transpose());
}

Lattice lattice_around(const std::string& shape, const Points& points,
                       const std::optional<Index3>& dims, const Family& family, const Fit& fit) {
  if (!dims) return family.from_bspline(lattice_around(shape, points, usual_dims(shape), fit));
  const Index3 cells = family.bspline_dims(whole_dims(*dims, family));
  return thinned(family.from_bspline(lattice_around(shape, points, cells, fit)), *dims, family);
}

}  // namespace hwffd
