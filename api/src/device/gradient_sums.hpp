#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "hwffd/lattice/lattice.hpp"
#include "hwffd/stream/word_codec.hpp"

namespace hwffd {

/// Gradients as words of a scatter core, and the whole numbers that it collects: scaled by one
/// power of two, so that none saturates, added up exactly, and scaled back.
class GradientSums {
 public:
  /// @param format  of the core
  /// @param dims       points an axis of the lattice
  /// @param gradients  which stay until it is gone
  GradientSums(const std::string& format, int width, const Index3& dims, const Points& gradients);

  /// Of the lattice.
  std::size_t points() const { return sums_.size(); }

  /// The words of gradient number v.
  std::array<std::uint32_t, 3> words(std::size_t v) const;
  /// Adds what is collected of a point without a shift, exact.
  void add(std::size_t point, const std::array<std::uint32_t, 3>& collected) {
    for (std::size_t c = 0; c < 3; ++c) {
      sums_[point][c] += static_cast<std::int32_t>(collected[c]);
    }
  }
  /// Adds the sum of a point.
  void add_sum(std::size_t point, const std::array<std::int64_t, 3>& sum) {
    for (std::size_t c = 0; c < 3; ++c) sums_[point][c] += sum[c];
  }
  /// The sums, m x 3.
  Points result() const;

 private:
  WordCodec codec_;
  int width_;
  const Points& gradients_;
  int exponent_;
  std::vector<std::array<std::int64_t, 3>> sums_;
};

}  // namespace hwffd
