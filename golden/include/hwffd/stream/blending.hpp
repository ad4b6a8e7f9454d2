#pragma once

#include <array>
#include <string>
#include <vector>

#include "hwffd/stream/packets.hpp"
#include "hwffd/stream/word_codec.hpp"

namespace hwffd {

/// Four blending functions of one axis: `coefficient[function][power]` of 1, x, x^2, x^3.
struct Blending {
  using Matrix = std::array<std::array<double, 4>, 4>;
  Matrix coefficient{};
  int degree = 3;
  /// Of the functions' derivatives, as many. That of the B-spline is exact, also where the
  /// functions have 1/6 rounded (docs/numerics.md section 9).
  Matrix derivative{};
};

/// The derivatives of functions that are given by their coefficients.
Blending::Matrix differentiated(const Blending::Matrix& coefficient);

/// The families that `family` knows: bspline, bernstein, hermite, catmull-rom, linear, constant.
const std::vector<std::string>& family_names();

/// A family by name, ready for `encode` (docs/numerics.md section 8):
/// - bspline: the uniform cubic B-spline, watertight
/// - bernstein: Bernstein polynomials of degree 3, points P0 .. P3 of a Bezier segment
/// - hermite: cubic, in the order P0, T0, P1, T1: a point with its tangent, then the other end
/// - catmull-rom: the cubic through its two middle points
/// - linear: degree 1, between the two middle points
/// - constant: degree 0, the first point alone; switches an axis off
/// Throws UsageError, which lists the names.
Blending family(const std::string& name, const WordCodec& codec);

/// Blending functions of a user's own: row l of the matrix is function l, its columns are the
/// coefficients of 1, x, x^2, x^3. The degree is the highest power that occurs.
Blending user_blending(const Blending::Matrix& matrix);

/// The uniform cubic B-spline with 1/6 rounded once, so that shared faces get the same weights from
/// both cells and the weights sum to 1 (docs/numerics.md section 5): a is the multiple of the
/// weight's unit nearest to 1/6 (of its word's, where that has fewer bits), and in binary32
/// 2796203 * 2^-24.
Blending watertight_bspline(const WordCodec& codec);

/// The uniform cubic B-spline with each coefficient rounded by itself: not watertight in binary32.
Blending plain_bspline();

/// The largest magnitude of the coefficients and of all intermediate values of Horner's rule for x
/// in [0, 1]: what must lie below 2^(1 + shift) in fixed point.
double horner_magnitude(const Blending& blending);

/// The smallest r >= 0 with sum_l |B_l'(x)| <= 2^r over x in [0, 1]: points in [-1, 1) have
/// derivatives along such an axis in [-2^r, 2^r).
int derivative_exponent(const Blending& blending);

/// An axis as stream words. The shift is the smallest, 0 to 3, that fits coefficients and Horner's
/// intermediate values into [-2, 2); what does not fit with 3 saturates in the core. In fixed point
/// derivatives are stored times 2^-r as well, r from derivative_exponent().
AxisWords encode(const Blending& blending, const WordCodec& codec);

/// The same with a larger r, as of an axis whose other cells have steeper functions.
AxisWords encode(const Blending& blending, const WordCodec& codec, int exponent);

/// The packet that loads the same blending functions for all three axes.
std::vector<Beat> coefficients_packet(const Blending& blending, const WordCodec& codec,
                                      Functions functions = Functions::kBlending);

/// The packet that loads blending functions of their own for s, t and u.
std::vector<Beat> coefficients_packet(const std::array<Blending, 3>& axes, const WordCodec& codec,
                                      Functions functions = Functions::kBlending);

/// The weights of an axis as the bit-true model computes them, exact in double.
/// @param format      "fp32", "bfp32", or "fx" and the width of a word
/// @param coordinate  a coordinate's stream word
/// @param fused       fused multiply-add; binary32 only
std::array<double, 4> weights(const AxisWords& axis, const std::string& format,
                              std::uint32_t coordinate, bool fused = false);

/// Whether both sides of a face that two neighbouring cells share get the same weights, in the
/// model's own arithmetic: at x = 1 the lower cell gives point l + stride what the upper one gives
/// point l at x = 0, and points that only one of them sees get 0.
/// @param stride  control points from one cell to the next, 1 to 3: 1 in a lattice of
///                B-splines, 2 between Hermite cells (a point and its tangent), 3 between Bezier
///                cells
bool is_watertight(const AxisWords& axis, const std::string& format, int stride = 1,
                   bool fused = false);

}  // namespace hwffd
