#pragma once

namespace hwffd {

/// binom(n, k): of x^n in powers of 2x - 1, times 2^n (docs/numerics.md section 4).
inline constexpr int kBinomial[4][4] = {{1, 0, 0, 0}, {1, 1, 0, 0}, {1, 2, 1, 0}, {1, 3, 3, 1}};

}  // namespace hwffd
