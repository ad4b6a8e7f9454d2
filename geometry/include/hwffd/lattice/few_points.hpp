#pragma once

#include "hwffd/lattice/family.hpp"
#include "hwffd/lattice/lattice.hpp"

/// Lattices of 2 or 3 points along some of their axes, of families whose Family::takes_few() says
/// so. What embeds and evaluates wants four points and more along each axis; whole() has them:
///
/// - `bernstein`: along such an axis one cell, of degree 1 or 2, raised to degree 3
/// - `linear`, `catmull-rom`: 1 or 2 cells between all of its points; beyond them the axis goes on
///   straight, by a point at each end
namespace hwffd {

/// The points an axis of whole(); those of an axis with four and more stay.
/// @throws Error for points an axis that the family cannot have
Index3 whole_dims(const Index3& dims, const Family& family);

/// The lattice with four points and more along each axis that is the same map. It is the lattice
/// itself, bit for bit, where that has them already.
/// @throws Error for points an axis that the family cannot have
Lattice whole(const Lattice& lattice, const Family& family);

/// The other way: points of a lattice that whole() made, of dims points an axis. Of a lattice that
/// whole() cannot make, because it bends along such an axis, it is one near to it.
/// @throws Error unless whole_dims() of dims are those of the lattice
Lattice thinned(const Lattice& lattice, const Index3& dims, const Family& family);

}  // namespace hwffd
