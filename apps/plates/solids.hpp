#pragma once

#include <functional>
#include <string>
#include <vector>

#include "hwffd/mesh/mesh.hpp"

namespace hwffd::plates {

/// A circle of a tube.
struct Station {
  Point centre;
  double radius;
};

/// A material: name and diffuse colour, and the longest edge that its solids are made of, so that
/// they bend smoothly.
struct Stuff {
  std::string name;
  std::array<float, 3> colour;
  double step;
};

/// A tube with rounded ends through circles, straight from each to the next.
/// @param stations  at least two, no two in a row with the same centre
Mesh::Part tube(const Stuff& stuff, const std::vector<Station>& stations);

/// A tube through circles in a smooth curve (Catmull-Rom).
Mesh::Part curved_tube(const Stuff& stuff, const std::vector<Station>& stations);

/// A box with rounded edges.
/// @param half    half its size along x, y and z
/// @param radius  of its edges, greater than 0, at most the least of half
Mesh::Part rounded_box(const Stuff& stuff, const Point& centre, const Point& half, double radius);

/// A part with its points moved.
Mesh::Part moved(Mesh::Part part, const std::function<Point(const Point&)>& move);

}  // namespace hwffd::plates
