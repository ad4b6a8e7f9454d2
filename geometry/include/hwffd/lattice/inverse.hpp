#pragma once

#include "hwffd/lattice/embedder.hpp"
#include "hwffd/lattice/outside.hpp"

namespace hwffd {

/// The points of the space at rest that a deformation takes to `points`, n x 3, in double: those in
/// the cells of the deformed lattice by embedding them there, others, where points outside follow,
/// by Newton's method on the displacement that Outside gives them.
///
/// NaN where there is none, or none was found. Where there are several, in a lattice that folds
/// space, one of them; in the cells rather than outside.
/// @param rest  of the lattice at rest
/// @throws Error that names the row of a point that is not finite, and what Embedder says of the
///   deformed lattice
Points inverse_of(const Embedder& rest, const Lattice& deformed, const Outside& outside,
                  const Points& points);

}  // namespace hwffd
