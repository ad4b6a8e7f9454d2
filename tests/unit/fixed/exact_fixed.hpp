#pragma once

#include "hwffd/numerics/fixed.hpp"

namespace hwffd::test {

/// A rational number num / 2^bits.
struct Exact {
  Int128 num = 0;
  int bits = 0;
};

struct Rounded {
  Int128 value = 0;
  bool saturated = false;
};

/// The multiple of 2^-fraction nearest to an exact number, ties upward, in a signed word of `width`
/// bits: by division with remainder, the definition itself, and so unlike both RTL and model.
inline Rounded nearest(Exact exact, int fraction, int width) {
  Int128 num = 2 * exact.num;
  Int128 den = 2;
  for (int i = 0; i < fraction; ++i) num *= 2;
  for (int i = 0; i < exact.bits; ++i) {
    if (num % 2 == 0) {
      num /= 2;
    } else {
      den *= 2;
    }
  }
  num += den / 2;
  Int128 quotient = num / den;
  if (num % den < 0) --quotient;
  Int128 limit = 1;
  for (int i = 1; i < width; ++i) limit *= 2;
  if (quotient >= limit) return {limit - 1, true};
  if (quotient < -limit) return {-limit, true};
  return {quotient, false};
}

}  // namespace hwffd::test
