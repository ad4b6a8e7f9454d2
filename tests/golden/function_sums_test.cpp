// What a core that takes for granted that functions sum to one finds in the words that the project
// sends: nothing, unless they do not.
#include "hwffd/model/function_sums.hpp"

#include <gtest/gtest.h>

#include <random>

#include "hwffd/model/configuration.hpp"
#include "hwffd/stream/blending.hpp"
#include "hwffd/stream/spans.hpp"
#include "uniform.hpp"

namespace hwffd {
namespace {

/// How many of functions and derivatives of an axis do not sum up.
int faults(const AxisWords& axis) {
  model::FunctionSums sums;
  int count = 0;
  for (const bool derivative : {false, true}) {
    const auto& words = derivative ? axis.derivative.word : axis.word;
    const int shift = derivative ? axis.derivative.shift : axis.shift;
    for (int l = 0; l < 4; ++l) {
      count += sums.fault(l, axis.degree, shift, derivative, words[l]) ? 1 : 0;
    }
  }
  return count;
}

/// fx12 to fx32.
std::vector<WordCodec> codecs() {
  std::vector<WordCodec> result;
  for (int width = 12; width <= 32; ++width) result.emplace_back("fx" + std::to_string(width));
  return result;
}

TEST(FunctionSums, FamiliesSumToOneButHermite) {
  for (const WordCodec& codec : codecs()) {
    for (const char* name : {"bspline", "bernstein", "catmull-rom", "linear", "constant"}) {
      EXPECT_EQ(faults(encode(family(name, codec), codec)), 0) << name;
    }
    EXPECT_EQ(faults(encode(plain_bspline(), codec)), 0);
    EXPECT_EQ(faults(encode(family("hermite", codec), codec)), 2);
  }
}

// De Boor's functions, rounded together or each by itself.
TEST(FunctionSums, SpansOfAnyKnotsSumToOne) {
  std::mt19937_64 random(1);
  int spans = 0;
  for (const WordCodec& codec : codecs()) {
    for (int round = 0; round < 40; ++round) {
      std::vector<double> knots{0};
      while (knots.size() < 24) {
        knots.push_back(knots.back() + (unit(random) < 0.2 ? 0 : 0.05 + unit(random)));
        if (knots.size() > 4 && knots.back() == knots[knots.size() - 5]) knots.back() += 1;
      }
      for (const auto& axes :
           {encode(watertight_spans(knots, codec), codec), encode(knot_spans(knots), codec)}) {
        for (const AxisWords& axis : axes) {
          EXPECT_EQ(faults(axis), 0) << "round " << round;
          ++spans;
        }
      }
    }
  }
  EXPECT_GT(spans, 10000);
}

TEST(FunctionSums, AUsersMatrixOfAnyShift) {
  std::mt19937_64 random(2);
  const WordCodec codec("fx17");
  for (const double size : {0.3, 0.5, 0.9, 1.5}) {
    for (int round = 0; round < 200; ++round) {
      Blending::Matrix matrix{};
      for (int power = 0; power < 4; ++power) {
        double rest = power == 0 ? 1 : 0;
        for (int l = 0; l < 3; ++l) {
          matrix[l][power] = size * (2 * unit(random) - 1);
          rest -= matrix[l][power];
        }
        matrix[3][power] = rest;
      }
      const AxisWords axis = encode(user_blending(matrix), codec);
      EXPECT_EQ(faults(axis), 0) << "size " << size;
      matrix[1][round % 4] += 0x1p-20;
      EXPECT_GT(faults(encode(user_blending(matrix), codec)), 0) << "size " << size;
    }
  }
}

}  // namespace
}  // namespace hwffd
