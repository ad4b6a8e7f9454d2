#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <string>

#include "hwffd/bounds/axis_error.hpp"
#include "hwffd/model/org_powers.hpp"
#include "hwffd/numerics/binary32.hpp"
#include "hwffd/numerics/block.hpp"
#include "hwffd/numerics/fixed.hpp"

namespace hwffd::certified {

using Four = std::array<double, 4>;

/// An axis at one coordinate: what is computed there and what eq. (1) has.
struct AxisPoint {
  std::uint32_t word = 0;  ///< the coordinate as given
  double x = 0;
  Four weight{};
  Four exact{};

  Four error() const {
    Four e{};
    for (int l = 0; l < 4; ++l) e[l] = weight[l] - exact[l];
    return e;
  }
};

inline double norm(const Four& values) {
  return std::abs(values[0]) + std::abs(values[1]) + std::abs(values[2]) + std::abs(values[3]);
}

/// What a format's coordinates are, and numbers of weights as doubles: exact for all of them.
template <class F>
struct Coordinates;

/// Fixed point: a word of 31 bits behind the point is rounded half up, so that two words, half a
/// unit below the number and just not half a unit above it, are the ends of those that it stands
/// for.
template <int W>
struct Coordinates<Fixed<W>> {
  static constexpr double kUnit = 1.0 / static_cast<double>(std::int64_t{1} << (W - 2));
  static constexpr int kEnds = 2;
  /// Between the ends functions are lines but for this much of their sum.
  static constexpr double kBend = 3 * (kUnit / 2) * (kUnit / 2);
  static constexpr std::int64_t kFirst = 0;
  static constexpr std::int64_t kLast = std::int64_t{1} << (W - 2);

  static std::uint32_t word(std::int64_t k, int end) {
    constexpr int kPad = 33 - W;
    const std::int64_t half = std::int64_t{1} << (kPad - 1);
    const std::int64_t at = (k << kPad) + (end == 0 ? -half : half - 1);
    return static_cast<std::uint32_t>(std::clamp<std::int64_t>(at, 0, 0x80000000));
  }
  static double value(std::uint32_t word) { return std::ldexp(word, -31); }
  static double number(const typename Fixed<W>::Weight& w) {
    return static_cast<double>(w.value) * kUnit;
  }
};

/// Words of binary32 in [0, 1], from 2^-40 on: below, what is computed is the same as at 0 but for
/// 2^-39 at most.
struct FloatCoordinates {
  static constexpr int kEnds = 1;
  static constexpr double kBend = 0x1p-39;
  static constexpr std::int64_t kFirst = 0x2B800000;
  static constexpr std::int64_t kLast = 0x3F800000;

  static std::uint32_t word(std::int64_t k, int /*end*/) { return static_cast<std::uint32_t>(k); }
  static double value(std::uint32_t word) { return float_of_bits(word); }
};

template <>
struct Coordinates<Block32> : FloatCoordinates {
  static constexpr double kUnit = 0x1p-33;
  static double number(const Block32::Weight& w) { return static_cast<double>(w.value) * kUnit; }
};
template <>
struct Coordinates<Binary32> : FloatCoordinates {
  static constexpr double kUnit = 0x1p-24;
  static double number(float w) { return w; }
};
template <>
struct Coordinates<Binary32Fused> : Coordinates<Binary32> {};

/// Where weights come from: Horner's rule over coefficients that are loaded. `kSum` is what the
/// four weights of an axis sum to.
template <class F>
class Horner {
 public:
  static constexpr double kSum = 1;
  Horner(const std::string& name, const std::string& format) : is_bspline_(name == "bspline") {
    const Blending blending = family(name, WordCodec(format));
    coefficient_ = blending.coefficient;
    const AxisWords axis = encode(blending, WordCodec(format));
    for (int l = 0; l < 4; ++l) bank_.load(0, l, axis.degree, axis.shift, axis.word[l]);
  }
  Four operator()(typename F::Weight x) const {
    Four weights{};
    for (int l = 0; l < 4; ++l) {
      weights[l] = Coordinates<F>::number(model::polynomial<F>(bank_, 0, l, x));
    }
    return weights;
  }
  /// Of the family, whose one sixth is not rounded.
  Four exact(double x) const {
    if (is_bspline_) return bounds::bspline(x);
    Four values{};
    for (int l = 0; l < 4; ++l) {
      const auto& c = coefficient_[l];
      values[l] = c[0] + x * (c[1] + x * (c[2] + x * c[3]));
    }
    return values;
  }
  const model::CoefficientBank<F>& bank() const { return bank_; }

 private:
  bool is_bspline_;
  Blending::Matrix coefficient_{};
  model::CoefficientBank<F> bank_;
};

template <class F>
Four numbers(const std::array<typename F::Weight, 4>& computed) {
  Four weights{};
  for (int l = 0; l < 4; ++l) weights[l] = Coordinates<F>::number(computed[l]);
  return weights;
}

template <class F>
struct Powers {
  static constexpr double kSum = 1;
  Four operator()(typename F::Weight x) const {
    return numbers<F>(model::PowersBspline<F>::weights(x));
  }
  static Four exact(double x) { return bounds::bspline(x); }
};

/// Half the derivatives of B-splines, which fixed point has for them.
inline Four half_slopes(double x) {
  Four slopes = bounds::bspline_slope(x);
  for (double& slope : slopes) slope /= 2;
  return slopes;
}

/// The weights of a derivative by Horner's rule, in fixed point.
template <class F>
class Slopes {
 public:
  static constexpr double kSum = 0;
  explicit Slopes(const std::string& format) : bank_(bounds::bspline_bank<F>(format.c_str())) {}
  Four operator()(typename F::Weight x) const {
    Four weights{};
    for (int l = 0; l < 4; ++l) {
      weights[l] = Coordinates<F>::number(model::polynomial<F>(bank_, 0, l, x, true));
    }
    return weights;
  }
  static Four exact(double x) { return half_slopes(x); }

 private:
  model::CoefficientBank<F> bank_;
};

/// The same of the evaluator `powers`.
template <class F>
struct PowersSlopes {
  static constexpr double kSum = 0;
  Four operator()(typename F::Weight x) const {
    return numbers<F>(model::PowersBspline<F>::slopes(x));
  }
  static Four exact(double x) { return half_slopes(x); }
};

/// `affine` gives one function what the others leave of the sum; which, depends on the cell.
inline Four completed(Four weights, int left, double sum) {
  weights[left] = 0;
  weights[left] = sum - (weights[0] + weights[1] + weights[2] + weights[3]);
  return weights;
}

template <class F, class Weights>
AxisPoint axis_point(const Weights& weights, std::uint32_t word) {
  const double x = Coordinates<F>::value(word);
  return {word, x, weights(F::coordinate(word)), weights.exact(x)};
}

}  // namespace hwffd::certified
