#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "hwffd/lattice/embedder.hpp"
#include "hwffd/lattice/fold.hpp"

namespace hwffd::embed {

/// One mesh, or points inside by construction, embedded in one lattice.
struct Row {
  std::string mesh;  ///< its file, or "by construction"
  std::string lattice;
  Index3 dims;
  EmbeddingSummary summary;
  double size = 0.0;  ///< of the lattice (Embedder::size)
  FoldCheck folds;
  bool holds_all = true;  ///< whether the lattice is one that holds every point

  /// The worst residual of the points inside, in parts of the lattice's size.
  double max_residual_relative() const { return summary.worst_residual / size; }
};

/// Microseconds of processor time that check_folds() takes for each cell of a bent box.
/// @param points  control points an axis
double fold_check_us_per_cell(int points);

/// Points of known places in a lattice of every kind, embedded again.
std::vector<Row> by_construction(std::size_t points, std::uint64_t seed);

/// The vertices of a mesh in a lattice of every kind around it.
/// @param model a file, or a name that find_model() knows
/// @throws Error where there is no such mesh
std::vector<Row> of_mesh(const std::string& model);

}  // namespace hwffd::embed
