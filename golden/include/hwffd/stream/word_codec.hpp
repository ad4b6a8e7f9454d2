#pragma once

#include <cstdint>
#include <string>

namespace hwffd {

/// Doubles to stream words of one number format and back (docs/interface.md section 3).
///
/// Encoding rounds to nearest (ties to even), and clamps to what the word can hold; whether that
/// matters is the caller's to prevent (see `Normalization`).
class WordCodec {
 public:
  /// @param format  "fp32", or "fx" and the width of a word
  explicit WordCodec(const std::string& format);

  bool is_float() const { return width_ == 0; }
  /// Fraction bits of a weight; only where `is_float()` is false.
  int weight_fraction() const { return width_ - 2; }

  std::uint32_t coordinate(double value) const;              ///< unsigned Q1.31
  std::uint32_t coefficient(double value, int shift) const;  ///< Q2.30, times 2^-shift
  std::uint32_t point(double value) const;                   ///< Q1.31
  double decode_coordinate(std::uint32_t word) const;
  double decode_point(std::uint32_t word) const;  ///< of a point, or of a result

 private:
  int width_ = 0;  // 0: binary32
};

}  // namespace hwffd
