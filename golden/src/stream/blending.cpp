#include "hwffd/stream/blending.hpp"

#include <algorithm>
#include <cmath>
#include <map>

#include "hwffd/error.hpp"

namespace hwffd {
namespace {

/// Of the true B-spline: exact in binary.
constexpr Blending::Matrix kBsplineDerivative{
    {{-0.5, 1, -0.5, 0}, {0, -2, 1.5, 0}, {0.5, 1, -1.5, 0}, {0, 0, 0.5, 0}}};

/// Points where a + b x + c x^2 may be extreme on [0, 1].
std::vector<double> candidates(double b, double c) {
  std::vector<double> at{0, 1};
  if (c != 0) at.push_back(std::clamp(-b / (2 * c), 0.0, 1.0));
  return at;
}

/// The same for a + b x + c x^2 + d x^3: the roots of b + 2 c x + 3 d x^2.
std::vector<double> candidates(double b, double c, double d) {
  std::vector<double> at = candidates(b, c);
  const double discriminant = c * c - 3 * b * d;
  if (d != 0 && discriminant >= 0) {
    for (const double sign : {-1.0, 1.0}) {
      at.push_back(std::clamp((-c + sign * std::sqrt(discriminant)) / (3 * d), 0.0, 1.0));
    }
  }
  return at;
}

double horner_magnitude(const Blending::Matrix& coefficient, int degree) {
  double largest = 0;
  for (auto c : coefficient) {
    for (int power = degree + 1; power < 4; ++power) c[power] = 0;
    for (const double coefficient : c) largest = std::max(largest, std::abs(coefficient));
    largest = std::max(largest, std::abs(c[2] + c[3]));
    for (const double x : candidates(c[2], c[3])) {
      largest = std::max(largest, std::abs(c[1] + x * (c[2] + x * c[3])));
    }
    for (const double x : candidates(c[1], c[2], c[3])) {
      largest = std::max(largest, std::abs(c[0] + x * (c[1] + x * (c[2] + x * c[3]))));
    }
  }
  return largest;
}

/// The smallest shift, 0 to 3, that brings a magnitude below 2.
int shift_for(double largest) {
  int shift = 0;
  while (std::ldexp(largest, -shift) >= 2 && shift < 3) ++shift;
  return shift;
}

/// Coefficients times 2^-shift.
std::array<std::array<std::uint32_t, 4>, 4> words_of(const Blending::Matrix& coefficient, int shift,
                                                     const WordCodec& codec) {
  std::array<std::array<std::uint32_t, 4>, 4> words{};
  for (int function = 0; function < 4; ++function) {
    for (int power = 0; power < 4; ++power) {
      words[function][power] = codec.coefficient(coefficient[function][power], shift);
    }
  }
  return words;
}

}  // namespace

const std::vector<std::string>& family_names() {
  static const std::vector<std::string> names{"bspline",     "bernstein", "hermite",
                                              "catmull-rom", "linear",    "constant"};
  return names;
}

Blending family(const std::string& name, const WordCodec& codec) {
  if (name == "bspline") return watertight_bspline(codec);
  static const std::map<std::string, Blending::Matrix> exact{
      {"bernstein", {{{1, -3, 3, -1}, {0, 3, -6, 3}, {0, 0, 3, -3}, {0, 0, 0, 1}}}},
      {"hermite", {{{1, 0, -3, 2}, {0, 1, -2, 1}, {0, 0, 3, -2}, {0, 0, -1, 1}}}},
      {"catmull-rom",
       {{{0, -0.5, 1, -0.5}, {1, 0, -2.5, 1.5}, {0, 0.5, 2, -1.5}, {0, 0, -0.5, 0.5}}}},
      {"linear", {{{0, 0, 0, 0}, {1, -1, 0, 0}, {0, 1, 0, 0}, {0, 0, 0, 0}}}},
      {"constant", {{{1, 0, 0, 0}, {0, 0, 0, 0}, {0, 0, 0, 0}, {0, 0, 0, 0}}}},
  };
  const auto it = exact.find(name);
  if (it != exact.end()) return user_blending(it->second);
  std::string names;
  for (const std::string& known : family_names()) names += (names.empty() ? "" : ", ") + known;
  throw UsageError("unknown blending functions '" + name + "': one of " + names);
}

Blending::Matrix differentiated(const Blending::Matrix& coefficient) {
  Blending::Matrix derivative{};
  for (int function = 0; function < 4; ++function) {
    for (int power = 1; power < 4; ++power) {
      derivative[function][power - 1] = power * coefficient[function][power];
    }
  }
  return derivative;
}

Blending user_blending(const Blending::Matrix& matrix) {
  Blending blending{matrix, 0, differentiated(matrix)};
  for (const auto& function : matrix) {
    for (int power = 1; power < 4; ++power) {
      if (function[power] != 0) blending.degree = std::max(blending.degree, power);
    }
  }
  return blending;
}

Blending watertight_bspline(const WordCodec& codec) {
  const int fraction = codec.has_fixed_weights() ? codec.weight_fraction() : 24;
  const double a = std::ldexp(std::nearbyint(std::ldexp(1.0 / 6.0, fraction)), -fraction);
  return {{{{a, -0.5, 0.5, -a}, {1 - 2 * a, 0, -1, 3 * a}, {a, 0.5, 0.5, -3 * a}, {0, 0, 0, a}}},
          3,
          kBsplineDerivative};
}

Blending plain_bspline() {
  return {{{{1 / 6.0, -3 / 6.0, 3 / 6.0, -1 / 6.0},
            {4 / 6.0, 0, -6 / 6.0, 3 / 6.0},
            {1 / 6.0, 3 / 6.0, 3 / 6.0, -3 / 6.0},
            {0, 0, 0, 1 / 6.0}}},
          3,
          kBsplineDerivative};
}

double horner_magnitude(const Blending& blending) {
  return horner_magnitude(blending.coefficient, blending.degree);
}

int derivative_exponent(const Blending& blending) {
  // The sum of magnitudes is the largest of the sums with signs, each a parabola.
  double largest = 0;
  for (unsigned signs = 0; signs < 16; ++signs) {
    std::array<double, 3> sum{};
    for (unsigned function = 0; function < 4; ++function) {
      const double sign = (signs >> function & 1) != 0 ? -1 : 1;
      for (int power = 0; power < 3; ++power) {
        sum[power] += sign * blending.derivative[function][power];
      }
    }
    for (const double x : candidates(sum[1], sum[2])) {
      largest = std::max(largest, sum[0] + x * (sum[1] + x * sum[2]));
    }
  }
  int exponent = 0;
  const double fraction = std::frexp(largest, &exponent);  // in [1/2, 1)
  return std::max(0, fraction > 0.5 ? exponent : exponent - 1);
}

AxisWords encode(const Blending& blending, const WordCodec& codec) {
  return encode(blending, codec, derivative_exponent(blending));
}

AxisWords encode(const Blending& blending, const WordCodec& codec, int exponent) {
  AxisWords axis;
  axis.degree = blending.degree;
  DerivativeWords& derivative = axis.derivative;
  if (codec.has_fixed_weights()) {
    derivative.exponent = exponent;
    axis.shift = shift_for(horner_magnitude(blending));
    derivative.shift = shift_for(
        std::ldexp(horner_magnitude(blending.derivative, blending.degree), -derivative.exponent));
  }
  axis.word = words_of(blending.coefficient, axis.shift, codec);
  derivative.word = words_of(blending.derivative, derivative.shift + derivative.exponent, codec);
  return axis;
}

std::vector<Beat> coefficients_packet(const Blending& blending, const WordCodec& codec,
                                      Functions functions) {
  return coefficients_packet(std::array<Blending, 3>{blending, blending, blending}, codec,
                             functions);
}

std::vector<Beat> coefficients_packet(const std::array<Blending, 3>& axes, const WordCodec& codec,
                                      Functions functions) {
  return coefficients_packet(
      std::array<AxisWords, 3>{encode(axes[0], codec), encode(axes[1], codec),
                               encode(axes[2], codec)},
      functions);
}

}  // namespace hwffd
