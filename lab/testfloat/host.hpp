#pragma once

#include <array>
#include <cstdint>

namespace hwffd::testfloat {

enum class Operation { kAdd, kMul, kFma };

/// What the host's binary32 makes of the operands, as the units give it: one NaN, one zero. In the
/// host's present rounding direction.
std::uint32_t host(Operation operation, const std::array<std::uint32_t, 3>& words);

/// Has the host round towards zero while it lives: a reference that is wrong by purpose.
class TowardsZero {
 public:
  TowardsZero();
  ~TowardsZero();
  TowardsZero(const TowardsZero&) = delete;
  TowardsZero& operator=(const TowardsZero&) = delete;
};

}  // namespace hwffd::testfloat
