// The families of blending functions: what docs/numerics.md section 8 says of each of them.
#include "hwffd/stream/blending.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <ostream>
#include <random>

#include "hwffd/error.hpp"
#include "hwffd/oracle/oracle.hpp"
#include "named.hpp"
#include "random_vertex.hpp"

namespace hwffd {
namespace {

const std::vector<std::string>& all_formats() {
  static const std::vector<std::string> formats = [] {
    std::vector<std::string> names{"fp32", "bfp32"};
    for (int width = 12; width <= 32; ++width) names.push_back("fx" + std::to_string(width));
    return names;
  }();
  return formats;
}

/// A row of the table in docs/numerics.md section 8.
struct Facts {
  const char* name;
  double lowest;     ///< weight on [0, 1]
  double highest;    ///< weight on [0, 1]
  double magnitude;  ///< of coefficients and Horner's intermediate values
  int shift;         ///< in fixed point
  bool unity;        ///< the four weights sum to 1
  int stride;        ///< at which neighbouring cells join, 0: at none
};

constexpr std::array<Facts, 6> kFacts{{
    {"bspline", 0, 2.0 / 3, 1, 0, true, 1},
    {"bernstein", 0, 1, 6, 2, true, 3},
    {"hermite", -4.0 / 27, 1, 3, 1, false, 2},
    {"catmull-rom", -2.0 / 27, 1, 2.5, 1, true, 1},
    {"linear", 0, 1, 1, 0, true, 1},
    {"constant", 0, 1, 1, 0, true, 0},
}};

void PrintTo(const Facts& facts, std::ostream* out) { *out << facts.name; }

class Family : public ::testing::TestWithParam<Facts> {};

TEST_P(Family, CoefficientsAreThoseOfTheOracle) {
  const auto expected = Oracle::family(GetParam().name);
  int checked = 0;
  for (const std::string& format : all_formats()) {
    const WordCodec codec(format);
    const Blending blending = family(GetParam().name, codec);
    // Only the B-spline has coefficients that are not exact: 3 times half a unit of its sixth.
    const bool exact = std::string(GetParam().name) != "bspline";
    const int fraction = codec.has_fixed_weights() ? codec.weight_fraction() : 24;
    for (int l = 0; l < 4; ++l) {
      for (int power = 0; power < 4; ++power, ++checked) {
        EXPECT_NEAR(blending.coefficient[l][power], expected(l, power),
                    exact ? 0.0 : std::ldexp(1.5, -fraction))
            << format << " " << l << " " << power;
        EXPECT_TRUE(power <= blending.degree || expected(l, power) == 0);
      }
    }
  }
  EXPECT_EQ(checked, 23 * 16);
}

TEST_P(Family, RangeUnityMagnitudeAndShift) {
  constexpr int kSteps = 27 * 4096;  // the extremes of Hermite and Catmull-Rom lie on thirds
  const Oracle oracle(Oracle::family(GetParam().name));
  const Blending blending = family(GetParam().name, WordCodec("fp32"));
  double lowest = 1;
  double highest = 0;
  double off = 0;
  double magnitude = 0;
  for (int i = 0; i <= kSteps; ++i) {
    const double x = static_cast<double>(i) / kSteps;
    const Eigen::Vector4d b = oracle.blending(Oracle::kS, x);
    lowest = std::min(lowest, b.minCoeff());
    highest = std::max(highest, b.maxCoeff());
    off = std::max(off, std::abs(b.sum() - 1));
    for (const auto& c : blending.coefficient) {
      double w = c[3];
      magnitude = std::max(magnitude, std::abs(w));
      for (int power = 2; power >= 0; --power) {
        w = c[power] + x * w;
        magnitude = std::max({magnitude, std::abs(w), std::abs(c[power])});
      }
    }
  }
  EXPECT_NEAR(lowest, GetParam().lowest, 1e-12);
  EXPECT_NEAR(highest, GetParam().highest, 1e-12);
  EXPECT_EQ(off < 1e-12, GetParam().unity) << off;
  EXPECT_NEAR(magnitude, GetParam().magnitude, 1e-6);
  EXPECT_NEAR(horner_magnitude(blending), magnitude, 1e-9);
  int formats = 0;
  for (const std::string& format : all_formats()) {
    const WordCodec codec(format);
    const AxisWords axis = encode(family(GetParam().name, codec), codec);
    EXPECT_EQ(axis.shift, codec.has_fixed_weights() ? GetParam().shift : 0) << format;
    EXPECT_EQ(axis.degree, blending.degree) << format;
    ++formats;
  }
  EXPECT_EQ(formats, 23);
}

TEST_P(Family, WatertightAtItsStrideInEveryFormat) {
  int checked = 0;
  for (const std::string& format : all_formats()) {
    const WordCodec codec(format);
    const AxisWords axis = encode(family(GetParam().name, codec), codec);
    for (const bool fused : {false, true}) {
      if (fused && codec.has_fixed_weights()) continue;
      for (int stride = 1; stride <= 3; ++stride, ++checked) {
        EXPECT_EQ(is_watertight(axis, format, stride, fused), stride == GetParam().stride)
            << format << " stride " << stride << (fused ? " fused" : "");
      }
    }
  }
  EXPECT_EQ(checked, 24 * 3);
}

INSTANTIATE_TEST_SUITE_P(, Family, ::testing::ValuesIn(kFacts), test::by_name);

TEST(Families, TheListIsComplete) {
  ASSERT_EQ(family_names().size(), kFacts.size());
  for (std::size_t f = 0; f < kFacts.size(); ++f) EXPECT_EQ(family_names()[f], kFacts[f].name);
}

TEST(Families, UnknownNamesAreRefusedWithTheList) {
  const std::string list = "one of bspline, bernstein, hermite, catmull-rom, linear, constant";
  for (const bool oracle : {false, true}) {
    try {
      oracle ? static_cast<void>(Oracle::family("beta"))
             : static_cast<void>(family("beta", WordCodec("fp32")));
      FAIL();
    } catch (const UsageError& error) {
      EXPECT_EQ(error.what(), "unknown blending functions 'beta': " + list);
    }
  }
}

TEST(Families, DegreeOfAMatrixIsItsHighestPower) {
  std::array<std::array<double, 4>, 4> matrix{};
  EXPECT_EQ(user_blending(matrix).degree, 0);
  matrix[3][0] = 2;
  EXPECT_EQ(user_blending(matrix).degree, 0);
  for (int power = 1; power < 4; ++power) {
    matrix[power][power] = -0.25;
    EXPECT_EQ(user_blending(matrix).degree, power);
  }
}

// Coefficients below 2 whose intermediate values are not: c2 + c3 x reaches 3.8.
TEST(Families, TheShiftFitsIntermediateValuesToo) {
  const Blending blending = user_blending({{{-1.9, -1.9, 1.9, 1.9}, {}, {}, {}}});
  EXPECT_NEAR(horner_magnitude(blending), 3.8, 1e-12);
  for (const char* format : {"fx18", "fx32", "bfp32"}) {
    const WordCodec codec(format);
    AxisWords axis = encode(blending, codec);
    EXPECT_EQ(axis.shift, 1);
    const double unit = std::ldexp(1.0, -codec.weight_fraction());
    EXPECT_NEAR(weights(axis, format, codec.coordinate(1.0))[0], 0.0, 8 * unit);
  }
}

TEST(Families, PlainCoefficientsAreNotWatertightInBinary32) {
  const WordCodec codec("fp32");
  EXPECT_FALSE(is_watertight(encode(plain_bspline(), codec), "fp32"));
  EXPECT_FALSE(is_watertight(encode(plain_bspline(), codec), "fp32", 1, true));
}

TEST(Families, StridesBeyondTheSupportAreRefused) {
  const AxisWords axis;
  EXPECT_THROW(is_watertight(axis, "fx18", 0), UsageError);
  EXPECT_THROW(is_watertight(axis, "fx18", 4), UsageError);
  EXPECT_THROW(is_watertight(axis, "fx11", 1), UsageError);
}

/// A vertex on the face between two cells that lie `stride` points apart along an axis gets the
/// same bits from both, each with its own support.
TEST(Families, NeighboursAgreeOnTheirFaceAtTheStride) {
  std::mt19937_64 engine(1);
  int checked = 0;
  int differ = 0;
  for (const Facts& facts : kFacts) {
    if (facts.stride == 0) continue;
    for (const char* format : {"fp32", "fx18", "fx32", "bfp32"}) {
      const WordCodec codec(format);
      const auto model = model::make_evaluator_model(basic_row(format));
      load(*model, encode(family(facts.name, codec), codec));
      for (int v = 0; v < 500; ++v, ++checked) {
        const int axis = v % 3;
        const int step = 16 >> (2 * axis);
        model::VertexWords lower = random_vertex(codec, 0.5, engine).words;
        for (int& cell : lower.cell) cell &= 7;
        model::VertexWords upper = lower;
        lower.local[axis] = codec.coordinate(1);
        upper.local[axis] = codec.coordinate(0);
        upper.cell[axis] += facts.stride;
        for (int p = 0; p < 64; ++p) {
          const bool shared = p / step % 4 + facts.stride < 4;
          for (int c = 0; c < 3; ++c) {
            upper.points[3 * p + c] = shared ? lower.points[3 * (p + facts.stride * step) + c]
                                             : codec.point(unit(engine) - 0.5);
          }
        }
        differ += model->evaluate(0, lower).words != model->evaluate(0, upper).words ? 1 : 0;
      }
    }
  }
  EXPECT_EQ(checked, 5 * 4 * 500);
  EXPECT_EQ(differ, 0);
}

/// Limits set over what was measured: of a weight, of the sum of the four, of a component.
struct FamilyBound {
  const char* family;
  const char* format;
  double weight;     ///< times 2^-(W-2), or 2^-24
  double unity;      ///< the same; of families whose weights sum to 1
  double component;  ///< points in [-1/2, 1/2)
};

std::string test_name(const FamilyBound& bound) {
  return test::test_name(std::string(bound.family)) + "_" + bound.format;
}
void PrintTo(const FamilyBound& bound, std::ostream* out) { *out << test_name(bound); }

class FamilyAgainstOracle : public ::testing::TestWithParam<FamilyBound> {};

TEST_P(FamilyAgainstOracle, WeightsAndTheirSum) {
  constexpr int kSteps = 65536;
  const auto& [name, format, weight, unity, component] = GetParam();
  const WordCodec codec(format);
  const AxisWords axis = encode(family(name, codec), codec);
  const Oracle oracle(Oracle::family(name));
  const double unit = std::ldexp(1.0, codec.has_fixed_weights() ? -codec.weight_fraction() : -24);
  const bool sums_to_one = oracle.blending(Oracle::kS, 0.25).sum() == 1.0;
  double largest = 0;
  double off = 0;
  for (int i = 0; i <= kSteps; ++i) {
    // Every coordinate of fx18; in the other formats as many, anywhere, and both ends.
    const double even = static_cast<double>(i) / kSteps;
    const double anywhere = i == 0 || i == kSteps ? even : std::fmod(0.6180339887498949 * i, 1.0);
    const std::uint32_t word = codec.coordinate(std::string(format) == "fx18" ? even : anywhere);
    const double x = codec.decode_coordinate(word);
    const auto w = weights(axis, format, word);
    const Eigen::Vector4d exact = oracle.blending(Oracle::kS, x);
    for (int l = 0; l < 4; ++l) largest = std::max(largest, std::abs(w[l] - exact[l]) / unit);
    off = std::max(off, std::abs(w[0] + w[1] + w[2] + w[3] - 1) / unit);
  }
  std::printf("%s %s: weight off by %.2f units, sum by %.2f\n", name, format, largest, off);
  EXPECT_LE(largest, weight);
  EXPECT_GE(2 * largest, weight) << "the bound says nothing";
  EXPECT_TRUE(!sums_to_one || off <= unity) << off;
}

TEST_P(FamilyAgainstOracle, Components) {
  constexpr int kVertices = 20000;
  const auto& [name, format, weight, unity, component] = GetParam();
  const WordCodec codec(format);
  const auto model = model::make_evaluator_model(basic_row(format));
  load(*model, encode(family(name, codec), codec));
  const double largest = largest_error(*model, codec, Oracle(Oracle::family(name)), 0.5, kVertices);
  std::printf("%s %s: component off by %.3g, bound %.3g\n", name, format, largest, component);
  EXPECT_LE(largest, component);
  EXPECT_GE(3 * largest, component) << "the bound says nothing";
}

INSTANTIATE_TEST_SUITE_P(, FamilyAgainstOracle,
                         ::testing::Values(FamilyBound{"bspline", "fp32", 2, 2.5, 2.5e-7},
                                           FamilyBound{"bspline", "fx18", 2, 2, 6.5e-5},
                                           FamilyBound{"bspline", "fx32", 2, 2, 4.2e-9},
                                           FamilyBound{"bernstein", "fp32", 4.5, 6, 2.5e-7},
                                           FamilyBound{"bernstein", "fx18", 7, 16, 1.4e-4},
                                           FamilyBound{"bernstein", "fx32", 8, 16, 7e-9},
                                           FamilyBound{"hermite", "fp32", 2, 0, 3.7e-7},
                                           FamilyBound{"hermite", "fx18", 3.5, 0, 9e-5},
                                           FamilyBound{"hermite", "fx32", 4, 0, 5.4e-9},
                                           FamilyBound{"catmull-rom", "fp32", 3.2, 3.5, 5e-7},
                                           FamilyBound{"catmull-rom", "fx18", 3.5, 8, 9e-5},
                                           FamilyBound{"catmull-rom", "fx32", 3.5, 8, 7e-9},
                                           FamilyBound{"linear", "fp32", 0.6, 0.6, 1.3e-7},
                                           FamilyBound{"linear", "fx18", 0, 0, 3.1e-5},
                                           FamilyBound{"linear", "fx32", 0.6, 0, 2.5e-9}),
                         [](const auto& info) { return test_name(info.param); });

}  // namespace
}  // namespace hwffd
