#pragma once

#include <array>

#include "hwffd/lattice/family.hpp"
#include "hwffd/lattice/lattice.hpp"

namespace hwffd {

/// Points an axis of refined(): 2(n - 3) + 3 along the axes that are refined, n along others.
Index3 refined_dims(const Index3& dims, const std::array<bool, 3>& axes = {true, true, true});

/// The lattice with each cell halved along the axes wanted that maps as this one does: knots are
/// inserted into uniform cubic B-splines (Boehm 1980), which makes new control points of the old by
/// (1 6 1)/8 and (4 4)/8 along each axis. The place (cell c; s) of an axis is then (cell 2c; 2s),
/// or (cell 2c + 1; 2s - 1) from s = 1/2 on. Sums have twice the digits of a double, and each
/// coordinate is rounded once, at the end: so the maps agree to within half a unit in the last
/// place of the largest control point around a place.
/// @throws Error for more than 64 points an axis, and for another family than bspline
Lattice refined(const Lattice& lattice, const std::array<bool, 3>& axes = {true, true, true},
                const Family& family = {});

}  // namespace hwffd
