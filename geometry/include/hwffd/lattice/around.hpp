#pragma once

#include <optional>
#include <string>

#include "hwffd/lattice/family.hpp"
#include "hwffd/lattice/lattice.hpp"

namespace hwffd {

/// Points an axis that suit a shape (shape.hpp): a box of one cell; six cells around a cylinder.
/// @throws UsageError for an unknown shape, which lists those that are known
Index3 usual_dims(const std::string& shape);

/// Twice what rounding to binary32 can move a coordinate, in parts of it.
constexpr double kBinary32Room = 0x1p-23;

/// How a shape lies around points.
struct Fit {
  /// Where the directions x, y (up) and z of an upright shape point: columns that span a volume. A
  /// rotation, or any linear map.
  Eigen::Matrix3d frame = Eigen::Matrix3d::Identity();
  /// Left free beyond the points along these directions, in their units; at least 0.
  Point padding = Point::Zero();
  /// Left free beyond that, in parts of the largest coordinate along x, y and z.
  double room = kBinary32Room;
};

/// The frame whose y axis has a direction, turned there by the shortest way.
/// @throws UsageError for a direction that is zero or not finite
Eigen::Matrix3d frame_with_axis(const Eigen::Vector3d& direction);

/// The corners of the box between two points: a region that a shape may hold instead of points.
/// @throws UsageError unless they are finite and differ along x, y and z
Points corners_of(const Point& low, const Point& high);

/// The lattice of a shape whose cells hold all points (Box, Cylinder, Sphere::around), upright
/// unless the fit says otherwise.
/// @param points  n x 3, n > 0
/// @throws UsageError for an unknown shape or a fit that is none, Error for dims or points that the
///   shape refuses
Lattice lattice_around(const std::string& shape, const Points& points, const Index3& dims,
                       const Fit& fit = {});

/// The same of a family, with the map at rest of the B-spline lattice that has as many cells.
/// @param dims  points an axis; without them cells as usual_dims() has them
///   (few_points.hpp: 2 and 3 are some)
/// @throws Error also for dims that the family cannot have, UsageError for a fit that is none
Lattice lattice_around(const std::string& shape, const Points& points,
                       const std::optional<Index3>& dims, const Family& family,
                       const Fit& fit = {});

}  // namespace hwffd
