#pragma once

#include "hwffd/lattice/family.hpp"
#include "hwffd/lattice/lattice.hpp"

namespace hwffd {

/// The bending energy of a deformation (docs/lattice.md section 11; Rueckert et al. 1999): where
/// u(x) is the displacement of the point x of the cells at rest, and V their volume,
///
///     1/V * integral over the cells of  sum over a,b = x,y,z of  |d2u / da db|^2  dx dy dz
///
/// 0 for affine maps, in 1/length^2. It is exact but for rounding, since squares of polynomials are
/// integrated exactly by enough places of Gauss, and costs some 15,000 multiplications a cell. What
/// bends at faces between cells (families that are not C1) is not counted.
/// @param rest  whose cells are one parallelepiped, divided evenly
/// @throws Error for a lattice at rest of another shape, or dimensions that differ
double bending_energy(const Lattice& rest, const Lattice& deformed, const Family& family = {});

}  // namespace hwffd
