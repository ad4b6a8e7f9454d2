#include "hwffd/stream/blending.hpp"

#include <algorithm>
#include <cmath>

namespace hwffd {

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

AxisWords encode(const Blending& blending, const WordCodec& codec) {
  AxisWords axis;
  axis.degree = blending.degree;
  double largest = 0;
  for (const auto& function : blending.coefficient) {
    for (const double c : function) largest = std::max(largest, std::abs(c));
  }
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
  const AxisWords axis = encode(blending, codec);
  return coefficients_packet(std::array<AxisWords, 3>{axis, axis, axis});
}

}  // namespace hwffd
