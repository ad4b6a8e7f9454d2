#pragma once

#include <array>
#include <cstdint>
#include <cstdio>
#include <string>

#include "../block/exact_block.hpp"
#include "exact_fixed.hpp"
#include "hwffd/numerics/block.hpp"

namespace hwffd::test {

template <class F>
inline constexpr bool kBlock = false;
template <int W>
inline constexpr bool kBlock<Block<W>> = true;
template <class F>
inline constexpr int kWidth = F::kWeightFraction + 2;

/// A number with its flags, as the exact arithmetic has it; in fixed point all are finite.
struct Value {
  Int128 value = 0;
  bool saturated = false;
  Class kind = Class::kFinite;
};

struct Operands {
  std::uint32_t word = 0;
  int exponent = 0;
  Value a, b, c;  ///< weights
  Value factor;   ///< a point
  Value sum_a, sum_b;
  int shift = 0;
};

inline constexpr std::size_t kUnits = 10;
using Results = std::array<Int128, kUnits>;

/// {minus, plus, saturated} above two's complement of `width` bits.
inline Int128 packed(const Value& v, int width) {
  const bool plus = v.kind == Class::kPlus || v.kind == Class::kNan;
  const bool minus = v.kind == Class::kMinus || v.kind == Class::kNan;
  const int flags = (minus ? 4 : 0) | (plus ? 2 : 0) | (v.saturated ? 1 : 0);
  return (v.value & ((Int128{1} << width) - 1)) | Int128{flags} << width;
}
inline Int128 packed(Rounded r, bool flag, int width, Class kind = Class::kFinite) {
  return packed({r.value, r.saturated || flag, kind}, width);
}
/// {NaN, saturated, word}
inline Int128 packed_out(std::uint32_t word, bool saturated, bool nan) {
  return Int128{word} | Int128{saturated ? 1 : 0} << 32 | Int128{nan ? 1 : 0} << 33;
}

/// A word of up to 128 bits, as it is printed where a comparison fails.
inline std::string hex(Int128 value) {
  char buffer[40];
  std::snprintf(buffer, sizeof buffer, "%llx_%016llx", static_cast<unsigned long long>(value >> 64),
                static_cast<unsigned long long>(value));
  return buffer;
}

template <class F>
Value exact_coordinate(std::uint32_t word) {
  constexpr int W = kWidth<F>;
  if constexpr (kBlock<F>) {
    const FloatFields fields = float_fields(word);
    const Int128 one = Int128{1} << (W - 2);
    if (fields.kind != Class::kFinite) return {fields.negative ? 0 : one, true};
    if (fields.negative) return {0, fields.significand != 0};
    const bool above = word > 0x3F800000U;
    return {above ? one : aligned(fields, W - 2, 64).value, above};
  } else {
    const bool below = word >= 0xC0000000U;
    const bool outside = word > 0x80000000U;
    const Exact exact{below ? 0 : outside ? Int128{0x80000000U} : Int128{word}, 31};
    return {nearest(exact, W - 2, W).value, outside};
  }
}

template <class F>
Int128 exact_point(const Operands& o) {
  constexpr int W = kWidth<F>;
  if constexpr (kBlock<F>) {
    const FloatFields fields = float_fields(o.word);
    if (fields.kind != Class::kFinite) return packed({0, false, fields.kind}, W);
    return packed(aligned(fields, W - 1 - o.exponent, W), false, W);
  } else {
    return packed(nearest({static_cast<std::int32_t>(o.word), 31}, W - 1, W), false, W);
  }
}

template <class F>
Int128 exact_out(const Value& sum, int exponent) {
  constexpr int W = kWidth<F>;
  if constexpr (kBlock<F>) {
    static constexpr std::uint32_t kSpecial[] = {0, 0x7F800000U, 0xFF800000U, 0x7FC00000U};
    const std::uint32_t word = sum.kind == Class::kFinite
                                   ? rounded_binary32(sum.value, exponent - (2 * W - 3))
                                   : kSpecial[static_cast<std::size_t>(sum.kind)];
    return packed_out(word, sum.saturated, sum.kind == Class::kNan);
  } else {
    return packed(nearest({sum.value, 2 * W - 3}, 31, 32), sum.saturated, 32);
  }
}

template <class F>
Results exact_results(const Operands& o) {
  constexpr int W = kWidth<F>, kF = W - 2, kSum = 2 * W + 6;
  const bool flag_ab = o.a.saturated || o.b.saturated;
  const Int128 product = o.a.value * o.b.value;
  const Int128 one = Int128{1} << kF;
  const Value coordinate = exact_coordinate<F>(o.word);
  const Value term{o.a.value * o.factor.value, o.a.saturated || o.factor.saturated,
                   product_class(o.a.value, o.factor.kind)};
  const Value sum{o.sum_a.value + o.sum_b.value, o.sum_a.saturated || o.sum_b.saturated,
                  sum_class(o.sum_a.kind, o.sum_b.kind)};
  const auto weight = [](Int128 num, int bits, bool flag) {
    return packed(nearest({num, bits}, kF, W), flag, W);
  };
  const auto point = [&](Int128 num, int bits) {
    return packed(nearest({num, bits}, W - 1, W), o.sum_a.saturated, W, o.sum_a.kind);
  };
  return {packed(coordinate, W),
          weight(static_cast<std::int32_t>(o.word), 30, false),
          exact_point<F>(o),
          weight(product, 2 * kF, flag_ab),
          packed(term, kSum),
          weight(o.c.value * one + product, 2 * kF, flag_ab || o.c.saturated),
          weight(o.a.value * (1 << o.shift), kF, o.a.saturated),
          packed(sum, kSum),
          point(o.sum_a.value, 2 * W - 3),
          exact_out<F>(o.sum_a, o.exponent)};
}

}  // namespace hwffd::test
