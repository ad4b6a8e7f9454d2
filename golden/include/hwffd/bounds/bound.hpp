#pragma once

#include "hwffd/bounds/axis_error.hpp"

namespace hwffd::bounds {

/// Proved bounds of the product form ((B_l B_m) B_n) P, for points of magnitude at most 1, from
/// what is proved of one axis (docs/numerics.md section 7). The error of a component, absolute.
double fixed_product_bound(int width, const AxisError& axis);

/// The same of `factored`, which contracts an axis at a time and narrows between.
double fixed_factored_bound(int width, const AxisError& axis);

/// Block floating point: the same of both forms, in ulp of the largest magnitude of a lattice's
/// control points, where the exponent is theirs (docs/numerics.md section 10).
double block_product_bound(int width, const AxisError& axis);
double block_factored_bound(int width, const AxisError& axis);

/// That of the product form in binary32 for sums of n = 1 (one after the other) or n = 64 terms (a
/// tree).
double binary32_product_bound(int n, bool fused);

}  // namespace hwffd::bounds
