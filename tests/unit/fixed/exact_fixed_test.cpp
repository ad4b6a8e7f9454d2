// The references themselves, by hand.
#include "exact_fixed.hpp"

#include <gtest/gtest.h>

#include "../block/exact_block.hpp"

namespace hwffd::test {
namespace {

void expect_rounded(Exact exact, int fraction, int width, int value, bool saturated) {
  const Rounded rounded = nearest(exact, fraction, width);
  EXPECT_EQ(static_cast<int>(rounded.value), value);
  EXPECT_EQ(rounded.saturated, saturated);
}

TEST(ExactFixed, KnownValues) {
  expect_rounded({3, 1}, 0, 8, 2, false);      // 1.5 -> 2
  expect_rounded({-3, 1}, 0, 8, -1, false);    // -1.5 -> -1, ties upward
  expect_rounded({-5, 2}, 0, 8, -1, false);    // -1.25 -> -1
  expect_rounded({5, 2}, 1, 8, 3, false);      // 1.25 -> 1.5 in halves, ties upward
  expect_rounded({255, 1}, 0, 8, 127, true);   // 127.5 -> saturates
  expect_rounded({254, 1}, 0, 8, 127, false);  // 127
  expect_rounded({-257, 1}, 0, 8, -128, false);
  expect_rounded({-258, 1}, 0, 8, -128, true);
  expect_rounded({1, 0}, 6, 8, 64, false);  // 1.0 in Q2.6
}

TEST(ExactBlock, KnownRoundings) {
  EXPECT_EQ(rounded_binary32(1, 0), 0x3F800000U);
  EXPECT_EQ(rounded_binary32(-3, -1), 0xBFC00000U);
  EXPECT_EQ(rounded_binary32((Int128{1} << 25) + 2, 0), 0x4C000000U) << "a tie to even, down";
  EXPECT_EQ(rounded_binary32((Int128{1} << 25) + 6, 0), 0x4C000002U) << "a tie to even, up";
  EXPECT_EQ(rounded_binary32((Int128{1} << 24) - 1, 104), 0x7F7FFFFFU);
  EXPECT_EQ(rounded_binary32((Int128{1} << 25) - 1, 103), 0x7F800000U);
  EXPECT_EQ(rounded_binary32(1, -149), 1U);
  EXPECT_EQ(rounded_binary32(1, -150), 0U) << "half the least subnormal, a tie to even";
  EXPECT_EQ(rounded_binary32(-3, -151), 0x80000001U);
  EXPECT_EQ(rounded_binary32(0xFFFFFF, -150), 0x00800000U) << "the largest subnormal, and a half";
}

}  // namespace
}  // namespace hwffd::test
