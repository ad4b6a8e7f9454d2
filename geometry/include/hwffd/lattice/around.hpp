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

/// The upright lattice of a shape whose cells hold all points (Box, Cylinder, Sphere::around).
/// @param points  n x 3, n > 0
/// @param room    beyond the points, in parts of the largest coordinate along each axis; by default
///                so that they are inside as floats as well
/// @throws UsageError for an unknown shape, Error for dims or points that the shape refuses
Lattice lattice_around(const std::string& shape, const Points& points, const Index3& dims,
                       double room = kBinary32Room);

/// The same of a family, with the map at rest of the B-spline lattice that has as many cells.
/// @param dims  points an axis; without them cells as usual_dims() has them
///   (few_points.hpp: 2 and 3 are some)
/// @throws Error also for dims that the family cannot have
Lattice lattice_around(const std::string& shape, const Points& points,
                       const std::optional<Index3>& dims, const Family& family,
                       double room = kBinary32Room);

}  // namespace hwffd
