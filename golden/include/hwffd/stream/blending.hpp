#pragma once

#include <array>

#include "hwffd/stream/packets.hpp"
#include "hwffd/stream/word_codec.hpp"

namespace hwffd {

/// Four blending functions of one axis: `coefficient[function][power]` of 1, x, x^2, x^3.
struct Blending {
  std::array<std::array<double, 4>, 4> coefficient{};
  int degree = 3;
};

/// The uniform cubic B-spline with 1/6 rounded once, so that shared faces get the same weights from
/// both cells and the weights sum to 1 (docs/numerics.md section 5): a is the multiple of the
/// weight's unit nearest to 1/6, and in binary32 2796203 * 2^-24.
Blending watertight_bspline(const WordCodec& codec);

/// The uniform cubic B-spline with each coefficient rounded by itself: not watertight in binary32.
Blending plain_bspline();

/// An axis as stream words; the shift is the smallest that fits all coefficients into [-2, 2).
AxisWords encode(const Blending& blending, const WordCodec& codec);

/// The packet that loads the same blending functions for all three axes.
std::vector<Beat> coefficients_packet(const Blending& blending, const WordCodec& codec);

}  // namespace hwffd
