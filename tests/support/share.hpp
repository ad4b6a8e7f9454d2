#pragma once

#include <algorithm>
#include <cstdint>
#include <stdexcept>

#include "hwffd/tb/random.hpp"

namespace hwffd::test {

/// That share of a test's seeds, vertices or values, at least 1, which the environment variable
/// HWFFD_TEST_SHARE asks for: 4 is a quarter. Without it all of them.
inline std::uint64_t share_of(std::uint64_t count) {
  const std::uint64_t divisor = tb::seed_from_environment(1, "HWFFD_TEST_SHARE");
  if (divisor == 0) throw std::invalid_argument("HWFFD_TEST_SHARE: a number from 1 up is wanted");
  return std::max<std::uint64_t>(1, count / divisor);
}

}  // namespace hwffd::test
