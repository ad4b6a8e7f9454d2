// What a word of the stream can hold, and what becomes of values that it cannot.
#include "hwffd/stream/word_codec.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "hwffd/error.hpp"
#include "hwffd/numerics/binary32.hpp"
#include "hwffd/numerics/fixed.hpp"

namespace hwffd {
namespace {

/// The word of a coordinate outside [0, 1] means outside, however far, and the nearest face.
template <class Format>
void expect_faces(const WordCodec& codec) {
  for (const double distance : {0x1p-24, 0.25, 0.49, 0.5, 0.75, 1.0, 3.0, 1e30, 1e300}) {
    const CoordinateRange below = Format::range(codec.coordinate(-distance));
    const CoordinateRange above = Format::range(codec.coordinate(1 + 2 * distance));
    if (below.nan || above.nan) continue;  // binary32 has infinities
    EXPECT_TRUE(below.outside && above.outside) << distance;
    EXPECT_EQ(below.clamped, codec.coordinate(0)) << distance;
    EXPECT_EQ(above.clamped, codec.coordinate(1)) << distance;
  }
}

TEST(WordCodec, CoordinatesOutsideKeepTheirSide) {
  expect_faces<Binary32>(WordCodec("fp32"));
  expect_faces<Fixed<18>>(WordCodec("fx18"));
}

TEST(WordCodec, CoordinatesComeBack) {
  const WordCodec codec("fx18");
  for (double value = -0.5; value < 1.5; value += 0x1p-9) {
    EXPECT_EQ(codec.decode_coordinate(codec.coordinate(value)), value);
  }
  for (const double step : {-0x1p-31, 0x1p-31, 1 - 0x1p-31, 1 + 0x1p-31}) {
    EXPECT_EQ(codec.decode_coordinate(codec.coordinate(step)), step);
  }
}

TEST(WordCodec, FixedPointHasNoWordForNan) {
  const WordCodec codec("fx18");
  EXPECT_THROW(codec.point(NAN), Error);
  EXPECT_THROW(codec.coordinate(NAN), Error);
  EXPECT_THROW(codec.coefficient(NAN, 0), Error);
  EXPECT_EQ(codec.point(HUGE_VAL), 0x7FFFFFFFU);
  EXPECT_EQ(WordCodec("fp32").point(NAN) & 0x7F800000U, 0x7F800000U);
}

}  // namespace
}  // namespace hwffd
