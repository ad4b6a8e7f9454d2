#pragma once

#include <cstdint>
#include <vector>

#include "hwffd/lattice/attachment.hpp"

namespace hwffd {

/// A sparse matrix row by row (CSR): row r has values[i] in column columns[i] for i from starts[r]
/// to starts[r + 1] - 1, columns ascending.
struct SparseRows {
  std::vector<std::int64_t> starts;   ///< one more than rows
  std::vector<std::int32_t> columns;  ///< control points (Lattice::index)
  std::vector<double> values;
};

/// The weights W of the control points in attached points: where P are the control points of the
/// deformed lattice, m x 3, the points are W P + unmoved_part(), n x 3. A point inside has 64
/// weights, B_l(s) B_m(t) B_n(u); one outside that follows (Outside) has those of its place times
/// its part of the displacement; one that stays has none.
SparseRows weights_of(const Attachment& attachment);
/// How many there are.
std::size_t weight_count(const Attachment& attachment);

/// What does not move with the control points, n x 3: zero for points inside, the point itself for
/// one that stays.
Points unmoved_part(const Attachment& attachment);

/// W^T G, m x 3, without W in memory: where G is the gradient of a number with respect to the
/// points, n x 3, this is its gradient with respect to the control points.
/// @throws Error for another number of rows
Points pull_back(const Attachment& attachment, const Points& gradient);

}  // namespace hwffd
