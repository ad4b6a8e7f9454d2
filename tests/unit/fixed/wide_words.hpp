#pragma once

#include <verilated.h>

#include <type_traits>

#include "hwffd/numerics/fixed.hpp"
#include "hwffd/tb/random.hpp"

namespace hwffd::test {

/// A port of any width as a 128-bit integer.
template <class Port>
void drive(Port& port, Int128 bits) {
  if constexpr (std::is_integral_v<Port>) {
    port = static_cast<Port>(bits);
  } else {
    for (int word = 0; word < 3; ++word) port[word] = static_cast<EData>(bits >> (32 * word));
  }
}

template <class Port>
Int128 read(const Port& port) {
  if constexpr (std::is_integral_v<Port>) {
    return port;
  } else {
    return Int128{port[0]} | Int128{port[1]} << 32 | Int128{port[2]} << 64;
  }
}

/// A signed word of `width` bits: an end of the range, a power of two or its neighbour, or random.
inline Int128 corner_or_random(tb::Random& random, int width) {
  const Int128 top = (Int128{1} << (width - 1)) - 1;
  const Int128 power = Int128{1} << random.below(static_cast<std::uint64_t>(width) - 1);
  switch (random.below(8)) {
    case 0:
      return random.pick({top, -top - 1, top - 1, -top});
    case 1:
      return power;
    case 2:
      return -power;
    case 3:
      return power - 1;
    default: {
      const Int128 bits = Int128{random.bits()} << 64 | random.bits();
      return bits >> (128 - width);  // sign extended
    }
  }
}

}  // namespace hwffd::test
