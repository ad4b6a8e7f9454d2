#pragma once

#include "hwffd/lattice/lattice.hpp"

namespace hwffd::picture {

/// Draws a lattice to the current context as the paper's plates do: a small sphere at each control
/// point and straight lines between neighbours along s, t and u. Spheres measure a
/// twelfth of the mean distance between neighbours; the lines' width follows the height of the
/// viewport.
void draw_lattice(const Lattice& lattice);

}  // namespace hwffd::picture
