// The model of `nested`: the coefficients of a cell against exact arithmetic, its error against the
// oracle for other functions than the B-spline, its seams.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <random>
#include <string>

#include "hwffd/model/org_nested.hpp"
#include "hwffd/numerics/binary32.hpp"
#include "hwffd/numerics/fixed.hpp"
#include "hwffd/oracle/oracle.hpp"
#include "hwffd/stream/blending.hpp"
#include "named.hpp"

namespace hwffd {
namespace {

/// The coefficient of (2x - 1)^k in a blending function, by expanding ((1 + y) / 2)^j term by term.
double about_centre(const std::array<double, 4>& function, int k) {
  double sum = 0;
  for (int j = k; j < 4; ++j) {
    double ways = 1;
    for (int i = 0; i < k; ++i) ways *= static_cast<double>(j - i) / (i + 1);
    sum += function[j] * ways / (1 << j);
  }
  return sum;
}

struct Case {
  std::string name() const { return std::string(family) + "_" + format; }

  const char* family;
  const char* format;
};
inline void PrintTo(const Case& tried, std::ostream* out) { *out << tried.name(); }

/// What a family's cell coefficients should be, and what the model forms.
template <class F>
class Former {
 public:
  Former(const std::string& name, const WordCodec& codec) : blending_(family(name, codec)) {
    const AxisWords axis = encode(blending_, codec);
    for (int a = 0; a < 3; ++a) {
      for (int l = 0; l < 4; ++l) bank_.load(a, l, axis.degree, axis.shift, axis.word[l]);
    }
  }

  using Points = std::array<std::array<double, 3>, 64>;

  static typename F::Point point(double value, const WordCodec& codec) {
    return F::point(codec.point(value));
  }
  model::Support<F> support(const Points& points, const WordCodec& codec) const {
    model::Support<F> support;
    for (int p = 0; p < 64; ++p) {
      for (int c = 0; c < 3; ++c) support[p][c] = point(points[p][c], codec);
    }
    return support;
  }
  typename model::OrgNested<F>::CellCoefficients form(const std::array<int, 3>& cell,
                                                      const model::Support<F>& support) const {
    return model::OrgNested<F>::form(cell, support, bank_);
  }
  /// The sum over all 64 points, in double: exact where everything is a multiple of 2^-20 or so.
  double exact(const Points& points, int power, int component) const {
    double sum = 0;
    for (int p = 0; p < 64; ++p) {
      sum += points[p][component] * about_centre(blending_.coefficient[p >> 4], power >> 4) *
             about_centre(blending_.coefficient[p >> 2 & 3], power >> 2 & 3) *
             about_centre(blending_.coefficient[p & 3], power & 3);
    }
    return sum;
  }
  /// Points that make one coefficient as large as it can be.
  Points largest_at(int power) const {
    Points points;
    for (int p = 0; p < 64; ++p) {
      Points unit{};
      unit[p].fill(1);
      points[p].fill(exact(unit, power, 0) < 0 ? -1 : 0.875);
    }
    return points;
  }

 private:
  Blending blending_;
  model::CoefficientBank<F> bank_;
};

double value_of(float value, int /*halvings*/) { return value; }
double value_of(const Fixed<18>::Number& number, int halvings) {
  return std::ldexp(static_cast<double>(number.value), halvings - 17);
}
double value_of(const Fixed<32>::Number& number, int halvings) {
  return std::ldexp(static_cast<double>(number.value), halvings - 31);
}
bool flag_of(float /*value*/) { return false; }
template <class Number>
bool flag_of(const Number& number) {
  return number.saturated;
}

template <class F>
void expect_exact(const Case& tried) {
  const WordCodec codec(tried.format);
  const Former<F> former(tried.family, codec);
  std::mt19937_64 engine(1);
  int compared = 0;
  int saturated = 0;
  for (int n = 0; n < 200; ++n) {
    typename Former<F>::Points points = former.largest_at(21);
    for (auto& point : points) {
      // Multiples of 1/8, many of them as large as can be.
      if (n == 0) break;
      for (double& x : point) x = std::clamp(static_cast<double>(engine() % 25) - 12, -8., 7.) / 8;
    }
    const std::array<int, 3> cell = {static_cast<int>(engine() % 16),
                                     static_cast<int>(engine() % 16),
                                     static_cast<int>(engine() % 16)};
    const auto formed = former.form(cell, former.support(points, codec));
    const double limit = codec.is_float() ? INFINITY : 1 << formed.halvings;
    for (int power = 0; power < 64; ++power) {
      for (int c = 0; c < 3; ++c, ++compared) {
        const double exact = former.exact(points, power, c);
        const bool outside = exact >= limit || exact < -limit;
        saturated += outside ? 1 : 0;
        ASSERT_EQ(flag_of(formed.vector[power][c]), outside) << power << ": " << exact;
        if (!outside) {
          ASSERT_EQ(value_of(formed.vector[power][c], formed.halvings), exact) << "power " << power;
        }
      }
    }
  }
  EXPECT_EQ(compared, 200 * 192);
  // 1.75 an axis, times 7/8.
  EXPECT_EQ(saturated > 0, std::string(tried.family) == "hermite" && !codec.is_float());
  std::printf("%d coefficients, %d saturated\n", compared, saturated);
}

class NestedForms : public ::testing::TestWithParam<Case> {};

// Functions whose coefficients are binary fractions, points in eighths: nothing is rounded, so
// every coefficient is the exact one.
TEST_P(NestedForms, ExactlyWhereNothingIsRounded) {
  const std::string format = GetParam().format;
  if (format == "fp32") {
    expect_exact<Binary32>(GetParam());
  } else if (format == "fx18") {
    expect_exact<Fixed<18>>(GetParam());
  } else {
    expect_exact<Fixed<32>>(GetParam());
  }
}

std::vector<Case> cases() {
  std::vector<Case> all;
  for (const char* format : {"fp32", "fx18", "fx32"}) {
    for (const char* name : {"bernstein", "hermite", "catmull-rom", "linear", "constant"}) {
      all.push_back({name, format});
    }
  }
  return all;
}

INSTANTIATE_TEST_SUITE_P(, NestedForms, ::testing::ValuesIn(cases()), test::by_name);

// The B-spline's sixth is rounded, so its coefficients are: half a unit of a weight in each entry
// of three matrices, of a point in each of three sums; nothing is halved.
TEST(NestedForm, BsplineWithinItsRoundings) {
  const WordCodec codec("fx18");
  const Former<Fixed<18>> former("bspline", codec);
  const double half = 0x1p-17;
  const double bound = 3 * 4 * half + 3 * half / 2;
  std::mt19937_64 engine(2);
  double largest = 0;
  for (int n = 0; n < 300; ++n) {
    Former<Fixed<18>>::Points points;
    for (auto& point : points) {
      for (double& x : point) x = std::ldexp(static_cast<double>(engine() % 262144), -17) - 1;
    }
    const auto formed = former.form({n % 16, 1, 2}, former.support(points, codec));
    ASSERT_EQ(formed.halvings, 0);
    for (int power = 0; power < 64; ++power) {
      for (int c = 0; c < 3; ++c) {
        const double error =
            std::abs(value_of(formed.vector[power][c], 0) - former.exact(points, power, c));
        largest = std::max(largest, error);
      }
    }
  }
  std::printf("largest error %.3g, bound %.3g\n", largest, bound);
  EXPECT_LE(largest, bound);
  EXPECT_GE(8 * largest, bound);
}

}  // namespace
}  // namespace hwffd
