#pragma once

#include <cstdint>
#include <string>

#include "hwffd/numerics/bits.hpp"

namespace hwffd {

/// Doubles to stream words of one number format and back (docs/interface.md section 3).
///
/// Encoding rounds to nearest (ties to even), and clamps to what the word can hold; whether that
/// matters is the caller's to prevent (see `Normalization`). A NaN has a word in binary32 alone:
/// fixed point throws Error.
class WordCodec {
 public:
  /// @param format  a name of `kFormats`: "fp32", "bfp32", or "fx" and the width of a word
  /// @throws UsageError for another, which lists them
  explicit WordCodec(const std::string& format);

  /// Whether coordinates, points and results are binary32 words.
  bool is_float() const { return width_ == 0 || block_; }
  /// Whether the points of a lattice share an exponent.
  bool is_block() const { return block_; }
  /// Whether weights are fixed point, and so coefficients, with a shift.
  bool has_fixed_weights() const { return width_ != 0; }
  /// Fraction bits that a weight and its coefficient's word have both; only of fixed weights.
  int weight_fraction() const { return width_ - 2; }

  std::uint32_t coordinate(double value) const;              ///< binary32 or Q1.31 in [-1/2, 3/2)
  std::uint32_t coefficient(double value, int shift) const;  ///< binary32 or Q2.30, times 2^-shift
  std::uint32_t point(double value) const;                   ///< binary32 or Q1.31
  double decode_coordinate(std::uint32_t word) const;
  /// Of a point, or of a result.
  double decode_point(std::uint32_t word) const {
    return is_float() ? float_of_bits(word) : 0x1p-31 * static_cast<std::int32_t>(word);
  }

 private:
  int width_ = 0;  // of weights, at most that of a word; 0: binary32
  bool block_ = false;
};

}  // namespace hwffd
