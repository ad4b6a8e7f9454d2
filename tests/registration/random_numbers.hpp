#pragma once

#include <cstdint>
#include <random>

namespace hwffd {

/// Numbers that are the same everywhere.
class RandomNumbers {
 public:
  explicit RandomNumbers(std::uint64_t seed) : source_(seed) {}
  /// From low on, below high.
  double operator()(double low, double high) {
    return low + (high - low) * (static_cast<double>(source_() >> 11) * 0x1p-53);
  }

 private:
  std::mt19937_64 source_;
};

}  // namespace hwffd
