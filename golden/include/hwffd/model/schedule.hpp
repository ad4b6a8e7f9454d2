#pragma once

#include <optional>

#include "hwffd/model/configuration.hpp"

namespace hwffd {

// Clocks are the formulas of rtl/organizations.csv; docs/architecture.md section 4 derives them.

/// Whether an organization contracts one axis at a time.
bool contracts(const Configuration& row);

/// How often the units of an organization are used for one vertex.
int folds(const Configuration& row);

/// How many vertices an organization evaluates side by side, in as many folded lanes.
int lanes(const Configuration& row);

/// Whether an organization gives the position of a vertex and its three derivatives in one pass.
bool gives_jacobian(const Configuration& row);

/// Whether it evaluates a vertex a clock along rows in which only s and the cell along s change.
/// Four clocks bring it a plane of control points, of which a row wants three more than it has
/// cells.
bool walks(const Configuration& row);

/// Whether it takes two such vertices of one cell at once.
bool pairs(const Configuration& row);

/// Clocks of a vertex in the paper's unit times (sections 4.1 to 4.4). Nothing for an organization
/// that the paper does not have.
std::optional<double> paper_clocks(const Configuration& row);

/// Clocks of a vertex's last accumulation, which `paper_clocks` does not count since it is hidden
/// under the next vertex. Nothing where that has nothing.
std::optional<double> last_accumulation(const Configuration& row);

/// Clocks between vertices when steps overlap.
double overlapped_interval(const Configuration& row);

/// Clocks between vertices at the row's own schedule. Throws std::bad_optional_access where that is
/// the paper's and the organization is not.
double expected_interval(const Configuration& row);

}  // namespace hwffd
