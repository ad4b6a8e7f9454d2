// Weights of an axis in the bit-true model's arithmetic, for any format.
#include <cmath>
#include <utility>

#include "hwffd/error.hpp"
#include "hwffd/model/coefficients.hpp"
#include "hwffd/numerics/binary32.hpp"
#include "hwffd/numerics/block.hpp"
#include "hwffd/numerics/fixed.hpp"
#include "hwffd/stream/blending.hpp"
#include "hwffd/stream/spans.hpp"

namespace hwffd {
namespace {

constexpr int kNarrowest = 12;
constexpr int kWidest = 32;

double decoded(float weight, int /*fraction*/) { return weight; }

template <class Number>
double decoded(Number weight, int fraction) {
  return std::ldexp(static_cast<double>(weight.value), -fraction);
}

template <class F>
std::array<double, 4> weights_in(const AxisWords& axis, std::uint32_t coordinate, int fraction) {
  model::CoefficientBank<F> bank;
  std::array<double, 4> weights{};
  for (int l = 0; l < 4; ++l) {
    bank.load(0, l, axis.degree, axis.shift, axis.word[l]);
    weights[l] = decoded(model::polynomial<F>(bank, 0, l, F::coordinate(coordinate)), fraction);
  }
  return weights;
}

using WeightsIn = std::array<double, 4> (*)(const AxisWords&, std::uint32_t, int);

template <int... Width>
WeightsIn fixed_weights(int width, std::integer_sequence<int, Width...> /*widths*/) {
  static constexpr WeightsIn kTable[] = {weights_in<Fixed<kNarrowest + Width>>...};
  return kTable[width - kNarrowest];
}

}  // namespace

std::array<double, 4> weights(const AxisWords& axis, const std::string& format,
                              std::uint32_t coordinate, bool fused) {
  const WordCodec codec(format);
  if (!codec.has_fixed_weights()) {
    return fused ? weights_in<Binary32Fused>(axis, coordinate, 0)
                 : weights_in<Binary32>(axis, coordinate, 0);
  }
  if (codec.is_block()) return weights_in<Block32>(axis, coordinate, Block32::kWeightFraction);
  const int fraction = codec.weight_fraction();
  const auto widths = std::make_integer_sequence<int, kWidest - kNarrowest + 1>();
  return fixed_weights(fraction + 2, widths)(axis, coordinate, fraction);
}

bool is_watertight(const AxisWords& axis, const std::string& format, int stride, bool fused) {
  if (stride < 1 || stride > 3) {
    throw UsageError("stride " + std::to_string(stride) + " between cells: 1 to 3");
  }
  return is_watertight(axis, axis, format, stride, fused);
}

bool is_watertight(const AxisWords& lower, const AxisWords& upper, const std::string& format,
                   int stride, bool fused) {
  const WordCodec codec(format);
  const auto end = weights(lower, format, codec.coordinate(1.0), fused);
  const auto begin = weights(upper, format, codec.coordinate(0.0), fused);
  for (int l = 0; l < 4; ++l) {
    if (l < stride && end[l] != 0) return false;
    const bool shared = l + stride < 4;
    if (begin[l] != (shared ? end[l + stride] : 0.0)) return false;
  }
  return true;
}

}  // namespace hwffd
