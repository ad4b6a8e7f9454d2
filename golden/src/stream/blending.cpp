#include "hwffd/stream/blending.hpp"

#include <algorithm>
#include <cmath>
#include <map>

#include "hwffd/error.hpp"

namespace hwffd {
namespace {

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

}  // namespace

const std::vector<std::string>& family_names() {
  static const std::vector<std::string> names{"bspline",     "bernstein", "hermite",
                                              "catmull-rom", "linear",    "constant"};
  return names;
}

Blending family(const std::string& name, const WordCodec& codec) {
  if (name == "bspline") return watertight_bspline(codec);
  static const std::map<std::string, Blending> exact{
      {"bernstein", {{{{1, -3, 3, -1}, {0, 3, -6, 3}, {0, 0, 3, -3}, {0, 0, 0, 1}}}, 3}},
      {"hermite", {{{{1, 0, -3, 2}, {0, 1, -2, 1}, {0, 0, 3, -2}, {0, 0, -1, 1}}}, 3}},
      {"catmull-rom",
       {{{{0, -0.5, 1, -0.5}, {1, 0, -2.5, 1.5}, {0, 0.5, 2, -1.5}, {0, 0, -0.5, 0.5}}}, 3}},
      {"linear", {{{{0, 0, 0, 0}, {1, -1, 0, 0}, {0, 1, 0, 0}, {0, 0, 0, 0}}}, 1}},
      {"constant", {{{{1, 0, 0, 0}, {0, 0, 0, 0}, {0, 0, 0, 0}, {0, 0, 0, 0}}}, 0}},
  };
  const auto found = exact.find(name);
  if (found != exact.end()) return found->second;
  std::string names;
  for (const std::string& known : family_names()) names += (names.empty() ? "" : ", ") + known;
  throw UsageError("unknown blending functions '" + name + "': one of " + names);
}

Blending user_blending(const std::array<std::array<double, 4>, 4>& matrix) {
  Blending blending{matrix, 0};
  for (const auto& function : matrix) {
    for (int power = 1; power < 4; ++power) {
      if (function[power] != 0) blending.degree = std::max(blending.degree, power);
    }
  }
  return blending;
}

Blending watertight_bspline(const WordCodec& codec) {
  const int fraction = codec.is_float() ? 24 : codec.weight_fraction();
  const double a = std::ldexp(std::nearbyint(std::ldexp(1.0 / 6.0, fraction)), -fraction);
  return {{{{a, -0.5, 0.5, -a}, {1 - 2 * a, 0, -1, 3 * a}, {a, 0.5, 0.5, -3 * a}, {0, 0, 0, a}}},
          3};
}

Blending plain_bspline() {
  return {{{{1 / 6.0, -3 / 6.0, 3 / 6.0, -1 / 6.0},
            {4 / 6.0, 0, -6 / 6.0, 3 / 6.0},
            {1 / 6.0, 3 / 6.0, 3 / 6.0, -3 / 6.0},
            {0, 0, 0, 1 / 6.0}}},
          3};
}

double horner_magnitude(const Blending& blending) {
  double largest = 0;
  for (auto c : blending.coefficient) {
    for (int power = blending.degree + 1; power < 4; ++power) c[power] = 0;
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

AxisWords encode(const Blending& blending, const WordCodec& codec) {
  AxisWords axis;
  axis.degree = blending.degree;
  const double largest = horner_magnitude(blending);
  while (!codec.is_float() && std::ldexp(largest, -axis.shift) >= 2 && axis.shift < 3) ++axis.shift;
  for (int function = 0; function < 4; ++function) {
    for (int power = 0; power < 4; ++power) {
      axis.word[function][power] =
          codec.coefficient(blending.coefficient[function][power], axis.shift);
    }
  }
  return axis;
}

std::vector<Beat> coefficients_packet(const Blending& blending, const WordCodec& codec) {
  return coefficients_packet(std::array<Blending, 3>{blending, blending, blending}, codec);
}

std::vector<Beat> coefficients_packet(const std::array<Blending, 3>& axes, const WordCodec& codec) {
  return coefficients_packet(std::array<AxisWords, 3>{
      encode(axes[0], codec), encode(axes[1], codec), encode(axes[2], codec)});
}

}  // namespace hwffd
