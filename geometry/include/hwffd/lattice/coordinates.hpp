#pragma once

#include <optional>

#include "hwffd/points.hpp"

namespace hwffd {

/// The largest magnitude of a coordinate of points and control points: that of which areas and
/// volumes, and the products of two volumes' roundings, are numbers still.
constexpr double kLargestCoordinate = 1e100;

/// Whether every coordinate is finite and at most kLargestCoordinate.
inline bool has_coordinates(const Point& point) {
  return (point.array().abs() <= kLargestCoordinate).all();
}

/// Throws Error unless all points have coordinates. The message names the row: "point 3".
/// @param what  "point", "lattice point"
void check_coordinates(const char* what, const Points& points);

/// The first point with a coordinate that is a number, but too large for float.
std::optional<Eigen::Index> beyond_float(const Points& points);

}  // namespace hwffd
