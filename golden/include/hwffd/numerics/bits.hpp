#pragma once

#include <cstdint>
#include <cstring>

namespace hwffd {

/// The float with these bits, NaN payloads included.
inline float float_of_bits(std::uint32_t bits) {
  float value = 0;
  std::memcpy(&value, &bits, sizeof value);
  return value;
}

/// The bits of a float, NaN payloads included.
inline std::uint32_t bits_of_float(float value) {
  std::uint32_t bits = 0;
  std::memcpy(&bits, &value, sizeof bits);
  return bits;
}

}  // namespace hwffd
