#pragma once

#include <array>
#include <cstddef>

namespace hwffd {

/// The sum of term(0) to term(n - 1) in eight lanes, term i in lane i % 8, which are added two by
/// two: an order that a compiler can do with vectors of any length, and no other.
template <class Term>
double lane_sum(std::size_t n, const Term& term) {
  std::array<double, 8> lanes{};
  std::size_t i = 0;
  for (; i + 8 <= n; i += 8) {
    for (std::size_t lane = 0; lane < 8; ++lane) lanes[lane] += term(i + lane);
  }
  for (std::size_t lane = 0; i < n; ++i, ++lane) lanes[lane] += term(i);
  return ((lanes[0] + lanes[1]) + (lanes[2] + lanes[3])) +
         ((lanes[4] + lanes[5]) + (lanes[6] + lanes[7]));
}

}  // namespace hwffd
