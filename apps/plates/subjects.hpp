#pragma once

#include <string>
#include <vector>

#include "hwffd/lattice/lattice.hpp"
#include "hwffd/mesh/mesh.hpp"

namespace hwffd::plates {

/// What some of the plates show: a model in a lattice of one cell, which is deformed. All of the
/// model that is in the cell follows the lattice, the rest stays (paper, section 6).
struct Subject {
  Mesh mesh;
  Lattice rest;              ///< 4 x 4 x 4 points
  std::string deformation;   ///< as Deformation::parse() reads it
  std::vector<Point> views;  ///< from where it is seen (Camera::around), a plate each
};

/// The cat of plates 1 to 4, the office chair of plates 5 to 8, the chair of plates 9 and 10.
std::vector<Subject> subjects();

}  // namespace hwffd::plates
