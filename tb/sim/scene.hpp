#pragma once

#include <string>
#include <vector>

#include "hwffd/lattice/box.hpp"
#include "hwffd/lattice/deformation.hpp"
#include "hwffd/mesh/mesh.hpp"

namespace hwffd::sim {

/// A mesh embedded in a box lattice whose cells are the mesh's bounding box.
struct Scene {
  Mesh mesh;
  Lattice lattice;
  std::vector<Embedded> vertices;
};

/// Loads and embeds. An empty name is glmark2's cat, or the procedural mesh where that is missing.
Scene make_scene(const std::string& model, const Index3& dims);

/// One deformation of a scene and what the oracle makes of it.
struct Deformed {
  std::string name;  ///< e.g. "twist:90"
  Lattice lattice;
  Points exact;  ///< n x 3, eq. (1) in double
};
Deformed deform(const Scene& scene, const std::string& deformation);

/// Degrees by which the cells of a lattice with that many points are twisted when its ends are
/// twisted by `degrees`: corners move on chords, and the cells end one spacing inside.
double twist_of_cells(double degrees, int points);

}  // namespace hwffd::sim
