// Compiled with -frounding-math, so that nothing is computed before the direction is set.
#include "host.hpp"

#include <cfenv>
#include <cmath>

#include "hwffd/numerics/bits.hpp"

namespace hwffd::testfloat {

std::uint32_t host(Operation operation, const std::array<std::uint32_t, 3>& words) {
  const float a = float_of_bits(words[0]);
  const float b = float_of_bits(words[1]);
  const float c = float_of_bits(words[2]);
  const float result = operation == Operation::kAdd   ? a + b
                       : operation == Operation::kMul ? a * b
                                                      : std::fma(a, b, c);
  if (std::isnan(result)) return 0x7fc00000u;
  return result == 0 ? 0 : bits_of_float(result);
}

TowardsZero::TowardsZero() { std::fesetround(FE_TOWARDZERO); }
TowardsZero::~TowardsZero() { std::fesetround(FE_TONEAREST); }

}  // namespace hwffd::testfloat
