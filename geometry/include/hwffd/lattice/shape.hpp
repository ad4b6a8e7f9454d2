#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>

#include "hwffd/lattice/lattice.hpp"

namespace hwffd {

/// What a lattice file says of a shape, beside its points an axis.
struct Placement {
  Point origin = Point::Zero();
  Eigen::Matrix3d edges = Eigen::Matrix3d::Identity();
  double inner = 0.0;  ///< radius, in parts of the outer; 0 where the shape has none
};

/// A kind of lattice that is made, not given by its points. geometry/CMakeLists.txt lists them by
/// name; the file of that name has the function NAME_shape(), which is all that others know.
struct Shape {
  const char* name;
  Index3 usual;    ///< points an axis that suit it
  Index3 several;  ///< the same with several cells an axis, unequal: for tests and studies
  bool has_inner;  ///< whether it may be hollow
  Lattice (*around)(const Points& points, const Point& room, const Index3& dims);
  Lattice (*placed)(const Placement& placement, const Index3& dims);
};

/// All of them, in the order of that list.
const std::vector<Shape>& shapes();

/// That of a name, or a null pointer.
const Shape* find_shape(const std::string& name);

/// Their names.
const std::vector<std::string>& shape_names();

/// The names as one text: "box, cylinder, sphere", or with " or " in front of the last.
std::string shape_list(const char* before_last = ", ");

}  // namespace hwffd
