#pragma once

#include <optional>

#include "hwffd/model/configuration.hpp"

namespace hwffd {

/// Whether an organization contracts one axis at a time: `factored`, folded or not.
bool contracts(const Configuration& row);

/// Whether an organization works from coefficients of a cell, formed when its first vertex comes:
/// `nested`, folded or not.
bool keeps_cell(const Configuration& row);

/// How often the units of an organization are used for one vertex: 3 for `factored/3` and
/// `nested/3`, else 1.
int folds(const Configuration& row);

/// Clocks of a vertex in the paper's unit times (sections 4.1 to 4.4): 640 for `basic`, 72/E + 320
/// for `cg` with E evaluators, (9 + log2 N) ceil(64/N) for a tree of N units, 15 for `parallel`;
/// with fused multiply-add 384, 36/E + 256, (6 + log2 N) ceil(64/N) and 12. Nothing for an
/// organization that the paper does not have.
std::optional<double> paper_clocks(const Configuration& row);

/// Clocks between vertices when steps overlap: one step a clock, or one every 6 clocks with the
/// iterative evaluator; `cg` no faster than its evaluators fill 12 weights; `factored` and
/// `nested` 1, `factored/3` and `nested/3` 3. Where an organization keeps a cell, between those of
/// one.
double overlapped_interval(const Configuration& row);

/// Clocks between vertices at the row's own schedule. Throws std::bad_optional_access where that is
/// the paper's and the organization is not.
double expected_interval(const Configuration& row);

/// The same between vertices each of which lies in another cell than the one before: longer where
/// an organization keeps a cell, by forming the next one's coefficients.
double scattered_interval(const Configuration& row);

}  // namespace hwffd
