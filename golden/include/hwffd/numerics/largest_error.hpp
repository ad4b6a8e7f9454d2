#pragma once

#include <algorithm>
#include <cmath>
#include <limits>

namespace hwffd {

/// Raises the largest error so far to another one. One that is not a number counts as infinite, so
/// that no bound holds of it.
inline void raise_to(double& largest, double error) {
  largest = std::isnan(error) ? std::numeric_limits<double>::infinity() : std::max(largest, error);
}

}  // namespace hwffd
