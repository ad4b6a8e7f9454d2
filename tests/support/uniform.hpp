#pragma once

#include <random>

namespace hwffd {

/// Uniform in [0, 1), the same with every standard library.
inline double unit(std::mt19937_64& engine) {
  return static_cast<double>(engine() >> 11) * 0x1p-53;
}

}  // namespace hwffd
