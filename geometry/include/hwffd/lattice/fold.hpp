#pragma once

#include <string>

#include "hwffd/lattice/family.hpp"
#include "hwffd/lattice/lattice.hpp"

namespace hwffd {

/// Whether the map of a lattice, eq. (1) with functions of a family over all its cells, folds space
/// (paper, section 2: the morph "must be invertible").
struct FoldCheck {
  enum class Verdict {
    kProved,    ///< det J has one sign in all cells
    kFolded,    ///< det J has the other sign at (cell; local)
    kUndecided  ///< the bounds of a part of `cell` around `local` still hold both signs at `depth`
  };
  Verdict verdict = Verdict::kProved;
  /// Whether faces of outer cells are collapsed (Closure): det J is 0 on these, whatever the rest.
  bool collapsed = false;
  Index3 cell{0, 0, 0};
  Eigen::Vector3d local{0, 0, 0};
  int depth = 0;        ///< times the cells were halved at most
  double volume = 0.0;  ///< integral of det J over all cells; negative for mirrored lattices

  /// "proved", "folded at (cell 0 1 0; 0.5, 0, 1)" or "undecided at depth 6 (cell ...)".
  std::string text() const;
};

/// Times that check_folds() halves a cell, unless told otherwise.
constexpr int kFoldDepth = 6;

/// Finds the sign of det J over every cell from its Bernstein coefficients, of degree 8 an axis,
/// which enclose it; parts where they have both signs are halved, up to max_depth times. The bound
/// allows for rounding, so "proved" holds of the exact map of the points as given.
///
/// On a collapsed face det J is zero by construction. There the check is of det J divided by its
/// factor s, 1 - s and so on (squared for the centre of a ball): the map is then invertible
/// everywhere next to the face.
///
/// All threads look at cells (on_threads.hpp), each cell once and a part of one again for each time
/// that it is halved; the answer does not depend on their number. Lattices of many
/// points take seconds: make embed says what a cell takes.
///
/// One sign of det J proves that the map is invertible around every point. It does not see
/// distant parts of a lattice that overlap.
FoldCheck check_folds(const Lattice& lattice, int max_depth = kFoldDepth,
                      const Family& family = {});

}  // namespace hwffd
