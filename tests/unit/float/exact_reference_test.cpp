// The exact reference, before it judges anything: by hand, by a search for the nearest word, and by
// the host's conversion to binary16.
#include "exact_reference.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <iostream>
#include <limits>
#include <random>
#include <vector>

namespace hwffd::exact {
namespace {

constexpr Format kE5f2{5, 3};
constexpr Format kBinary16{5, 11};

std::uint32_t add16(std::uint32_t a, std::uint32_t b) {
  return add(kBinary16, decode(kBinary16, a), decode(kBinary16, b));
}
std::uint32_t mul16(std::uint32_t a, std::uint32_t b) {
  return mul(kBinary16, decode(kBinary16, a), decode(kBinary16, b));
}
std::uint32_t fma16(std::uint32_t a, std::uint32_t b, std::uint32_t c) {
  return fma(kBinary16, decode(kBinary16, a), decode(kBinary16, b), decode(kBinary16, c));
}

/// The value of a finite word, by the definition of the format and not by integers.
double value(Format format, std::uint32_t word) {
  const int field = static_cast<int>(word >> format.fraction_bits()) & format.largest_field();
  const double fraction =
      std::ldexp(word & ((1u << format.fraction_bits()) - 1), -format.fraction_bits());
  const double magnitude = field == 0 ? std::ldexp(fraction, 1 - format.bias())
                                      : std::ldexp(1 + fraction, field - format.bias());
  return (word & format.sign()) != 0 ? -magnitude : magnitude;
}

/// The word nearest to an exact value: neighbours by search, the even one of two equally near. The
/// infinity stands where the next binade would begin, as rounding "as if unbounded" wants it.
std::uint32_t nearest(Format format, double exact) {
  const std::uint32_t sign = exact < 0 ? format.sign() : 0;
  const double magnitude = std::fabs(exact);
  std::uint32_t low = 0;
  while (low < format.infinity() && value(format, low + 1) <= magnitude) ++low;
  if (low >= format.infinity()) return sign | format.infinity();
  const double below = magnitude - value(format, low);
  const double above = value(format, low + 1) - magnitude;
  const std::uint32_t word = below < above || (below == above && low % 2 == 0) ? low : low + 1;
  return word == 0 ? 0 : sign | word;
}

/// The sum a + b in double, if it is exact (by the two-sum error term).
bool exact_sum(double a, double b, double& sum) {
  sum = a + b;
  const double from_b = sum - a;
  return (a - (sum - from_b)) + (b - from_b) == 0;
}

TEST(floatReference, HandValues) {
  EXPECT_EQ(add16(0x3c00, 0x3c00), 0x4000u);          // 1 + 1 = 2
  EXPECT_EQ(add16(0x3c00, 0xbc00), 0x0000u);          // 1 - 1 = +0
  EXPECT_EQ(add16(0x8000, 0x8000), 0x0000u);          // -0 + -0 = +0 here
  EXPECT_EQ(add16(0x3c00, 0x1000), 0x3c00u);          // 1 + 2^-11, a tie to even
  EXPECT_EQ(add16(0x3c01, 0x1000), 0x3c02u);          // 1 + 2^-10 + 2^-11, a tie to even
  EXPECT_EQ(add16(0x3c00, 0x1001), 0x3c01u);          // just above a tie
  EXPECT_EQ(add16(0x03ff, 0x0001), 0x0400u);          // subnormal to normal
  EXPECT_EQ(add16(0x7bff, 0x4bff), 0x7bffu);          // 65504 + 15.99
  EXPECT_EQ(add16(0x7bff, 0x4c00), 0x7c00u);          // 65504 + 16, a tie to infinity
  EXPECT_EQ(add16(0x7c00, 0xfc00), 0x7e00u);          // inf - inf
  EXPECT_EQ(add16(0xfc00, 0x7bff), 0xfc00u);          // -inf + finite
  EXPECT_EQ(add16(0xfe01, 0x0000), 0x7e00u);          // any NaN
  EXPECT_EQ(mul16(0x3e00, 0xbe00), 0xc080u);          // 1.5 * -1.5 = -2.25
  EXPECT_EQ(mul16(0x0001, 0x3800), 0x0000u);          // half a subnormal, a tie to zero
  EXPECT_EQ(mul16(0x0001, 0xb800), 0x0000u);          // -> +0
  EXPECT_EQ(mul16(0x0003, 0xb800), 0x8002u);          // 1.5 subnormals, a tie to even
  EXPECT_EQ(mul16(0x7bff, 0x4000), 0x7c00u);          // overflow
  EXPECT_EQ(mul16(0x7c00, 0x0000), 0x7e00u);          // inf * 0
  EXPECT_EQ(mul16(0x7c00, 0x8001), 0xfc00u);          // inf * negative
  EXPECT_EQ(fma16(0x3c01, 0x3c01, 0xbc02), 0x0010u);  // (1 + 2^-10)^2 - (1 + 2^-9) = 2^-20
  EXPECT_EQ(fma16(0x7bff, 0x4000, 0xfbff), 0x7bffu);  // 2 * max - max = max
  EXPECT_EQ(fma16(0x7c00, 0x0000, 0x7e00), 0x7e00u);
  EXPECT_EQ(fma16(0x7c00, 0x3c00, 0xfc00), 0x7e00u);
  EXPECT_EQ(fma16(0x7bff, 0x7bff, 0xfc00), 0xfc00u);
}

TEST(floatReference, NearestOfAllPairs) {
  std::uint64_t checked = 0;
  for (std::uint32_t a = 0; a < 256; ++a) {
    for (std::uint32_t b = 0; b < 256; ++b) {
      const Number x = decode(kE5f2, a);
      const Number y = decode(kE5f2, b);
      if (x.kind != Kind::kFinite || y.kind != Kind::kFinite) continue;
      ASSERT_EQ(add(kE5f2, x, y), nearest(kE5f2, value(kE5f2, a) + value(kE5f2, b)))
          << std::hex << a << " + " << b;
      ASSERT_EQ(mul(kE5f2, x, y), nearest(kE5f2, value(kE5f2, a) * value(kE5f2, b)))
          << std::hex << a << " * " << b;
      ++checked;
    }
  }
  std::cout << checked << " pairs\n";
  EXPECT_EQ(checked, 248u * 248u);
}

TEST(floatReference, NearestOfTriples) {
  std::mt19937_64 random(1);
  std::uint64_t checked = 0;
  for (int i = 0; i < 300000; ++i) {
    const std::uint64_t draw = random();
    const std::uint32_t a = draw & 255;
    const std::uint32_t b = draw >> 8 & 255;
    const std::uint32_t c = draw >> 16 & 255;
    const Number x = decode(kE5f2, a);
    const Number y = decode(kE5f2, b);
    const Number z = decode(kE5f2, c);
    if (x.kind != Kind::kFinite || y.kind != Kind::kFinite || z.kind != Kind::kFinite) continue;
    double sum;
    if (!exact_sum(value(kE5f2, a) * value(kE5f2, b), value(kE5f2, c), sum)) continue;
    ASSERT_EQ(fma(kE5f2, x, y, z), nearest(kE5f2, sum))
        << std::hex << a << " * " << b << " + " << c;
    ++checked;
  }
  std::cout << checked << " triples\n";
  EXPECT_GT(checked, 200000u);
}

#ifdef __FLT16_MANT_DIG__
TEST(floatReference, HostBinary16) {
  std::mt19937_64 random(2);
  const auto host = [](double exact) {
    const auto half = static_cast<_Float16>(exact);
    std::uint16_t word;
    std::memcpy(&word, &half, sizeof word);
    return static_cast<std::uint32_t>(word == 0x8000 ? 0 : word);
  };
  std::uint64_t checked = 0;
  while (checked < 1000000) {
    const std::uint64_t draw = random();
    const std::uint32_t a = draw & 0xffff;
    const std::uint32_t b = draw >> 16 & 0xffff;
    const Number x = decode(kBinary16, a);
    const Number y = decode(kBinary16, b);
    if (x.kind != Kind::kFinite || y.kind != Kind::kFinite) continue;
    // Sums (41 bits) and products (22 bits) of binary16 are exact in double: one rounding.
    ASSERT_EQ(add(kBinary16, x, y), host(value(kBinary16, a) + value(kBinary16, b)))
        << std::hex << a << " + " << b;
    ASSERT_EQ(mul(kBinary16, x, y), host(value(kBinary16, a) * value(kBinary16, b)))
        << std::hex << a << " * " << b;
    ++checked;
  }
  std::cout << checked << " pairs\n";
}
#endif

}  // namespace
}  // namespace hwffd::exact
