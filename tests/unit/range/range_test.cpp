// ffd_num_range and its model against what the words mean: IEEE-754 fields, or units of 2^-31.
#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <optional>

#include "Vnum_range_0.h"
#include "Vnum_range_18.h"
#include "Vnum_range_99.h"
#include "hwffd/numerics/binary32.hpp"
#include "hwffd/numerics/block.hpp"
#include "hwffd/numerics/fixed.hpp"
#include "hwffd/tb/random.hpp"

namespace hwffd::test {
namespace {

/// The value of a word; nothing where it is no finite number.
std::optional<double> binary32_value(std::uint32_t word) {
  const int exponent = static_cast<int>(word >> 23 & 0xFF);
  const double fraction = word & 0x7FFFFF;
  if (exponent == 255) return std::nullopt;
  const double magnitude =
      exponent == 0 ? std::ldexp(fraction, -149) : std::ldexp(fraction + 0x800000, exponent - 150);
  return word >> 31 != 0 ? -magnitude : magnitude;
}

/// Words count units of 2^-31 modulo 2^32, from -1/2 on, so that a step below 0 is below 0.
std::optional<double> fixed_value(std::uint32_t word) {
  const double units = word;
  return std::ldexp(word < 0xC0000000U ? units : units - 0x1p32, -31);
}

using ValueOf = std::optional<double> (*)(std::uint32_t);

template <class Dut, class Format>
void expect_range(Dut& dut, std::uint32_t word, std::uint32_t one, ValueOf value_of) {
  dut.word_i = word;
  dut.eval();
  const std::optional<double> value = value_of(word);
  const bool below = value && *value < 0;
  const bool above = value && *value > 1;
  const CoordinateRange model = Format::range(word);
  ASSERT_EQ(dut.nan_o != 0, !value) << std::hex << word;
  ASSERT_EQ(dut.outside_o != 0, above || below) << std::hex << word;
  ASSERT_EQ(model.nan, !value) << std::hex << word;
  ASSERT_EQ(model.outside, above || below) << std::hex << word;
  if (!value) return;
  ASSERT_EQ(dut.clamped_o, above ? one : below ? 0 : word) << std::hex << word;
  ASSERT_EQ(model.clamped, dut.clamped_o) << std::hex << word;
}

template <class Dut, class Format>
void expect_ranges(std::uint32_t one, ValueOf value_of) {
  ASSERT_EQ(value_of(one), 1.0);
  Dut dut;
  for (const std::uint32_t corner : {0x00000000U, one, 0x80000000U, 0x7F800000U, 0xFF800000U,
                                     0x7FFFFFFFU, 0xBF800000U, 0xC0000000U}) {
    for (std::uint32_t near = 0; near < 2048; ++near)
      expect_range<Dut, Format>(dut, corner - 1024 + near, one, value_of);
  }
  tb::Random random(1);
  for (int i = 0; i < 1000000; ++i) expect_range<Dut, Format>(dut, random.word(), one, value_of);
}

TEST(Range, Binary32) { expect_ranges<Vnum_range_0, Binary32>(0x3F800000U, binary32_value); }

TEST(Range, Block) { expect_ranges<Vnum_range_99, Block32>(0x3F800000U, binary32_value); }

TEST(Range, Fixed) { expect_ranges<Vnum_range_18, Fixed<18>>(0x80000000U, fixed_value); }

}  // namespace
}  // namespace hwffd::test
