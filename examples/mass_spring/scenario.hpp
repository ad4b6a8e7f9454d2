#pragma once

#include <vector>

#include "hwffd/lattice/lattice.hpp"

namespace hwffd::mass_spring {

/// The state of a body at the time of a frame.
struct Frame {
  Lattice lattice;
  double kinetic = 0;  ///< energies, in units of the body
  double elastic = 0;
  bool released = false;  ///< nobody pulls any more

  double energy() const { return kinetic + elastic; }
};

/// A body that stands on the floor by its two lowest layers of points (along t) is pulled aside,
/// upwards and round by its highest, let go, and swings until it stands still. A quarter of the
/// frames is for pulling. 24 frames are a second.
/// @param rest    a lattice with t upwards, of at least 5 points along t; frame 0 is this lattice
/// @param frames  at least 4
/// @throws Error for fewer points or frames
std::vector<Frame> pull_and_release(const Lattice& rest, int frames);

}  // namespace hwffd::mass_spring
