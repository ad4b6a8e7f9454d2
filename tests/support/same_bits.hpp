#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <cstring>

namespace hwffd {

/// Whether two matrices have the same shape and the same bits: 0 and -0 differ.
template <typename Matrix>
bool same_bits(const Matrix& a, const Matrix& b) {
  const auto bits = [](double x) {
    std::uint64_t word = 0;
    std::memcpy(&word, &x, sizeof word);
    return word;
  };
  if (a.rows() != b.rows() || a.cols() != b.cols()) return false;
  for (Eigen::Index i = 0; i < a.size(); ++i) {
    if (bits(a.data()[i]) != bits(b.data()[i])) return false;
  }
  return true;
}

}  // namespace hwffd
