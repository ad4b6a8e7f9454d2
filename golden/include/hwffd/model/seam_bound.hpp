#pragma once

#include "hwffd/model/configuration.hpp"

namespace hwffd {

/// The unit in which differences at seams are counted, of a component in [-1, 1): a point's in
/// fixed point, 2^-(W-1); 2^-24 in binary32.
double seam_unit(const Configuration& row);

/// How many units a vertex on a face, edge or corner may differ between the cells that share it,
/// with the watertight B-spline and finite points: 0 where the organization is watertight
/// (rtl/organizations.csv, docs/numerics.md section 5).
double seam_bound(const Configuration& row);

}  // namespace hwffd
