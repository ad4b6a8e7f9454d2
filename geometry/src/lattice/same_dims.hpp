#pragma once

#include <fmt/format.h>

#include "hwffd/error.hpp"
#include "hwffd/points.hpp"

namespace hwffd {

/// Throws Error, which begins with `what`, unless a lattice has the dimensions of another.
inline void check_same_dims(const char* what, const Index3& dims, const Index3& wanted) {
  if (dims == wanted) return;
  throw Error(fmt::format("{} has {} x {} x {} points; give {} x {} x {}", what, dims[0], dims[1],
                          dims[2], wanted[0], wanted[1], wanted[2]));
}

}  // namespace hwffd
